#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stamps and lifetimes of objects through clock jumps, reloads, and a clock very far ahead."""
import unittest

import rospy
import rostest
from bounds_testing import Recorder, at, box_of, load
from link_bounds.msg import BoxOverlapArray
from node_testing import ARMS, NODE, ArmsTf, Diagnostics, SimulatedClock
from object_testing import ObjectSender, marker
from visualization_msgs.msg import MarkerArray

FAR_AHEAD = 3.2e9  # s; a century, more than a ros::Duration holds


class ObjectTimes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.clock = SimulatedClock(Diagnostics())
        cls.tf = ArmsTf()
        cls.objects = ObjectSender(NODE)

    def setUp(self):
        self.clock.set(1000)
        load(NODE, ARMS, timeout=2.0)
        self.boxes.clear()
        self.tf.send(at(1000))
        self.boxes.wait(lambda m: box_of(m, "left") and box_of(m, "left").stamp == at(1000),
                        "the arms")
        self.boxes.clear()

    def tearDown(self):
        self.objects.clear()
        self.boxes.wait_newest(lambda m: not any("/" in box.name for box in m.boxes), "no object")

    def send_and_wait(self, *markers):
        self.objects.send(*markers)
        names = ["%s/%d" % (m.ns, m.id) for m in markers]
        self.boxes.wait(lambda m: all(box_of(m, name) for name in names), "objects")

    def test_after_a_jump_back_no_header_is_ahead_of_the_clock(self):
        overlaps = Recorder(NODE + "/overlaps", BoxOverlapArray)
        drawings = Recorder(NODE + "/markers", MarkerArray)
        self.send_and_wait(marker("scene/1", stamp=at(999)), marker("scene/2", stamp=at(998)))
        overlaps.wait(lambda m: m.header.stamp == at(1000), "a pair of the old era")
        self.boxes.clear()
        self.clock.publish(500)
        message = self.boxes.wait(lambda m: not box_of(m, "left"), "the jump")
        self.assertEqual([box_of(message, "scene/%d" % i).stamp for i in (1, 2)], [at(500)] * 2)
        self.assertEqual(message.header.stamp, at(500))
        overlaps.wait(lambda m: m.header.stamp == at(500) and m.overlaps, "a pair of the new era")
        drawings.wait(lambda m: m.markers and all(n.header.stamp == at(500) for n in m.markers),
                      "drawings of the new era")
        overlaps.subscriber.unregister()
        drawings.subscriber.unregister()

    def test_neither_reload_nor_jump_begins_a_lifetime_anew(self):
        self.send_and_wait(marker("brief/1", frame="left", lifetime=rospy.Duration(5)),
                           marker("brief/2", lifetime=rospy.Duration(5)),
                           marker("stays/1", lifetime=rospy.Duration(50)))
        for now in (1002, 1004):
            self.clock.set(now)
            load(NODE, timeout=2.0)
        self.clock.set(500)
        self.boxes.clear()
        self.clock.set(500.9)
        load(NODE, timeout=2.0)
        message = self.boxes.wait(lambda m: True, "boxes of the new era")
        self.assertIsNotNone(box_of(message, "brief/2"))
        self.boxes.clear()
        self.clock.set(501.1)
        message = self.boxes.wait(lambda m: not box_of(m, "brief/2"), "the end of both")
        self.assertNotIn("brief/1", message.incomplete)
        self.assertIsNotNone(box_of(message, "stays/1"))

    def test_a_clock_very_far_ahead_ends_lifetimes_and_makes_links_stale(self):
        self.send_and_wait(marker("brief/1", lifetime=rospy.Duration(5)), marker("stays/1"))
        self.clock.set(FAR_AHEAD)
        self.boxes.wait(lambda m: not box_of(m, "brief/1") and "left" in m.incomplete and
                        box_of(m, "stays/1"), "lifetime over, left arm stale")


if __name__ == "__main__":
    rospy.init_node("object_times_test")
    rostest.rosrun("link_bounds", "object_times", ObjectTimes)
