#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Without moving joints everything is sent once, latched, with stamp 0."""
import unittest

import rospy
import rostest

from bounds_testing import (Pose, Recorder, TfSender, box_link, box_of, corners_of, difference,
                            latched, load, names_of, robot, transform, turn, union, wait_for)

NODE = "/link_bounds_publisher"
LONELY = "/lonely/link_bounds_publisher"
TOLERANCE = 1e-9  # metres
ZERO = rospy.Time(0)
BASE, ARM, TIP = (1.0, 2.0, 3.0), (0.2, 0.3, 0.4), (0.1, 0.1, 0.5)
DESCRIPTION = robot(
    [box_link("base", BASE), box_link("arm", ARM), box_link("tip", TIP)],
    [("base", "arm"), ("arm", "tip")]).replace("floating", "fixed")
BASE_FROM_ARM = Pose((1.0, 0.0, 0.5), turn((0, 0, 1), 30))
ARM_FROM_TIP = Pose((0.0, 0.25, 0.0), turn((1, 0, 0), 45))
EXPECTED = [Pose().box_bounds(BASE), BASE_FROM_ARM.box_bounds(ARM),
            (BASE_FROM_ARM * ARM_FROM_TIP).box_bounds(TIP)]


def edge(parent, child, pose):
    return transform(parent, child, ZERO, pose.xyz, pose.xyzw)


TRANSFORMS = [edge("base", "arm", BASE_FROM_ARM), edge("arm", "tip", ARM_FROM_TIP)]


class StaticOnlyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("static_only_test")
        rospy.set_param("/lonely/robot_description", robot([box_link("alone", BASE)], []))
        load(NODE, DESCRIPTION)
        cls.tf = TfSender(is_static=True)
        cls.tf.wait_for_listener()
        cls.tf.send(*TRANSFORMS)
        wait_for(lambda: not latched(NODE + "/boxes").incomplete, "all boxes")

    def check_boxes(self, message):
        self.assertEqual(names_of(message), ["base", "arm", "tip"])
        for box, expected in zip(message.boxes, EXPECTED):
            self.assertLess(difference(corners_of(box), expected), TOLERANCE, box.name)

    def test_late_subscriber_gets_the_boxes(self):
        message = latched(NODE + "/boxes")
        self.assertEqual(message.incomplete, [])
        self.check_boxes(message)

    def test_late_subscriber_gets_the_groups(self):
        message = latched(NODE + "/groups")
        self.assertEqual((names_of(message), message.incomplete), (["robot"], []))
        self.assertLess(difference(corners_of(message.boxes[0]), union(EXPECTED)), TOLERANCE)

    def test_stamps_are_zero(self):
        for topic in ("/boxes", "/groups"):
            message = latched(NODE + topic)
            self.assertEqual(message.header.stamp, ZERO)
            self.assertEqual({box.stamp for box in message.boxes}, {ZERO})

    def test_repeated_static_message_publishes_nothing(self):
        higher = Pose((1.0, 0.0, 1.5), BASE_FROM_ARM.xyzw)
        boxes = Recorder(NODE + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        boxes.wait(lambda m: True, "the latched message")
        self.tf.send(*TRANSFORMS)
        self.tf.send(*TRANSFORMS)
        self.tf.send(edge("base", "arm", higher))  # news that comes after the repetition
        boxes.wait(lambda m: box_of(m, "arm") and box_of(m, "arm").max.z > 1.0, "the news")
        self.assertEqual(len(boxes.messages), 2)
        self.tf.send(*TRANSFORMS)
        boxes.wait(lambda m: m is boxes.messages[-1] and box_of(m, "arm").max.z < 1.0,
                        "the old place")
        self.assertEqual(len(boxes.messages), 3)

    def test_link_without_any_tf_has_its_box(self):
        message = latched(LONELY + "/boxes")
        self.assertEqual((names_of(message), message.incomplete), (["alone"], []))
        self.assertEqual((message.header.frame_id, message.header.stamp), ("alone", ZERO))
        self.assertLess(difference(corners_of(message.boxes[0]), EXPECTED[0]), TOLERANCE)


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "static_only", StaticOnlyTest)
