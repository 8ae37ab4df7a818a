#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every program answers --help and --version and refuses an unknown argument in one line, before it
connects to ROS: a node that registers ends the running one of its name. Programs are what CMake
installs and what is executable in scripts.

Run as: command_lines_test.py FOLDER_OF_THE_PACKAGE FOLDER_OF_THE_PROGRAMS FOLDER_OF_THE_BUILD
"""
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

from patience import PATIENCE

PACKAGE, PROGRAMS, BUILD = pathlib.Path(), pathlib.Path(), pathlib.Path()
NODE = 'link_bounds_publisher'
RVIZ = 'rviz_in_fixed_frame.py'  # gives unknown arguments to rviz
# As where rosdep is installed and has never been updated: rospkg then complains on standard error.
EMPTY_ROSDEP = '''
def init_rospack_interface(): pass
def is_view_empty(view): return True
def is_ros_package(view, name): return False
def is_system_dependency(view, name): return False
'''
TIMEOUT = 60 * PATIENCE  # s


def installed(script=None):
    """The names of the programs that this script of CMake installs, and the scripts it includes."""
    text = (script or BUILD / 'cmake_install.cmake').read_text()
    files = re.findall(r'/lib/link_bounds" TYPE (?:EXECUTABLE|PROGRAM) FILES "(.*?)"', text)
    names = {pathlib.Path(path).name for path in files}
    for path in re.findall(r'include\("(.*?/cmake_install\.cmake)"\)', text):
        names |= installed(pathlib.Path(path))
    return names


def programs():
    """Those that are installed, and the scripts of the repository."""
    scripts = [path for path in (PACKAGE / 'scripts').iterdir()
               if path.is_file() and os.access(path, os.X_OK)]
    return sorted(PROGRAMS / name for name in installed()) + sorted(scripts)


class CommandLinesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        rosdep = pathlib.Path(folder.name) / 'rosdep2'
        rosdep.mkdir()
        (rosdep / '__init__.py').touch()
        (rosdep / 'rospack.py').write_text(EMPTY_ROSDEP)
        cls.python_path = os.pathsep.join([folder.name, os.environ['PYTHONPATH']])

    def setUp(self):
        self.master = socket.create_server(('localhost', 0))
        self.addCleanup(self.master.close)
        self.master.setblocking(False)

    def run_program(self, program, *arguments):
        """Exit code, standard output and standard error; fails if the program called the ROS
        master, which here never answers. As beside another ROS, in which scripts do nothing else."""
        environment = dict(os.environ, PYTHONPATH=self.python_path, ROS_DISTRO='noetic',
                           ROS_MASTER_URI='http://localhost:%d' % self.master.getsockname()[1])
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

    def test_help_that_cannot_be_written(self):
        checked = 0
        for program in programs():
            if program.name not in ('link_bounds_publisher', 'cloud_filter', 'urdf_bounds', 'bag_bounds'):
                continue
            for argument in '--help', '--version':
                with self.subTest(program.name, argument=argument), open('/dev/full', 'wb') as full:
                    done = subprocess.run([program, argument], timeout=TIMEOUT, check=False,
                                          stdout=full, stderr=subprocess.PIPE, encoding='utf-8')
                    self.assertEqual(done.returncode, 1)
                    self.assertIn('cannot write to standard output', done.stderr)
                    checked += 1
        self.assertEqual(checked, 8)

    def test_version(self):
        version = ElementTree.parse(PACKAGE / 'package.xml').findtext('version')
        for program in programs():
            of = ' of link_bounds ' if program.parent.name == 'scripts' else ' '
            with self.subTest(program.name):
                self.assertEqual(self.run_program(program, '--version'),
                                 (0, program.name + of + version + '\n', ''))

    def test_unknown_argument(self):
        for program in programs():
            if program.name == RVIZ:
                continue
            remedy = 'use urdf_bounds' if program.name == 'mesh_worker' else '--help'
            with self.subTest(program.name):
                self.check_refused(program, '--hepl', remedy)

    def test_the_page_names_all_programs(self):
        page = (PACKAGE / 'doc/tools.md').read_text()
        table = page.split('# Programs')[1].split('Each of them explains itself')[0]
        self.assertEqual(set(re.findall(r'^\| `(.*?)` \|', table, re.MULTILINE)), installed())
        table = page.split('## Scripts of the repository')[1]
        scripts = {path.name for path in programs() if path.parent.name == 'scripts'}
        self.assertEqual(set(re.findall(r'^\| `scripts/(.*?)` \|', table, re.MULTILINE)), scripts)

    def test_the_page_names_all_benchmarks(self):
        usage = (PACKAGE / 'scripts/bench').read_text().split('usage: scripts/bench ')[1]
        page = (PACKAGE / 'doc/tools.md').read_text().split('| `scripts/bench` | measures: ')[1]
        self.assertEqual(re.findall('`(.*?)`', page.split(';')[0]),
                         re.findall('[a-z-]+', usage.split('[')[0]))

    def test_the_synopsis_names_all_options_of_benchmarks(self):
        usage = (PACKAGE / 'scripts/bench').read_text().split('usage: scripts/bench ')[1]
        sources = [path.read_text() for path in (PACKAGE / 'test/bench').rglob('*.py')]
        self.assertLessEqual(set(re.findall(r'add_argument\("(--[a-z-]+)"', ' '.join(sources))),
                             set(re.findall('--[a-z-]+', usage.split('\n\n')[0])))

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
    BUILD, PROGRAMS, PACKAGE = (pathlib.Path(sys.argv.pop()) for _ in range(3))
    unittest.main()
