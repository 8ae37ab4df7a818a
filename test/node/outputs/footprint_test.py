#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~footprint as costmap_2d reads it: in the robot's base frame, wherever that is in odom."""
import itertools
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, load, transform, turn, union, wait_for
from geometry_msgs.msg import Polygon
from node_testing import ALL, ARMS, DYNAMIC, NODE, ArmsTf, arm_bounds

TOLERANCE = 1e-6  # metres; float32
TOPIC = NODE + "/footprint"


def rectangle(degrees):
    low_x, low_y, _, high_x, high_y, _ = union([arm_bounds(name, degrees) for name in ALL])
    return [(low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y)]


def is_rectangle(polygon, degrees):
    expected = rectangle(degrees)
    return len(polygon.points) == 4 and all(
        abs(p.x - x) < TOLERANCE and abs(p.y - y) < TOLERANCE and p.z == 0
        for p, (x, y) in zip(polygon.points, expected))


class FootprintTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seconds = itertools.count(1000)
        cls.tf = ArmsTf()
        cls.odom = TfSender()
        cls.odom.wait_for_listener()

    def setUp(self):
        load(NODE, ARMS, fixed_frame="base")

    def next_stamp(self):
        return rospy.Time(next(self.seconds))

    def turn_robot(self, stamp):
        self.odom.send(transform("odom", "base", stamp, (3, 4, 0), turn((0, 0, 1), 30)))

    def test_follows_the_robot_in_its_own_frame(self):
        footprints = Recorder(TOPIC, Polygon)
        wait_for(lambda: footprints.subscriber.get_num_connections() > 0, "connected")
        for degrees in (0, 30, 45):
            stamp = self.next_stamp()
            self.turn_robot(stamp)
            footprints.clear()
            self.tf.send(stamp, degrees)
            footprints.wait(lambda p, d=degrees: is_rectangle(p, d), "arms at %g" % degrees)
        footprints.subscriber.unregister()

    def test_a_new_subscriber_gets_one_at_once(self):
        boxes = Recorder(NODE + "/boxes")
        stamp = self.next_stamp()
        self.tf.send(stamp, 30)
        boxes.wait(lambda m: m.header.stamp == stamp and not m.incomplete, "all boxes")
        polygon = rospy.wait_for_message(TOPIC, Polygon, 20)
        self.assertTrue(is_rectangle(polygon, 30), polygon)
        boxes.subscriber.unregister()

    def test_silent_while_a_link_is_missing(self):
        load(NODE, ARMS, fixed_frame="base", timeout=0.5)
        boxes = Recorder(NODE + "/boxes")
        boxes.wait(lambda m: "left" in m.incomplete, "the arms are stale")
        footprints = Recorder(TOPIC, Polygon)
        wait_for(lambda: footprints.subscriber.get_num_connections() > 0, "connected")
        others = [link for link in DYNAMIC if link != "right"]
        for _ in range(20):
            stamp = self.next_stamp()
            self.tf.send(stamp, 45, others)
        boxes.wait(lambda m: m.header.stamp == stamp and m.incomplete == ["right"],
                   "all but one box")
        self.tf.send(self.next_stamp(), 60)
        footprints.wait(lambda p: is_rectangle(p, 60), "complete again")
        self.assertTrue(is_rectangle(footprints.messages[0], 60), "one came while it was not")
        footprints.subscriber.unregister()
        boxes.subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("footprint_test")
    rostest.rosrun("link_bounds", "footprint", FootprintTest)
