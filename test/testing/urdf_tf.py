# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The transforms that robot_state_publisher sends of a URDF."""
import math
from xml.etree import ElementTree

import genpy
from bounds_testing import Pose, transform, turn


def numbers(element, key, default):
    return [float(x) for x in (element.get(key, default) if element is not None else default).split()]


def origin_of(joint):
    """The pose of the child in its parent while the joint is at 0."""
    origin = joint.find('origin')
    roll, pitch, yaw = (math.degrees(angle) for angle in numbers(origin, 'rpy', '0 0 0'))
    return (Pose(numbers(origin, 'xyz', '0 0 0'), turn((0, 0, 1), yaw)) *
            Pose(xyzw=turn((0, 1, 0), pitch)) * Pose(xyzw=turn((1, 0, 0), roll)))


class UrdfTf:
    """`movable` has the names of the joints that move."""

    def __init__(self, description):
        self._joints = ElementTree.fromstring(description).findall('joint')
        self.movable = [joint.get('name') for joint in self._joints if self.moves(joint)]

    @staticmethod
    def moves(joint):
        return joint.get('type') != 'fixed'

    def static(self):
        """The transforms of joints that do not move."""
        return [self._transform(joint, genpy.Time(), 0) for joint in self._joints
                if not self.moves(joint)]

    def moving(self, stamp, values):
        """The transforms of the others at these values by name [rad or m]."""
        return [self._transform(joint, stamp, self._value(joint, values)) for joint in self._joints
                if self.moves(joint)]

    @staticmethod
    def _value(joint, values):
        mimic = joint.find('mimic')
        if mimic is None:
            return values[joint.get('name')]
        return (values[mimic.get('joint')] * float(mimic.get('multiplier', 1)) +
                float(mimic.get('offset', 0)))

    @staticmethod
    def _transform(joint, stamp, value):
        axis = numbers(joint.find('axis'), 'xyz', '1 0 0')
        motion = (Pose([value * a for a in axis]) if joint.get('type') == 'prismatic' else
                  Pose(xyzw=turn(axis, math.degrees(value))))
        pose = origin_of(joint) * motion
        return transform(joint.find('parent').get('link'), joint.find('child').get('link'), stamp,
                         pose.xyz, pose.xyzw)
