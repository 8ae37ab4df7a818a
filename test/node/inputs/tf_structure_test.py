#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loops, changed parents, strange names, many frames: links that are not concerned stay exact."""
import rospy
import rostest
from arms_testing import ArmsTest
from bounds_testing import Pose, box_of, corners_of, difference, transform, turn
from node_testing import SIZES, TOLERANCE, arm_bounds, at_angles, joint_pose, shows
from patience import PATIENCE
from tf2_msgs.msg import TFMessage

LEFT = ["left", "left_tip"]
NO_LEFT = {"base": 0, "mast": 0, "right": 45}
LONG = 100000  # characters
FRAMES = 10000
PER_MESSAGE = 5000
DEEP = (2000, 20000)  # frames; tf2 reports a chain of more than a thousand as a loop
DEEP_TOLERANCE = 1e-9  # m; each frame adds a rounding error
DEEP_DEADLINE = 60.0 * PATIENCE  # wall seconds to send, receive and answer the largest message
PLACEHOLDER, NOT_UTF8 = b"not_utf8", b"\xff\xfe\x80\xc0\xaf\xed\xa0\x80"


class RawMessage(TFMessage):
    """Is sent with bytes in a name that rospy would not send."""

    def serialize(self, buff):
        begin = buff.tell()
        super().serialize(buff)
        data = buff.getvalue()[begin:].replace(PLACEHOLDER, NOT_UTF8)
        buff.seek(begin)
        buff.write(data)


