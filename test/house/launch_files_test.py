#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""roslaunch finds each launch file by package and name: launch_files_test.py CHECKOUT BUILD_FOLDER

roslaunch searches the complete checkout, with all that was built or installed there."""
import pathlib
import shutil
import subprocess
import sys
import unittest

from roslaunch.config import load_config_default


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


if __name__ == '__main__':
    LaunchFiles.build = sys.argv.pop()
    LaunchFiles.checkout = pathlib.Path(sys.argv.pop())
    unittest.main()
