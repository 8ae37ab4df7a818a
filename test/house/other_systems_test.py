#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""On which systems scripts/demo and scripts/test install packages, and what they say on others:
other_systems_test.py FOLDER"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path()
DEBIAN = 'ID=debian\nVERSION_CODENAME=bookworm\n'
JAMMY = 'ID=ubuntu\nVERSION_CODENAME=jammy\nUBUNTU_CODENAME=jammy\n'
NOBLE = 'ID=ubuntu\nVERSION_CODENAME=noble\nUBUNTU_CODENAME=noble\n'
MINT = 'ID=linuxmint\nID_LIKE="ubuntu debian"\nVERSION_CODENAME=wilma\nUBUNTU_CODENAME=noble\n'
ROS_2 = {'etc/apt/sources.list.d/ros2.list': 'deb http://packages.ros.org/ros2/ubuntu jammy main\n'}


class OtherSystemsTest(unittest.TestCase):
    def answer(self, os_release, files=None, distro=None):
        """What refuse_other_ros prints on a system of these files; '' where it goes on."""
        environment = dict(os.environ, PATH='/usr/bin:/bin')
        environment.pop('ROS_DISTRO', None)
        if distro:
            environment['ROS_DISTRO'] = distro
        with tempfile.TemporaryDirectory() as root:
            for name, text in {'etc/os-release': os_release, **(files or {})}.items():
                path = pathlib.Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            command = f'. {PACKAGE}/scripts/common.sh; refuse_other_ros "{root}"'
            done = subprocess.run(['bash', '-euc', command], env=environment, check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1 if done.stderr else 0)
        return done.stderr

    def check_refused(self, text, *words):
        self.assertEqual(text.count('\n'), 1, text)
        for word in words + ('doc/deployment.md',):
            self.assertIn(word, text)

    def test_debian(self):
        self.assertEqual(self.answer(DEBIAN), '')
        self.assertEqual(self.answer(DEBIAN, distro='Debian'), '')
        self.check_refused(self.answer(DEBIAN, distro='noetic'), 'ROS noetic', 'Noetic')

    def test_ubuntu_22_04_is_as_debian(self):
        self.assertEqual(self.answer(JAMMY), '')

    def test_ubuntu_22_04_with_another_ros(self):
        humble = {'opt/ros/humble/setup.sh': ''}
        self.check_refused(self.answer(JAMMY, humble), 'ROS humble', 'ROS One')
        self.check_refused(self.answer(JAMMY, ROS_2), 'another apt repository', 'ROS One')
        commented = {name: '# ' + text for name, text in ROS_2.items()}
        self.assertEqual(self.answer(JAMMY, commented), '')

    def test_ubuntu_24_04_has_no_ros(self):
        self.check_refused(self.answer(NOBLE), 'noble', 'ROS One')
        self.check_refused(self.answer(MINT), 'noble', 'ROS One')
        self.check_refused(self.answer(NOBLE, distro='one'), 'ROS one', 'ROS One')

    def test_the_sections_exist(self):
        page = (PACKAGE / 'doc/deployment.md').read_text()
        for section in ('Noetic', 'ROS One'):
            self.assertIn(f'\n## {section}\n', page)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