class TfStructure(ArmsTest):
    def wait_for(self, degrees, incomplete=()):
        return self.boxes.wait(lambda m: shows(m, degrees, incomplete), "the expected boxes")

    def send(self, *parents_and_children):
        """A message of turned transforms, followed by one of the right arm."""
        stamp = self.next_stamp()
        self.boxes.clear()
        self.tf.send_transforms(*(transform(parent, child, stamp, (0, 0, 1), turn((0, 1, 0), 30))
                                  for parent, child in parents_and_children))
        self.tf.send(stamp, 45, ["right"])

    def check_nothing_changed(self):
        self.wait_for(at_angles(30, 45))
        self.assertEqual(len(self.boxes.messages), 1)

    def test_links_of_a_loop_are_incomplete_until_it_is_broken(self):
        self.send(("left_tip", "left"))
        self.wait_for(NO_LEFT, LEFT)
        self.send_good(45, 30)

    def test_a_loop_above_the_fixed_frame_does_not_matter(self):
        self.send(("base", "odom"), ("odom", "base"))
        self.wait_for(at_angles(30, 45))
        self.send_good(45, 30)
        self.send(("world", "odom"))
        self.send_good(30, 30)

    def test_a_loop_elsewhere_does_not_matter(self):
        self.send(("round", "go"), ("go", "round"), ("itself", "itself"))
        self.check_nothing_changed()

    def test_a_frame_without_a_way_to_the_fixed_frame_is_incomplete(self):
        self.send(("nowhere", "left"))
        self.wait_for(NO_LEFT, LEFT)
        self.send_good(45, 30)

    def test_a_reparented_frame_is_where_its_new_parent_is(self):
        stamp = self.next_stamp()
        base_from_left = joint_pose("mast", 0) * Pose((0, 0, 1), turn((0, 1, 0), 30))
        base_from_tip = base_from_left * joint_pose("left_tip", 45)
        self.tf.send_transforms(
            transform("mast", "left", stamp, (0, 0, 1), turn((0, 1, 0), 30)),
            self.tf.transform("left_tip", stamp, 45), self.tf.transform("right", stamp, 45))
        message = self.boxes.wait(lambda m: box_of(m, "right").stamp == stamp, "the new parent")
        self.assertEqual(message.incomplete, [])
        for name, expected in (("left", base_from_left.box_bounds(SIZES["left"])),
                               ("left_tip", base_from_tip.box_bounds(SIZES["left_tip"])),
                               ("right", arm_bounds("right", 45))):
            box = corners_of(box_of(message, name))
            self.assertLess(difference(box, expected), TOLERANCE, name)
        self.send_good(45, 30)

    def test_names_that_are_none_change_nothing(self):
        for parent, child in (("", "left"), ("base", ""), ("", ""), ("/", "left"), ("base", "/"),
                              ("left", "left"), ("/left", "left"), ("nobody", "NO_PARENT")):
            with self.subTest(parent=parent, child=child):
                self.send((parent, child))
                self.check_nothing_changed()
                self.send_good(30, 30)

    def test_long_and_strange_names_change_nothing(self):
        for name in ("x" * LONG, "/" * LONG, "left\n", "left ", "\x00left", "lëft", "%s%n"):
            with self.subTest(name=name[:10]):
                self.send((name + "_parent", name), ("base", name))
                self.check_nothing_changed()
                self.send_good(30, 30)

    def test_a_parent_with_a_long_name_is_a_parent(self):
        self.send(("base", "x" * LONG), ("x" * LONG, "left"))
        message = self.boxes.wait(lambda m: box_of(m, "right").stamp.secs == self.now, "the news")
        half_way = Pose((0, 0, 1), turn((0, 1, 0), 30))
        self.assertLess(difference(corners_of(box_of(message, "left")),
                                   (half_way * half_way).box_bounds(SIZES["left"])), TOLERANCE)

    def test_names_that_are_not_utf8_change_nothing(self):
        stamp = self.next_stamp()
        self.boxes.clear()
        name = PLACEHOLDER.decode()
        raw = RawMessage([transform("base", name, stamp), transform(name, "further", stamp)])
        self.tf.publish(raw)
        self.tf.send(stamp, 45, ["right"])
        self.check_nothing_changed()

    def test_a_slash_in_front_is_stripped_as_in_tf2(self):
        stamp = self.next_stamp()
        pose = joint_pose("left", 45)
        self.boxes.clear()
        self.tf.send_transforms(transform("/base", "/left", stamp, pose.xyz, pose.xyzw),
                                self.tf.transform("left_tip", stamp, 45))
        self.wait_for(at_angles(45, 30))

    def test_a_message_of_nothing_publishes_nothing(self):
        self.send()
        self.check_nothing_changed()

    def test_a_message_of_thousands(self):
        stamp = self.next_stamp()
        self.boxes.clear()
        others = [transform("base", "other_%d" % i, stamp) for i in range(PER_MESSAGE - 3)]
        self.tf.send_transforms(self.tf.transform("left", stamp, 45), *others,
                                self.tf.transform("left_tip", stamp, 45),
                                self.tf.transform("right", stamp, 45))
        self.wait_for(at_angles(45, 45))
        self.assertEqual(len(self.boxes.messages), 1)

    def test_a_message_of_thousands_of_one_frame_ends_at_the_newest(self):
        begin = self.next_stamp()
        stamps = [begin + rospy.Duration(0, 100000 * i) for i in range(PER_MESSAGE)]
        self.boxes.clear()
        self.tf.send_transforms(*(self.tf.transform("right", s, 30 + i % 15)
                                  for i, s in enumerate(stamps[:-1])),
                                self.tf.transform("right", stamps[-1], 45))
        message = self.wait_for(at_angles(30, 45))
        self.assertEqual(message.header.stamp, stamps[-1])

    def test_ten_thousand_frames_around_the_robot(self):
        for begin in range(0, FRAMES, 1000):
            self.send(*(("left_tip", "leaf_%d" % i) for i in range(begin, begin + 1000)))
        self.send_good(45, 30)

    def test_links_in_a_deep_chain_at_its_end_and_beside_it(self):
        for depth in DEEP:
            chain = ["base"] + ["step_%d" % i for i in range(depth)]
            middle, end = (0.01 * (depth // 2), 0, 0), (0.01 * depth, 0, 0)
            pose, tip = joint_pose("left", 45), joint_pose("left_tip", 45)
            stamp = self.next_stamp()
            self.boxes.clear()
            self.tf.send_transforms(
                *(transform(parent, child, stamp, (0.01, 0, 0))
                  for parent, child in zip(chain, chain[1:])),
                transform(chain[depth // 2], "left", stamp, pose.xyz, pose.xyzw),
                transform(chain[-1], "left_tip", stamp, tip.xyz, tip.xyzw),
                self.tf.transform("right", stamp, 45))
            message = self.boxes.wait(lambda m: m.header.stamp == stamp, "boxes", DEEP_DEADLINE)
            self.assertEqual(message.incomplete, [])
            for name, expected in (("left", (Pose(middle) * pose).box_bounds(SIZES["left"])),
                                   ("left_tip", (Pose(end) * tip).box_bounds(SIZES["left_tip"])),
                                   ("right", arm_bounds("right", 45)),
                                   ("mast", arm_bounds("mast", 0))):
                box = corners_of(box_of(message, name))
                self.assertLess(difference(box, expected), DEEP_TOLERANCE, (depth, name))
        self.send_good(45, 30)


if __name__ == "__main__":
    rospy.init_node("tf_structure_test")
    rostest.rosrun("link_bounds", "tf_structure", TfStructure)
