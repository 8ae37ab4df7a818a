#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every line in a fenced `sh` block of README.md and doc/*.md runs as it is, but the EXCEPTIONS.
Those that ask urdf_bounds or bag_bounds for a verdict or a proof succeed for a sound robot, and
fail if one of its meshes is missing; the others run beside the demo, without a display.

Run as: documented_lines_test.py FOLDER_OF_THE_PROGRAMS
"""
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xmlrpc.client

from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from bag_bounds_testing import BEGIN, time_of, write_bag
from free_port import free_port
from page_testing import PACKAGE
from patience import PATIENCE

PROGRAMS = pathlib.Path()
# Why a line is not run, by its beginning.
MINUTES, ROOT, NETWORK = 'builds or measures for minutes', 'needs root', 'needs a network'
NOETIC = 'needs Noetic or ROS One instead of the packages of Debian'
EXCEPTIONS = {
    'scripts/demo ': 'installs packages, and builds for minutes', 'scripts/test ': 'runs this test',
    'roslaunch link_bounds link_bounds.launch rviz:=true': 'needs a display',
    'scripts/deb ': MINUTES + '; scripts/test --all runs it', 'docker ': 'needs docker',
    'sudo ': ROOT, 'autopkgtest ': ROOT, 'echo "deb ': ROOT, 'echo "yaml ': ROOT, 'rosdep ': NETWORK,
    'source /opt/ros/noetic': NOETIC, 'source devel/setup.bash': NOETIC, 'catkin ': NOETIC,
    'mkdir -p ~/catkin_ws': NOETIC, 'git clone ': NETWORK, 'scripts/arm64 ': ROOT,
    'cmake ': MINUTES + '; scripts/test does the like', 'source ~/ros/': 'needs the line before it',
    '(cd build': 'runs this test', 'g++ ': 'needs main.cpp, and a build of minutes',
    'scripts/figures ': MINUTES, 'scripts/bench ': MINUTES, 'scripts/pictures ': MINUTES,
    'rosrun link_bounds bag_bounds --merge ': 'needs lines; bag_reports_test runs it',
    'scripts/get_robots ': NETWORK, 'LINK_BOUNDS_DATA=': MINUTES,
    'rosrun link_bounds boxes_to.py ': 'needs messages that Debian lacks'}
# These lines go on until they are interrupted; then they must have printed something.
ENDLESS = (r'roslaunch |rostopic echo (?!-n )|rostopic pub -l |rosbag record |'
           r'rosrun link_bounds (zone_events.py|cloud_filter )')
# Nodes of the same name on pages: each has a master of its own, or one would end the other.
NODES = ('roslaunch', 'rosrun link_bounds cloud_filter')
DEADLINE = 60 * PATIENCE  # s
AT_ONCE = 4  # blocks; they wait most of the time
URDF_MODES = ('--distances', '--poses', '--path', '--reach', '--pairs')
INCOMPLETE = 4  # exit code
PLAN, COLLIDES = '--path --objects launch/demo/cell.yaml', 3  # the example of a plan, and its exit code
APART = 0.4  # metres between the links
BALL = '<geometry><sphere radius="0.05"/></geometry>'
LOST = '<geometry><mesh filename="file:///no/such/file.stl"/></geometry>'
FAR_ZONE = 'far: {min: [8, 8, 8], max: [9, 9, 9]}\n'
FAR_OBJECT = 'far: {type: CUBE, pose: {position: {x: 9}}, scale: {x: 1, y: 1, z: 1}}\n'
SCRIPTS = {'rosrun': 'program=$2; shift 2; exec "%s/$program" "$@"', 'xacro': 'exec cat "$1"'}


def blocks():
    """The lines of each block, with those that continue them, which are indented."""
    for page in [PACKAGE / 'README.md', *sorted((PACKAGE / 'doc').glob('*.md'))]:
        for block in re.findall(r'^```sh\n(.*?)^```$', page.read_text('utf-8'),
                                re.DOTALL | re.MULTILINE):
            yield re.split(r'\n(?!\s)', block.rstrip('\n'))


def is_of_a_robot(line):
    """Whether it needs the reader's robot, or files of it, which a test can make."""
    return bool(re.search(r' (urdf_bounds (?!launch/)|bag_bounds )', line))


def asks(line):
    """Not the lines that only print boxes."""
    return ' urdf_bounds ' in line and any(mode in line for mode in URDF_MODES) or (
        ' bag_bounds ' in line)


def exception(line):
    """The beginning by which it is one, or None."""
    return next((start for start in EXCEPTIONS if (line + ' ').startswith(start)), None)


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
            elif name.endswith('.csv'):
                joints = list(links_of(line).values())
                rows = [joints, ['0'] * len(joints), ['1'] * len(joints)]
                self.write(name, ''.join(','.join(row) + '\n' for row in rows))
            elif name.endswith('.yaml'):
                self.write(name, FAR_OBJECT if '--objects ' + name in line else FAR_ZONE)
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
        found = [line for block in blocks() for line in block
                 if asks(line) and not exception(line)]
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

    def test_lines_that_print_boxes(self):
        for line in (line for block in blocks() for line in block):
            if is_of_a_robot(line) and not asks(line) and not exception(line):
                with self.subTest(line):
                    code, err = self.status(line, is_sound=True)
                    self.assertEqual(code, 0, err)


