#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The lines of README.md and doc/tools.md that ask urdf_bounds or bag_bounds for a verdict or a
proof succeed for a sound robot, and fail if one of its meshes is missing.

Run as: documented_lines_test.py FOLDER_OF_THE_PROGRAMS
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from bag_bounds_testing import BEGIN, time_of, write_bag
from page_testing import PACKAGE
from patience import PATIENCE

PROGRAMS = pathlib.Path()
PAGES = ('README.md', 'doc/tools.md')
URDF_MODES = ('--distances', '--poses', '--path', '--reach', '--pairs')
INCOMPLETE = 4  # exit code
APART = 0.4  # metres between the links
BALL = '<geometry><sphere radius="0.05"/></geometry>'
LOST = '<geometry><mesh filename="file:///no/such/file.stl"/></geometry>'
FAR_ZONE = 'far: {min: [8, 8, 8], max: [9, 9, 9]}\n'
FAR_OBJECT = 'far: {type: CUBE, pose: {position: {x: 9}}, scale: {x: 1, y: 1, z: 1}}\n'
SCRIPTS = {'rosrun': 'program=$2; shift 2; exec "%s/$program" "$@"', 'xacro': 'exec cat "$1"'}


def lines():
    """Each with the lines that continue it, which are indented; not those that only print boxes."""
    for page in PAGES:
        blocks = re.findall(r'^```sh\n(.*?)^```$', (PACKAGE / page).read_text('utf-8'),
                            re.DOTALL | re.MULTILINE)
        for line in re.split(r'\n(?!\s)', '\n'.join(blocks)):
            asks = ' urdf_bounds ' in line and any(mode in line for mode in URDF_MODES)
            if asks or ' bag_bounds ' in line:
                yield line


def links_of(line):
    """{link: its joint} of the joints that the line names, and of two more, so that there are pairs
    to look at; a joint with parts is planar."""
    names = [*dict.fromkeys(re.findall(r'(\w+)(?:\.\w+)?:=', line)), 'unnamed_1', 'unnamed_2']
    return {'l%d' % i: name for i, name in enumerate(names, 1)}


def robot(line, is_sound):
    text = ''
    for link in ['l0', *links_of(line)]:
        elements = [BALL] if is_sound or link != 'l0' else [BALL, LOST]
        text += '<link name="%s">%s</link>' % (link, ''.join(
            '<%s>%s</%s>' % (kind, geometry, kind)
            for kind in ('visual', 'collision') for geometry in elements))
    for i, (link, joint) in enumerate(links_of(line).items(), 1):
        kind = 'planar' if joint + '.' in line else 'continuous'
        text += ('<joint name="%s" type="%s"><parent link="l0"/><child link="%s"/>'
                 '<axis xyz="0 0 1"/><origin xyz="0 %r 0"/></joint>'
                 % (joint, kind, link, APART * i))
    return '<robot name="r">%s</robot>' % text


def transforms(line):
    message = TFMessage()
    for i, link in enumerate(links_of(line), 1):
        transform = TransformStamped(child_frame_id=link)
        transform.header.frame_id = 'l0'
        transform.transform.translation.y = APART * i
        transform.transform.rotation.w = 1
        message.transforms.append(transform)
    return message


class DocumentedLinesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in SCRIPTS.items():
            text = '#!/bin/sh\n' + text.replace('%s', str(PROGRAMS))
            self.write('bin/' + name, text).chmod(0o755)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, 'utf-8')
        return path

    def status(self, line, is_sound):
        """Of the shell, in a folder with all files that the line reads."""
        for name in re.findall(r'[\w./]+\.(?:urdf\.xacro|urdf|srdf|yaml|bag|csv)\b', line):
            if name.endswith('.bag'):
                message = ('/tf_static', transforms(line), time_of(BEGIN))
                write_bag(str(self.folder / name), [message])
            elif name.endswith('.yaml'):
                self.write(name, FAR_OBJECT if '--objects ' + name in line else FAR_ZONE)
            elif name.endswith('.csv'):
                self.write(name, 'unnamed_1,unnamed_2\n0,0\n1,1\n')
            elif name.endswith('.srdf'):
                self.write(name, '<robot name="r"/>')
            else:
                self.write(name, robot(line, is_sound))
        environment = dict(os.environ, PATH='%s:%s' % (self.folder / 'bin', os.environ['PATH']))
        done = subprocess.run(['sh', '-c', line], cwd=self.folder, env=environment, check=False,
                              timeout=100 * PATIENCE, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        return done.returncode, done.stderr.decode()

    def test_each_line_fails_if_a_mesh_is_missing(self):
        found = list(lines())
        for mode in (*URDF_MODES, '--srdf', 'json.load', 'bag_bounds'):
            self.assertTrue(any(mode in line for line in found), mode)
        for line in found:
            with self.subTest(line):
                self.assertNotIn('|', line, 'the status of all but the last program is lost')
                code, err = self.status(line, is_sound=True)
                self.assertEqual(code, 0, err)
                code, err = self.status(line, is_sound=False)
                self.assertEqual(code, INCOMPLETE, err)
                self.assertIn('--allow-incomplete', err)


if __name__ == '__main__':
    PROGRAMS = pathlib.Path(sys.argv.pop())
    unittest.main()
