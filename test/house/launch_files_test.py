#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""roslaunch finds each launch file by package and name: launch_files_test.py CHECKOUT BUILD_FOLDER

roslaunch searches the complete checkout, with all that was built or installed there."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from roslaunch.config import load_config_default
from roslaunch.core import RLException


class LaunchFiles(unittest.TestCase):
    checkout = build = None

    def test_each_is_found_once(self):
        files = sorted(self.checkout.glob('launch/*.launch'))
        self.assertGreater(len(files), 3)
        for path in files:
            with self.subTest(path.name):
                found = subprocess.run(['roslaunch', '--files', 'link_bounds', path.name],
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.assertEqual(found.returncode, 0, found.stdout)
                self.assertIn(path.resolve(), map(pathlib.Path.resolve, map(
                    pathlib.Path, found.stdout.splitlines())))

    def test_the_node_says_on_the_screen_what_it_bounds(self):
        nodes = [node for path in sorted(self.checkout.glob('launch/*.launch'))
                 for node in load_config_default([str(path)], None, verbose=False).nodes
                 if node.type == 'link_bounds_publisher']
        self.assertGreater(len(nodes), 4)
        self.assertEqual({node.output for node in nodes}, {'screen'})

    def test_no_node_of_a_test_is_required(self):
        """Where a required one dies, roslaunch ends the test, and rostest says that it has succeeded."""
        files = [*self.checkout.glob('test/**/*.test'), self.checkout / 'test/node.test.in']
        self.assertGreater(len(files), 10)
        for path in files:
            with self.subTest(path.name):
                self.assertNotIn('required=', path.read_text('utf-8'))

    def test_nothing_is_installed_where_roslaunch_looks(self):
        prefix = self.checkout / 'build' / 'installed'
        self.assertFalse(prefix.exists())
        self.addCleanup(shutil.rmtree, prefix, ignore_errors=True)
        found = subprocess.run(['cmake', '--install', self.build, '--prefix', prefix],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertNotEqual(found.returncode, 0, found.stdout)
        # CMake breaks lines.
        self.assertIn('roslaunch would find each launch file twice', ' '.join(found.stdout.split()))
        self.assertFalse(prefix.exists())

    def test_all_is_installed_to_one_prefix(self):
        """catkin installs the Python module and setup.bash to that of the configuration."""
        cache = (pathlib.Path(self.build) / 'CMakeCache.txt').read_text()
        configured = re.search('^CMAKE_INSTALL_PREFIX:PATH=(.*)$', cache, re.MULTILINE)[1]
        with tempfile.TemporaryDirectory() as folder:
            # Whatever is installed is below that folder.
            found = subprocess.run(['cmake', '--install', self.build, '--prefix', '/some/other'],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   env=dict(os.environ, DESTDIR=folder))
            self.assertNotEqual(found.returncode, 0, found.stdout)
            text = ' '.join(found.stdout.split())  # CMake breaks lines
            self.assertIn('configured for the prefix %s,' % os.path.realpath(configured), text)
            self.assertIn('with -DCMAKE_INSTALL_PREFIX=/some/other,', text)
            self.assertEqual(os.listdir(folder), [])

    def parameters(self, *arguments):
        path = str(self.checkout / 'launch' / 'link_bounds.launch')
        return {name: parameter.value for name, parameter in
                load_config_default([(path, list(arguments))], None, verbose=False).params.items()}

    def config(self, text):
        """The argument for a file of this text."""
        file = tempfile.NamedTemporaryFile('w', suffix='.yaml')
        self.addCleanup(file.close)
        file.write(text)
        file.flush()
        return 'config:=' + file.name

    def test_a_config_file_wins_over_arguments(self):
        node = '/arm/'
        parameters = self.parameters(
            'name:=arm', 'padding:=0.5', 'links:=[base]', 'groups:={a: [base]}',
            self.config('padding: 0.02\nlinks: [elbow]\ngroups: {b: [elbow]}\ntf_prefix: left'))
        expected = {'padding': 0.02, 'links': ['elbow'], 'tf_prefix': 'left', 'geometry': 'visual',
                    'groups/a': ['base'], 'groups/b': ['elbow']}
        self.assertEqual({name: parameters.get(node + name) for name in expected}, expected)

    def test_the_example_config_changes_nothing(self):
        example = 'config:=%s' % (self.checkout / 'launch' / 'example_config.yaml')
        self.assertEqual(self.parameters(example), self.parameters())

    def test_a_config_file_that_is_missing_or_broken_is_named(self):
        for argument, reason in (('config:=/no/such.yaml', r'file does not exist \[/no/such.yaml'),
                                 (self.config('links: [base'), r'file /.*\.yaml contains invalid'),
                                 (self.config('padding'), 'non-dictionary values')):
            with self.subTest(reason), self.assertRaisesRegex(RLException, reason):
                self.parameters(argument)


if __name__ == '__main__':
    LaunchFiles.build = sys.argv.pop()
    LaunchFiles.checkout = pathlib.Path(sys.argv.pop())
    unittest.main()
