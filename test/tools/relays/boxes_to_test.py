#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""boxes_to.py beside message packages that are generated here: boxes_to_test.py BOXES_TO"""
import importlib.util
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
import zlib

import rospkg
import rospy
from bounds_testing import DEADLINE, Recorder
from genpy.generator import MsgGenerator
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from own_master import OwnMasterTest
from page_testing import PACKAGE
from std_msgs.msg import Header

# The fields of the released packages: jsk_recognition_msgs 1.2, vision_msgs 0.0.2.
PACKAGES = {
    'jsk_recognition_msgs': {
        'BoundingBox': 'std_msgs/Header header\ngeometry_msgs/Pose pose\n'
                       'geometry_msgs/Vector3 dimensions\nfloat32 value\nuint32 label\n',
        'BoundingBoxArray': 'std_msgs/Header header\nBoundingBox[] boxes\n'},
    'vision_msgs': {
        'BoundingBox3D': 'geometry_msgs/Pose center\ngeometry_msgs/Vector3 size\n',
        'BoundingBox3DArray': 'std_msgs/Header header\nBoundingBox3D[] boxes\n'}}
BOXES_TO = ''
TOPIC = '/link_bounds/boxes'
START_LIMIT = 3 * DEADLINE  # wall seconds, for a program in Python on a busy machine


def generate(folder, package, messages):
    """A Python package of some messages."""
    sources, target = folder / (package + '_sources'), folder / package / 'msg'
    sources.mkdir()
    target.mkdir(parents=True)
    for name, text in messages.items():
        (sources / (name + '.msg')).write_text(text)
    paths = {name: [rospkg.RosPack().get_path(name) + '/msg']
             for name in ('std_msgs', 'geometry_msgs')}
    MsgGenerator().generate_messages(
        package, [str(sources / (name + '.msg')) for name in messages], str(target),
        {package: [str(sources)], **paths})
    (target / '__init__.py').write_text(''.join('from ._%s import *\n' % name for name in messages))
    (folder / package / '__init__.py').touch()


def array_of(*boxes, incomplete=()):
    return AxisAlignedBoxArray(Header(stamp=rospy.Time(9, 5), frame_id='world'), list(boxes),
                               list(incomplete))


ARM = AxisAlignedBox('arm', rospy.Time(7, 1), Point(1, -2, 3), Point(2, 4, 3.5))
BASE = AxisAlignedBox('base', rospy.Time(), Point(0, 0, 0), Point(0, 0, 0))


def numbers(pose, lengths):
    p, q = pose.position, pose.orientation
    return (p.x, p.y, p.z, q.x, q.y, q.z, q.w, lengths.x, lengths.y, lengths.z)


ARM_NUMBERS = (1.5, 1, 3.25, 0, 0, 0, 1, 1, 6, 0.5)
BASE_NUMBERS = (0, 0, 0, 0, 0, 0, 1, 0, 0, 0)


