#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers in tf that are no pose: refused as by tf2, logged once, without effect on other links."""
import math

import rospy
import rostest
from arms_testing import ArmsTest
from bounds_testing import (Recorder, TfSender, box_of, corners_of, difference, transform,
                            wait_for)
from node_testing import ARMS, TOLERANCE, NodeProcess, arm_bounds, at_angles, shows

HUGE = 1e300  # m
LARGEST = 1.7e308  # m; twice as much is not finite
RELATIVE = 1e-12
FLOOD = 2000


class TfNumbers(ArmsTest):
    def changed(self, child="left", degrees=45, scale=1.0, **translation):
        """A transform with a quaternion of another length or other coordinates."""
        result = self.tf.transform(child, rospy.Time(self.now + 1), degrees)
        q = result.transform.rotation
        q.x, q.y, q.z, q.w = (scale * c for c in (q.x, q.y, q.z, q.w))
        for axis, value in translation.items():
            setattr(result.transform.translation, axis, value)
        return result

    def send_beside_good(self, *bad):
        """One message with bad transforms, followed by the right arm at 45 degrees."""
        stamp = self.next_stamp()
        self.boxes.clear()
        self.tf.send_transforms(*bad, self.tf.transform("right", stamp, 45))

    def test_refused_quaternions_leave_the_arm_where_it_was(self):
        for scale in (0.0, 1e-300, 0.9, 0.99, 1.02, 2.0, 1e300, math.inf, math.nan):
            with self.subTest(scale=scale):
                self.send_beside_good(self.changed(scale=scale))
                self.boxes.wait(lambda m: shows(m, at_angles(30, 45)), "the right arm alone")
                self.send_good(30, 30)

    def test_quaternions_that_are_nearly_unit_are_normalised(self):
        for scale in (0.996, 1.004):
            with self.subTest(scale=scale):
                self.send_beside_good(self.changed(scale=scale))
                message = self.boxes.wait(lambda m: box_of(m, "right").stamp.secs == self.now,
                                          "the message")
                self.assertLess(difference(corners_of(box_of(message, "left")),
                                           arm_bounds("left", 45)), TOLERANCE)
                self.send_good(30, 30)

    def test_huge_coordinates_are_coordinates(self):
        self.send_beside_good(self.changed(y=-HUGE), self.changed("left_tip"))
        message = self.boxes.wait(lambda m: box_of(m, "left").min.y < 0.5 * -HUGE, "a far box")
        self.assertEqual(message.incomplete, [])
        for name in ("left", "left_tip"):
            box = box_of(message, name)
            self.assertLessEqual(box.min.y, -HUGE)
            self.assertGreaterEqual(box.max.y, -HUGE)
            self.assertLess(box.max.y - box.min.y, RELATIVE * HUGE)
        self.assertLess(difference(corners_of(box_of(message, "right")),
                                   arm_bounds("right", 45)), TOLERANCE)
        self.send_good(45, 30)

    def test_what_overflows_is_incomplete_until_it_is_back(self):
        self.tf.send_transforms(self.changed(x=LARGEST))
        self.send_beside_good(self.changed("left_tip", x=LARGEST))
        message = self.boxes.wait(lambda m: m.incomplete, "the loss")
        self.assertEqual(message.incomplete, ["left_tip"])
        self.assertIsNone(box_of(message, "left_tip"))
        self.assertTrue(all(map(math.isfinite, corners_of(box_of(message, "left")))))
        self.assertLess(difference(corners_of(box_of(message, "right")),
                                   arm_bounds("right", 45)), TOLERANCE)
        self.send_good(45, 30)

    def test_infinity_takes_the_arm_alone(self):
        for translation in ({"x": math.inf}, {"y": -math.inf, "z": math.inf}):
            with self.subTest(**translation):
                self.send_beside_good(self.changed(**translation))
                self.boxes.wait(lambda m: shows(m, {"base": 0, "mast": 0, "right": 45},
                                                ["left", "left_tip"]), "the loss")
                self.send_good(45, 30)

    def test_a_flood_of_nan_is_one_line(self):
        rospy.set_param("/robot_description", ARMS)
        node = NodeProcess("flooded")
        self.addCleanup(node.end)
        boxes = Recorder(node.name + "/boxes")
        boxes.wait(lambda m: True, "the node has started")
        flood = TfSender()
        wait_for(lambda: flood.listeners() == 2, "both nodes listen")
        for _ in range(FLOOD):
            flood.send(transform("base", "flooded_frame", self.next_stamp(), (math.nan, 0, 0)))
        flood.send(self.tf.transform("left", self.next_stamp(), 45))
        boxes.wait(lambda m: box_of(m, "left"), "the news behind the flood")
        lines = [line for line in node.output.splitlines() if "flooded_frame" in line]
        self.assertEqual(len(lines), 1, lines)
        for word in ("WARN", "NaN", rospy.get_name()):
            self.assertIn(word, lines[0])
        self.assertNotIn("TF_", node.output)


if __name__ == "__main__":
    rospy.init_node("tf_numbers_test")
    rostest.rosrun("link_bounds", "tf_numbers", TfNumbers)
