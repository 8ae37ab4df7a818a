# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The exact axis-aligned bounding boxes of a robot's links, proven distances, and proofs.

Robot       a robot of a URDF: its boxes and distances in any pose; help(link_bounds.Robot)
Reach       a box that a link never leaves, from Robot.reach()
Pair        what is proven of two links, from Robot.pairs()
Segment     what is proven of the motion between two way points, from Robot.check_path()
RobotError  a URDF or a mesh that cannot be used
BOX, HULL, MESH  what decided a distance

link_bounds.msg and link_bounds.srv are the messages of the node.
"""

__all__ = ['BOX', 'HULL', 'MESH', 'Pair', 'Reach', 'Robot', 'RobotError', 'Segment']


def __getattr__(name):
    """Loads the library when it is first used, because messages need neither it nor NumPy."""
    if name not in __all__:
        raise AttributeError('module %r has no attribute %r' % (__name__, name))
    import importlib
    try:
        robot = importlib.import_module(__name__ + '._robot')
    except ModuleNotFoundError as error:
        if error.name != __name__ + '._robot':
            raise
        raise ImportError(
            'link_bounds.%s is not there, because link_bounds was built without pybind11; '
            'install pybind11-dev and python3-dev, then build it again' % name) from error
    globals().update((each, getattr(robot, each)) for each in __all__)
    return globals()[name]


def __dir__():
    return sorted(set(globals()) | set(__all__))
