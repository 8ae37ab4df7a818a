#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""cloud_demo.launch: the arm goes, the cup between its fingers and the table stay."""
import unittest

import numpy
import rospy
import rostest
import tf2_ros
from bounds_testing import Recorder
from sensor_msgs.msg import PointCloud2

BETWEEN = 0.04  # m; the cup's points are so near to the middle between the fingers
FEW = 50


def points(message):
    """An array of rows of x, y, z."""
    return numpy.frombuffer(message.data, '<f4').reshape(-1, 4)[:, :3].astype(float)


def rotation(q):
    x, y, z, w = q.x, q.y, q.z, q.w
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class CloudDemo(unittest.TestCase):
    def setUp(self):
        self.tf = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.tf)
        self.before = Recorder('/depth_camera/points', PointCloud2)
        self.after = Recorder('/cloud_filter/output', PointCloud2)

    def places_in(self, frame, message):
        """The points in that frame, at the time of the cloud."""
        transform = self.tf.lookup_transform(frame, 'depth_camera', message.header.stamp,
                                             rospy.Duration(10)).transform
        t = transform.translation
        return points(message) @ rotation(transform.rotation).T + (t.x, t.y, t.z)

    def counts(self, after):
        """Points of the hand, cup and table that the camera sees, and those of them that stay."""
        before = self.before.wait(lambda m: m.header.stamp == after.header.stamp, 'its input')
        stays = numpy.isfinite(points(after)[:, 0])
        hand = self.places_in('gripper', before)
        with numpy.errstate(invalid='ignore'):
            is_cup = ((numpy.hypot(hand[:, 0], hand[:, 1]) < BETWEEN) &
                      (hand[:, 2] > 0.084) & (hand[:, 2] < 0.166))
            is_finger = ((abs(hand[:, 1]) > 0.05) & (abs(hand[:, 1]) < 0.1) &
                         (abs(hand[:, 0]) < 0.02) & (hand[:, 2] > 0.06) & (hand[:, 2] < 0.18))
            is_table = self.places_in('base', before)[:, 2] < -0.015
        return [(part.sum(), (part & stays).sum()) for part in (is_cup, is_finger, is_table)]

    def test_the_cup_stays(self):
        seen = numpy.zeros((3, 2), dtype=int)
        end = rospy.get_time() + 60
        while (seen[:, 0] < FEW).any() and rospy.get_time() < end:
            self.after.clear()
            after = self.after.wait(lambda _: True, 'a filtered cloud')
            try:
                seen += self.counts(after)
            except tf2_ros.TransformException:
                continue  # a cloud from before this test listened to tf
        (cup, cup_left), (finger, finger_left), (table, table_left) = seen
        self.assertGreaterEqual(min(cup, finger, table), FEW)
        self.assertEqual(cup_left, cup)
        self.assertEqual(finger_left, 0)
        self.assertEqual(table_left, table)


if __name__ == '__main__':
    rospy.init_node('cloud_demo_test')
    rostest.rosrun('link_bounds', 'cloud_demo_test', CloudDemo)
