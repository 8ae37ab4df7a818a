#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""On which systems scripts/demo and scripts/test install packages, and what they say on others. The
workflow runs what the pages say, and scripts/container what is in Dockerfile:
other_systems_test.py FOLDER"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

PACKAGE = pathlib.Path()
DEBIAN = 'ID=debian\nVERSION_CODENAME=bookworm\n'
JAMMY = 'ID=ubuntu\nVERSION_CODENAME=jammy\nUBUNTU_CODENAME=jammy\n'
FOCAL = 'ID=ubuntu\nVERSION_CODENAME=focal\nUBUNTU_CODENAME=focal\n'
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

    def test_ubuntu_20_04_is_too_old(self):
        self.check_refused(self.answer(FOCAL), 'focal', 'rosdep and catkin', 'section Noetic')
        self.check_refused(self.answer(FOCAL, {'opt/ros/noetic/setup.sh': ''}), 'ROS noetic')

    def test_ubuntu_24_04_has_no_ros(self):
        self.check_refused(self.answer(NOBLE), 'noble', 'ROS One')
        self.check_refused(self.answer(MINT), 'noble', 'ROS One')
        self.check_refused(self.answer(NOBLE, distro='one'), 'ROS one', 'ROS One')

    def test_the_sections_exist(self):
        page = (PACKAGE / 'doc/deployment.md').read_text()
        for section in ('Noetic', 'ROS One'):
            self.assertIn(f'\n## {section}\n', page)


class WorkflowTest(unittest.TestCase):
    def setUp(self):
        self.text = (PACKAGE / '.github/workflows/ci.yml').read_text()
        self.jobs = yaml.safe_load(self.text)['jobs']

    def commands(self, job):
        return [line for step in self.jobs[job]['steps']
                for line in step.get('run', '').splitlines()]

    def test_is_a_workflow(self):
        for name, job in self.jobs.items():
            self.assertLessEqual({'runs-on', 'container', 'steps'}, set(job), name)
            for step in job['steps']:
                self.assertEqual(len({'uses', 'run'} & set(step)), 1, step)
                subprocess.run(['bash', '-n', '-c', step.get('run', '')], check=True)

    def test_debian_runs_the_two_commands_of_the_readme(self):
        start = (PACKAGE / 'README.md').read_text().split('## Quick start')[1].split('```')[1]
        said = re.findall(r'^(scripts/\w+)', start, re.MULTILINE)
        self.assertEqual(said, [command.split()[0] for command in self.commands('debian')])
        self.assertEqual(self.jobs['debian']['strategy']['matrix'],
                         {'release': ['11', '12', '13', 'sid'],
                          'machine': ['ubuntu-latest', 'ubuntu-24.04-arm']})

    def test_what_comes_before_a_release_runs_once_a_week(self):
        said = [line.split('  #')[0].strip() for line in
                (PACKAGE / 'CONTRIBUTING.md').read_text().splitlines() if 'before a release' in line]
        self.assertEqual(said, self.commands('release'))
        self.assertEqual(self.jobs['release']['if'], "github.event_name == 'schedule'")
        self.assertIn('cron:', self.text)

    def test_noetic_and_ros_one_run_the_commands_of_their_page(self):
        page = (PACKAGE / 'doc/deployment.md').read_text()
        said = {line.split('  #')[0].strip() for line in page.splitlines()}
        self.assertEqual([entry['ros'] for entry in
                          self.jobs['catkin']['strategy']['matrix']['include']], ['noetic', 'one'])
        for command in self.commands('catkin')[1:]:  # the first one fills up a bare container
            self.assertIn(command.replace('${{ matrix.ros }}', 'noetic'), said)


class ContainerTest(unittest.TestCase):
    def test_steps_are_those_of_the_dockerfile(self):
        listed = subprocess.run([PACKAGE / 'scripts/container', '--list'], check=True,
                                stdout=subprocess.PIPE, encoding='utf-8').stdout.splitlines()
        text = re.sub(r'\\\n', '', (PACKAGE / 'Dockerfile').read_text())
        self.assertEqual(listed, [line for line in text.splitlines()
                                  if line and not line.startswith('#')])
        self.assertEqual([line.split()[0] for line in listed], 'FROM COPY RUN RUN CMD'.split())


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
