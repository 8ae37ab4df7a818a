#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The steps of Dockerfile in a fresh Debian, and what users do in the image: container_test.py FOLDER"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

PACKAGE = pathlib.Path()
SKIPPED = 4  # the status that ctest knows


class ContainerTest(unittest.TestCase):
    def test_the_image_has_the_demo_and_urdf_bounds(self):
        done = subprocess.run([PACKAGE / 'scripts/container'], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding='utf-8')
        end = done.stdout[-4000:]
        self.assertEqual(done.returncode, 0, end)
        self.assertIn('name: "forearm"', end)
        # At last urdf_bounds on the cube of 2 x 4 x 6 m in the mounted folder.
        numbers = re.search('^cube,(.*)$', end, re.MULTILINE).group(1).split(',')
        self.assertEqual([round(float(number), 12) for number in numbers], [-1, -2, -3, 1, 2, 3])


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop())
    if 'LINK_BOUNDS_CONTAINER' not in os.environ or os.geteuid() != 0:
        print('skipped: the steps of Dockerfile in a fresh Debian; they run as root where '
              'LINK_BOUNDS_CONTAINER is set, and take ten minutes')
        sys.exit(SKIPPED)
    unittest.main()
