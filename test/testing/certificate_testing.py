# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of scripts/check_certificate: robots, the checker, and files."""
import contextlib
import importlib.machinery
import io
import json
import os
import subprocess
import sys
import types

import urdf_bounds_testing
from bad_inputs import SANITIZED
from urdf_bounds_pairs_test import ball, joint, link

PACKAGE = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '../..'))
DEMO = os.path.join(PACKAGE, 'launch/demo/demo.urdf')
UNUSABLE, REFUSED, INCOMPLETE = 1, 3, 4  # exit codes
DAMAGES = 20 if SANITIZED else 200  # the checker is the same, and writes no memory itself
COARSE = ('--pairs', '--accuracy', '1000', '--budget', '1000')

# With collision geometry in STL files and solids. The others have too many boxes for a test.
PUBLIC = {'ur_description/urdf/ur5e.urdf': '20', 'franka_description/urdf/panda.urdf': '3',
          'husky_description/urdf/husky.urdf': '20'}
if SANITIZED:
    del PUBLIC['franka_description/urdf/panda.urdf']

# A planar and a floating joint, and ranges in which links stay apart for which these turn.
MOBILE = os.path.join(PACKAGE, 'test/data/mobile_arm.urdf')
BASE_RANGES = ('drive.x:=-0.5..0.1', 'drive.y:=-0.1..0.2', 'drive.yaw:=-0.4..0.4', 'lift:=-0.2..0.1',
               'wrist:=-1..1', 'carry.x:=-0.6..-0.5', 'carry.y:=-0.1..0.2', 'carry.z:=-0.1..0.1',
               'carry.yaw:=0.5..0.7', 'carry.pitch:=-0.3..-0.1', 'carry.roll:=-0.1..0.3')
# Of the same direction, and of lengths whose squares are no numbers.
LONG_AXES = '0 0 1e-200', '0 0 1e200', '0 0 1e-320'
WRONG = ''


def lines_of(path):
    with open(path, encoding='utf-8') as file:
        return [json.loads(line) for line in file]


def load_checker():
    folder = os.path.join(PACKAGE, 'scripts')
    sys.path.insert(0, folder)
    path = os.path.join(folder, 'check_certificate')
    loader = importlib.machinery.SourceFileLoader('checker', path)
    module = types.ModuleType('checker')
    module.__file__ = path
    loader.exec_module(module)
    return module


CHECKER = load_checker()


def check(*arguments):
    """Exit code, and what is printed."""
    text = io.StringIO()
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
        code = CHECKER.main(list(arguments))
    return code, text.getvalue()


def write_wrong(*arguments):
    """By an engine whose bodies move too little."""
    subprocess.run([WRONG, *arguments], check=True, stdout=subprocess.DEVNULL)


def box(size, place='0 0 0', turn='0 0 0'):
    return '<origin xyz="%s" rpy="%s"/><geometry><box size="%s"/></geometry>' % (place, turn, size)


def mesh(name, place='0 0 0'):
    path = os.path.join(PACKAGE, 'test/data/meshes', name)
    return ('<origin xyz="%s"/><geometry><mesh filename="file://%s" scale="0.3 0.2 0.2"/>'
            '</geometry>' % (place, path))


def cube_at(place):
    """The triangles of a cube of 0.1 m around it, as the text of an STL file."""
    corners = [[place[0] + x, place[1] + y, z] for x in (-.05, .05) for y in (-.05, .05)
               for z in (-.05, .05)]
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    text = ''
    for a, b, c, d in faces:
        for triangle in ((a, b, c), (a, c, d)):
            text += 'facet normal 0 0 0 outer loop %s endloop endfacet\n' % ' '.join(
                'vertex %r %r %r' % tuple(corners[i]) for i in triangle)
    return text


# Joints of all kinds, backwards and forwards, and shapes of all kinds; nothing collides.
ARM = '<robot name="arm">%s</robot>' % ''.join([
    link('base', box('0.4 0.4 0.2', '0 0 -0.3', '0.1 0.2 0.3')), link('upper', ball(0.05, 0.3)),
    link('lower', mesh('cube.stl', '0.1 0 0')), link('slide', ball(0.03)),
    link('tower', '<origin xyz="0 0 0.2"/><geometry><cylinder radius="0.1" length="0.3"/>'
         '</geometry>'),
    joint('shoulder', 'continuous', 'base', 'upper', '0 0 0.2'),
    joint('elbow', 'revolute', 'upper', 'lower', '0.6 0 0', (-1, 1)),
    joint('push', 'prismatic', 'lower', 'slide', '0.5 0 0.1', (0, 0.3)),
    joint('turn', 'revolute', 'base', 'tower', '-1.9 0 0', (-0.5, 2)).replace(
        '<axis', '<mimic joint="elbow" multiplier="-2" offset="0.5"/><axis')])


def turned(leaf):
    if leaf == 'mesh':
        return [0, 0, 0]
    return [turned(n) for n in leaf] if isinstance(leaf[0], list) else [-x for x in leaf]


def halved(times, leaf):
    """A tree whose only variable is halved so many times in a row, everywhere."""
    return [leaf] if times == 0 else [0] + 2 * halved(times - 1, leaf)


# How a file is damaged by a last line that urdf_bounds does not write: by what it counts there.
NOT_COUNTED = [{'never': 1}, {'NEVER ': 1}, {'': 1}, {'NEVER': 0}, {'NEVER': -1}, {'NEVER': 1.0},
               {'NEVER': True}, {'NEVER': '1'}, {'NEVER': None}, ['NEVER'], 'NEVER', None, 1]


def is_leaf(token):
    return not isinstance(token, int)


def write_lines(path, lines):
    with open(path, 'w', encoding='utf-8') as file:
        file.writelines(json.dumps(line) + '\n' for line in lines)


def main():
    """Runs the tests of a script with the paths of wrong_urdf_bounds and urdf_bounds."""
    global WRONG
    WRONG = sys.argv.pop(1)
    urdf_bounds_testing.main()
