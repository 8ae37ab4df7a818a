#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes follow the axes of the fixed frame, wherever it is in the tree of tf.

map -> odom -> base -> arm -> gripper and map -> camera; every step is turned.
"""
import math
import unittest

import rospy
import rostest

from bounds_testing import (Pose, TfSender, box_link, box_of, corners_of, difference, latched,
                            load, names_of, robot, transform, turn, wait_for)

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-9  # metres
STAMP = rospy.Time(1000)
BASE, ARM, GRIPPER = (1.0, 2.0, 3.0), (0.2, 0.3, 0.4), (0.1, 0.1, 0.5)
DESCRIPTION = robot(
    [box_link("base", BASE), box_link("arm", ARM), box_link("gripper", GRIPPER)],
    [("base", "arm"), ("arm", "gripper")])
MAP_FROM_ODOM = Pose((10.0, 0.0, 0.0), turn((0, 0, 1), 30))
ODOM_FROM_BASE = Pose((0.0, 5.0, 0.25), turn((0, 1, 0), 45))
BASE_FROM_ARM = Pose((0.0, 0.0, 2.0), turn((0, 0, 1), 30))
ARM_FROM_GRIPPER = Pose((0.5, 0.0, 0.0), turn((1, 0, 0), 45))
MAP_FROM_CAMERA = Pose((-3.0, 1.0, 4.0), turn((1, 1, 1), 30))
MAP_FROM_BASE = MAP_FROM_ODOM * ODOM_FROM_BASE


def boxes_from(frame_from_base):
    """The three boxes as seen from a frame: the corners of each, moved."""
    frame_from_arm = frame_from_base * BASE_FROM_ARM
    return {"base": frame_from_base.box_bounds(BASE), "arm": frame_from_arm.box_bounds(ARM),
            "gripper": (frame_from_arm * ARM_FROM_GRIPPER).box_bounds(GRIPPER)}


class FixedFrameTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("fixed_frame_test")
        tf = TfSender()
        tf.wait_for_listener()
        tf.send(*[transform(parent, child, STAMP, pose.xyz, pose.xyzw)
                  for parent, child, pose in (
                      ("map", "odom", MAP_FROM_ODOM), ("odom", "base", ODOM_FROM_BASE),
                      ("base", "arm", BASE_FROM_ARM), ("arm", "gripper", ARM_FROM_GRIPPER),
                      ("map", "camera", MAP_FROM_CAMERA))])
        load(NODE, DESCRIPTION)
        wait_for(lambda: len(latched(NODE + "/boxes").boxes) == 3, "tf has arrived")

    def load_frame(self, frame):
        """~boxes after a reload."""
        load(NODE, fixed_frame=frame)
        message = latched(NODE + "/boxes")
        self.assertEqual(message.header.frame_id, frame or "base")
        return message

    def check_boxes(self, message, expected):
        self.assertEqual((names_of(message), message.incomplete), (list(expected), []))
        for name, box in expected.items():
            self.assertLess(difference(corners_of(box_of(message, name)), box), TOLERANCE, name)

    def test_above_the_root(self):
        self.check_boxes(self.load_frame("map"), boxes_from(MAP_FROM_BASE))
        self.check_boxes(self.load_frame("odom"), boxes_from(ODOM_FROM_BASE))

    def test_beside_the_root(self):
        self.check_boxes(self.load_frame("camera"),
                         boxes_from(MAP_FROM_CAMERA.inverse() * MAP_FROM_BASE))

    def test_below_the_root(self):
        base_from_gripper = BASE_FROM_ARM * ARM_FROM_GRIPPER
        message = self.load_frame("gripper")
        self.check_boxes(message, boxes_from(base_from_gripper.inverse()))
        own = [s / 2 for s in GRIPPER]
        self.assertLess(difference(corners_of(box_of(message, "gripper")),
                                   [-x for x in own] + own), TOLERANCE)

    def test_numbers_by_hand(self):
        """In base, arm is 0.2 x 0.3 x 0.4 at z = 2, turned by 30 degrees about z."""
        cosine, sine = math.sqrt(3) / 2, 0.5
        x, y = 0.1 * cosine + 0.15 * sine, 0.1 * sine + 0.15 * cosine
        box = box_of(self.load_frame(""), "arm")
        self.assertLess(difference(corners_of(box), [-x, -y, 1.8, x, y, 2.2]), TOLERANCE)

    def test_default_is_the_root(self):
        self.check_boxes(self.load_frame(""), boxes_from(Pose()))

    def test_groups_have_the_same_frame(self):
        for frame in ("camera", "odom"):
            self.load_frame(frame)
            self.assertEqual(latched(NODE + "/groups").header.frame_id, frame)

    def test_unknown_frame_is_waited_for(self):
        message = self.load_frame("world")
        self.assertEqual((message.boxes, message.incomplete), ([], ["base", "arm", "gripper"]))
        world_from_map = Pose((0.0, 0.0, 7.0), turn((1, 0, 0), 45))
        tf = TfSender()
        tf.send(transform("world", "map", STAMP, world_from_map.xyz, world_from_map.xyzw))
        wait_for(lambda: latched(NODE + "/boxes").boxes, "world has become known")
        self.check_boxes(latched(NODE + "/boxes"), boxes_from(world_from_map * MAP_FROM_BASE))


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "fixed_frame", FixedFrameTest)
