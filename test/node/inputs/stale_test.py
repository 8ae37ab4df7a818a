#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A link whose transforms stop loses its box until they come again; other links keep theirs."""
import time
import unittest

import rospy
import rostest
from bounds_testing import Recorder, corners_of, box_of, difference, load, names_of
from node_testing import ALL, ARMS, DYNAMIC, NODE, STATIC, ArmsTf, Repeater, arm_bounds

TOLERANCE = 1e-12  # m
TIMEOUT = 0.5  # ROS seconds
STAMPS_BEHIND = rospy.Duration(100)  # only the time of arrival counts, not the stamp
STALE_LIMIT = 5.0  # wall seconds until a stale link must be gone, on a busy machine


class Stale(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.tf = ArmsTf()

    def setUp(self):
        self.links = list(DYNAMIC)
        self.sender = Repeater(50, self.send)
        self.addCleanup(self.sender.stop)
        load(NODE, ARMS, timeout=TIMEOUT)
        self.wait_for(ALL)

    def send(self):
        if "left" in self.links:
            self.left_sent = time.monotonic()
        self.tf.send(rospy.Time.now() - STAMPS_BEHIND, links=self.links)

    def wait_for(self, names):
        self.boxes.clear()
        return self.boxes.wait(lambda m: names_of(m) == names, "boxes of %s" % names, STALE_LIMIT)

    def test_links_below_a_silent_edge_go_and_come_back(self):
        self.links.remove("left")
        message = self.wait_for(STATIC + ["right"])
        self.assertGreater(time.monotonic() - self.left_sent, TIMEOUT / 2)
        self.assertEqual(message.incomplete, ["left", "left_tip"])
        self.links.append("left")
        message = self.wait_for(ALL)
        self.assertEqual(message.incomplete, [])
        self.assertLess(difference(corners_of(box_of(message, "left_tip")),
                                   arm_bounds("left_tip", 30)), TOLERANCE)

    def test_only_static_links_outlast_silence(self):
        self.sender.stop()
        message = self.wait_for(STATIC)
        self.assertEqual(message.incomplete, DYNAMIC)

    def test_timeout_zero_keeps_boxes(self):
        load(NODE, ARMS, timeout=0.0)
        self.sender.stop()
        self.boxes.clear()
        load(NODE, ARMS, timeout=0.0)
        self.boxes.wait(lambda m: names_of(m) == ALL, "boxes after the reload")
        end = time.monotonic() + 2 * TIMEOUT
        self.boxes.wait(lambda m: time.monotonic() > end, "the time")
        self.assertTrue(all(names_of(m) == ALL for m in self.boxes.messages))


if __name__ == "__main__":
    rospy.init_node("stale_test")
    rostest.rosrun("link_bounds", "stale", Stale)
