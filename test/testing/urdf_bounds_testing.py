# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of urdf_bounds: robots, a mesh, and running the program."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

from binary_stl import binary_stl
from patience import PATIENCE

URDF_BOUNDS = ''
HEADER = ['link', 'a_x', 'a_y', 'a_z', 'b_x', 'b_y', 'b_z']

# A bar of 2 x 1 x 0.5 m that begins at its joint, which is 1 m above the base.
ARM = '''<robot name="arm">
<link name="base"><visual><geometry><box size="1 2 3"/></geometry></visual>
  <collision><geometry><sphere radius="2"/></geometry></collision></link>
<link name="bar"><visual><origin xyz="1 0 0"/><geometry><box size="2 1 0.5"/></geometry></visual>
</link>
<link name="slide"><collision><geometry><cylinder radius="0.5" length="4"/></geometry></collision>
</link>
<link name="follower"><visual><geometry><box size="2 1 1"/></geometry></visual></link>
<link name="bare"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="bar"/>
  <origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/>
</joint>
<joint name="push" type="prismatic"><parent link="base"/><child link="slide"/>
  <axis xyz="1 0 0"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="follow" type="continuous"><parent link="base"/><child link="follower"/>
  <axis xyz="0 0 1"/><mimic joint="turn" multiplier="-2" offset="0.25"/></joint>
<joint name="still" type="fixed"><parent link="base"/><child link="bare"/></joint>
</robot>'''


def solid(name, extra=''):
    return '<link name="%s"><visual><geometry><box size="1 1 1"/></geometry></visual>%s</link>' % (
        name, extra)


def mesh(name, uri):
    return '<link name="%s"><visual><geometry><mesh filename="%s"/></geometry></visual></link>' % (
        name, uri)


def tree(*links):
    """A robot whose other links are children of the first one."""
    names = [re.search('name="(.*?)"', link, re.DOTALL).group(1) for link in links]
    joints = ['<joint name="j%d" type="fixed"><parent link="%s"/><child link="%s"/></joint>'
              % (i, names[0], name) for i, name in enumerate(names) if i > 0]
    return '<robot name="r">%s</robot>' % ''.join(list(links) + joints)


def tetrahedron():
    """A binary STL of the corners 0, x = 1, y = 2, z = 3."""
    corners = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    return binary_stl([[corners[i] for i in face] for face in faces])


def run(*arguments, urdf=ARM, **options):
    """Exit code, standard output and standard error; the robot comes by standard input."""
    text = urdf if isinstance(urdf, bytes) else urdf.encode('utf-8')
    options.setdefault('stdout', subprocess.PIPE)
    options.setdefault('stderr', subprocess.PIPE)
    done = subprocess.run([URDF_BOUNDS] + list(arguments), input=text, check=False,
                          timeout=60 * PATIENCE, **options)
    out, err = ((stream or b'').decode('utf-8') for stream in (done.stdout, done.stderr))
    return done.returncode, out, err


def boxes(*arguments, **options):
    """The parsed JSON of a run that must succeed with an empty standard error."""
    code, out, err = run('-', '--format', 'json', *arguments, **options)
    assert (code, err) == (0, ''), (code, err)
    return json.loads(out)


class UrdfBoundsTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'wb') as file:
            file.write(content if isinstance(content, bytes) else content.encode('utf-8'))
        return path

    def check_box(self, box, low, high):
        """Equal up to rounding, and never smaller."""
        for found, exact in zip(box['min'], low):
            self.assertLessEqual(found, exact + 1e-15)
            self.assertAlmostEqual(found, exact, delta=1e-12)
        for found, exact in zip(box['max'], high):
            self.assertGreaterEqual(found, exact - 1e-15)
            self.assertAlmostEqual(found, exact, delta=1e-12)

    def check_refused(self, reason, *arguments, **options):
        code, out, err = run(*arguments, **options)
        self.assertEqual((code, out), (1, ''), arguments)
        self.assertRegex(err, '^urdf_bounds: error: .*' + reason)
        self.assertIn('--help', err)
        self.assertEqual(err.count('\n'), 1, err)


def main():
    """Runs the tests of the script with the path of urdf_bounds, its last argument."""
    global URDF_BOUNDS
    URDF_BOUNDS = os.path.abspath(sys.argv.pop())
    unittest.main()
