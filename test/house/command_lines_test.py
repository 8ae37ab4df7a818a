#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every program answers --help and --version and refuses an unknown argument in one line, before it
connects to ROS: a node that registers ends the running one of its name.

Run as: command_lines_test.py FOLDER_OF_THE_PACKAGE FOLDER_OF_THE_PROGRAMS
"""
import os
import pathlib
import re
import socket
import subprocess
import sys
import unittest
from xml.etree import ElementTree

from patience import PATIENCE

PACKAGE, PROGRAMS = pathlib.Path(), pathlib.Path()
NAMES = ('link_bounds_publisher', 'mesh_worker', 'urdf_bounds', 'bag_bounds', 'assert_box',
         'assert_distance', 'boxes_to.py', 'box_table.py', 'joint_mover.py', 'overlap_colors.py',
         'scene_objects.py', 'zone_events.py')
NODE = 'link_bounds_publisher'
TIMEOUT = 60 * PATIENCE  # s


def programs():
    """Those that are installed, and the scripts of the repository."""
    scripts = [path for path in (PACKAGE / 'scripts').iterdir()
               if path.is_file() and not path.suffix and os.access(path, os.X_OK)]
    return [PROGRAMS / name for name in NAMES] + sorted(scripts)


class CommandLinesTest(unittest.TestCase):
    def setUp(self):
        self.master = socket.create_server(('localhost', 0))
        self.addCleanup(self.master.close)
        self.master.setblocking(False)

    def run_program(self, program, *arguments):
        """Exit code, standard output and standard error; fails if the program called the ROS
        master, which here never answers."""
        environment = dict(os.environ, ROS_MASTER_URI='http://localhost:%d'
                           % self.master.getsockname()[1])
        done = subprocess.run([program, *arguments], env=environment, timeout=TIMEOUT, check=False,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding='utf-8')
        with self.assertRaises(BlockingIOError, msg='called the master'):
            self.master.accept()
        return done.returncode, done.stdout, done.stderr

    def check_refused(self, program, argument, remedy):
        code, out, err = self.run_program(program, argument)
        self.assertIn(code, (1, 2))
        text = out + err
        self.assertEqual(text.count('\n'), 1, text)
        self.assertIn(remedy, text)

    def test_help(self):
        for program in programs():
            with self.subTest(program.name):
                code, out, err = self.run_program(program, '--help')
                self.assertEqual((code, err), (0, ''))
                self.assertTrue(out.startswith('usage: ') or out.startswith('usage, in'), out)

    def test_version(self):
        version = ElementTree.parse(PACKAGE / 'package.xml').findtext('version')
        for program in programs():
            of = ' of link_bounds ' if program.parent.name == 'scripts' else ' '
            with self.subTest(program.name):
                self.assertEqual(self.run_program(program, '--version'),
                                 (0, program.name + of + version + '\n', ''))

    def test_unknown_argument(self):
        for program in programs():
            remedy = 'use urdf_bounds' if program.name == 'mesh_worker' else '--help'
            with self.subTest(program.name):
                self.check_refused(program, '--hepl', remedy)

    def test_the_page_names_all_benchmarks(self):
        usage = (PACKAGE / 'scripts/bench').read_text().split('usage: scripts/bench ')[1]
        page = (PACKAGE / 'doc/tools.md').read_text().split('| `scripts/bench` | measures: ')[1]
        self.assertEqual(re.findall('`(.*?)`', page.split(';')[0]),
                         re.findall('[a-z-]+', usage.split('[')[0]))

    def test_rosrun_finds_each_program_once(self):
        """It also looks in the checkout, for files that are executable."""
        found = [str(path) for folder in ('launch', 'src') for path in (PACKAGE / folder).rglob('*')
                 if path.is_file() and os.access(path, os.X_OK)]
        self.assertEqual(found, [])

    def test_a_parameter_without_its_underscore(self):
        self.check_refused(PROGRAMS / NODE, 'padding:=0.05', 'write _padding:=0.05')

    def test_a_value_that_the_parameter_cannot_have(self):
        self.check_refused(PROGRAMS / NODE, '_padding:=abc', '~padding')


if __name__ == '__main__':
    PROGRAMS, PACKAGE = pathlib.Path(sys.argv.pop()), pathlib.Path(sys.argv.pop())
    unittest.main()