class Shell:
    """A master of its own, and a folder with what the checkout has, where the lines write, too."""

    def __init__(self, port=None):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        for path in PACKAGE.iterdir():
            if path.name != 'build':
                (self.folder / path.name).symlink_to(path)
        (self.folder / 'build').symlink_to(PROGRAMS.resolve().parents[2])
        shutil.copy(PACKAGE / 'launch/example_config.yaml', self.folder / 'my_robot.yaml')
        self.processes = {}
        self.environment = dict(os.environ, PYTHONUNBUFFERED='1')
        self.environment.pop('DISPLAY', None)
        self.use_master(port or self.start_master())

    def use_master(self, port):
        self.port = port
        self.environment['ROS_MASTER_URI'] = 'http://localhost:%d' % port

    def start_master(self):
        """One that knows the robot of the demo. Returns its port."""
        port = free_port()
        self.start('rosmaster --core -p %d' % port)
        text = (PACKAGE / 'launch/demo/demo.urdf').read_text('utf-8')
        with xmlrpc.client.ServerProxy('http://localhost:%d' % port) as master:
            self.wait(lambda: master.setParam('/test', '/robot_description', text), 'a master')
        return port

    def start(self, line):
        path = self.folder / ('output_%d' % len(self.processes))
        with open(path, 'w') as output, open(str(path) + '_errors', 'w') as errors:
            process = subprocess.Popen(
                ['bash', '-c', line], cwd=self.folder, env=self.environment, stdout=output,
                stderr=errors, stdin=subprocess.DEVNULL, start_new_session=True)
        process.output = path
        self.processes[line] = process

    def said(self, line):
        path = self.processes[line].output
        return ''.join(pathlib.Path(str(path) + end).read_text('utf-8') for end in ('', '_errors'))

    @staticmethod
    def wait(condition, what):
        end = time.monotonic() + DEADLINE
        while time.monotonic() < end:
            try:
                if condition():
                    return
            except OSError:  # no master yet
                pass
            time.sleep(0.1)
        raise AssertionError('waited in vain for ' + what)

    def run(self, line):
        """Until it ends well, or, where it does not end, until it goes on well."""
        if line.startswith(NODES):
            self.use_master(self.start_master())
        self.start(line)
        process = self.processes[line]
        if not re.match(ENDLESS, line):
            self.wait(lambda: process.poll() is not None, 'the end of ' + line)
            if process.returncode != (COLLIDES if line.endswith(PLAN) else 0):
                raise AssertionError('%s\nends with %d: %s' % (line, process.returncode,
                                                              self.said(line)))
        elif line.startswith('roslaunch'):
            self.await_boxes(line)

    def await_boxes(self, line):
        with xmlrpc.client.ServerProxy('http://localhost:%d' % self.port) as master:
            self.wait(lambda: self.goes_on(line) and any(
                topic.endswith('/boxes') for topic, _ in master.getSystemState('/test')[2][0]),
                      '~boxes of ' + line)

    def check_endless(self, line):
        file = re.search(r' (>|-O) (\S+)', line)
        name = file[2] + '.active' * (file[1] == '-O') if file else ''  # rosbag's, while it writes
        path = self.folder / name if file else self.processes[line].output
        self.wait(lambda: self.goes_on(line) and path.exists() and path.stat().st_size,
                  'the output of ' + line)

    def goes_on(self, line):
        if self.processes[line].poll() is not None:
            raise AssertionError(line + '\nhas ended: ' + self.said(line))
        return True

    def end(self):
        for number in (signal.SIGINT, signal.SIGKILL):
            for process in reversed(list(self.processes.values())):
                if process.poll() is None:
                    os.killpg(process.pid, number)
            end = time.monotonic() + 40  # roslaunch waits for its nodes, and would leave them
            while time.monotonic() < end and any(
                    process.poll() is None for process in self.processes.values()):
                time.sleep(0.05)
        shutil.rmtree(self.folder)


class EveryLineTest(unittest.TestCase):
    """Lines of one block share a folder and a master, but those of NODES."""

    def test_every_line(self):
        demo = Shell()
        self.addCleanup(demo.end)
        demo.run('roslaunch link_bounds demo.launch')
        seen, chosen = set(), []
        for block in blocks():
            lines = [line for line in block if not exception(line) and not is_of_a_robot(line)]
            if not seen.issuperset(lines):
                chosen.append(lines)
            seen.update(lines)
        self.assertGreater(len(seen), 15)
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            found = pool.map(lambda block: self.fault(block, demo.port), chosen)
            faults = [fault for fault in found if fault]
        self.assertEqual(faults, [], '\n'.join(faults))

    @staticmethod
    def fault(block, port):
        """What went wrong, or nothing."""
        shell = Shell(port)
        try:
            for line in block:
                shell.run(line)
            for line in block:
                if re.match(ENDLESS, line):
                    shell.check_endless(line)
        except AssertionError as error:
            return str(error)
        finally:
            shell.end()
        return None

    def test_every_exception_is_one(self):
        used = collections.Counter(exception(line) for block in blocks() for line in block)
        self.assertEqual(set(EXCEPTIONS) - set(used), set())


if __name__ == '__main__':
    PROGRAMS = pathlib.Path(sys.argv.pop())
    unittest.main()