class BoxesTo(OwnMasterTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for package, messages in PACKAGES.items():
            generate(cls.folder, package, messages)
        sys.path.insert(0, str(cls.folder))
        super().setUpClass()
        cls.publisher = rospy.Publisher(TOPIC, AxisAlignedBoxArray, queue_size=10, latch=True)

    def command(self, *arguments, folder=None):
        path = os.pathsep.join([str(folder or self.folder), os.environ['PYTHONPATH']])
        return dict(args=[BOXES_TO, *arguments], env=dict(os.environ, PYTHONPATH=path))

    def relayed(self, kind, message_type):
        """What it makes of three arrays, and what it gives who subscribes later."""
        relay = subprocess.Popen(**self.command('--type', kind, '_topic:=' + TOPIC))
        self.addCleanup(relay.wait)
        self.addCleanup(relay.kill)
        out = Recorder('/boxes_to_%s/out' % kind, message_type)
        self.addCleanup(out.subscriber.unregister)
        result = []
        for array in (array_of(ARM, BASE), array_of(ARM, incomplete=['arm', 'hand']), array_of()):
            out.clear()
            self.publisher.publish(array)
            count = len(array.boxes)
            result.append(out.wait(lambda m, n=count: len(m.boxes) == n, 'a message',
                                   START_LIMIT))
            header = result[-1].header
            self.assertEqual((header.frame_id, header.stamp), ('world', rospy.Time(9, 5)))
        late = Recorder('/boxes_to_%s/out' % kind, message_type)
        self.addCleanup(late.subscriber.unregister)
        late.wait(lambda m: not m.boxes, 'the latched message')
        return result

    def test_jsk(self):
        from jsk_recognition_msgs.msg import BoundingBoxArray
        both, partly, _ = self.relayed('jsk', BoundingBoxArray)
        self.assertEqual([numbers(box.pose, box.dimensions) for box in both.boxes],
                         [ARM_NUMBERS, BASE_NUMBERS])
        self.assertEqual([(box.header.frame_id, box.header.stamp) for box in both.boxes],
                         [('world', ARM.stamp), ('world', rospy.Time())])
        self.assertEqual([box.label for box in both.boxes],
                         [zlib.crc32(b'arm'), zlib.crc32(b'base')])
        self.assertEqual([box.value for box in both.boxes + partly.boxes], [1, 1, 0])

    def test_vision(self):
        from vision_msgs.msg import BoundingBox3DArray
        both, *_ = self.relayed('vision', BoundingBox3DArray)
        self.assertEqual([numbers(box.center, box.size) for box in both.boxes],
                         [ARM_NUMBERS, BASE_NUMBERS])

    def test_half_of_the_size_on_both_sides_contains_the_box(self):
        path = os.path.join(PACKAGE, 'src', 'tools', 'relays', 'boxes_to.py')
        spec = importlib.util.spec_from_file_location('boxes_to', path)
        relay = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(relay)
        chance = random.Random(1)
        for _ in range(20_000):
            far, near = 10 ** chance.uniform(-320, 300), 10 ** chance.uniform(-320, 300)
            low = chance.uniform(-far, far)
            high = max(low, low + near * chance.random())
            box = AxisAlignedBox(min=Point(low, -high, low), max=Point(high, -low, low))
            center, size = relay.center(box).position, relay.size(box)
            for axis in 'xyz':
                a, b = getattr(box.min, axis), getattr(box.max, axis)
                c, s = getattr(center, axis), getattr(size, axis)
                self.assertLessEqual(c - s / 2, a)
                self.assertGreaterEqual(c + s / 2, b)
                rounding = max(abs(a), abs(b)) * 1e-15 + 1e-322
                self.assertLessEqual(s, (b - a) * (1 + 1e-15) + rounding)

    def test_without_the_package_it_says_what_to_install(self):
        for kind, package in (('jsk', 'jsk_recognition_msgs'), ('vision', 'vision_msgs')):
            folder = self.folder / ('without_' + kind)
            (folder / package).mkdir(parents=True)
            (folder / package / '__init__.py').touch()  # hides one that is installed
            self.check_refused(kind, folder, 'install ros-noetic-' + package.replace('_', '-'))

    def test_a_version_without_the_message_is_named(self):
        folder = self.folder / 'old'
        folder.mkdir()
        generate(folder, 'vision_msgs', {'BoundingBox3D':
                                         PACKAGES['vision_msgs']['BoundingBox3D']})
        self.check_refused('vision', folder, 'vision_msgs has no BoundingBox3DArray here')

    def check_refused(self, kind, folder, remedy):
        done = subprocess.run(**self.command('--type', kind, folder=folder), check=False,
                              timeout=START_LIMIT, stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count('\n'), 1, done.stderr)
        self.assertIn(remedy, done.stderr)


if __name__ == '__main__':
    BOXES_TO = sys.argv.pop()
    unittest.main()
