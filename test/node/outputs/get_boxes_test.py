#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~get_boxes: boxes at any time of tf's history, in any frame, of some names; and what it refuses.
"""
import rospy
import rostest
from arms_testing import ArmsTest
from bounds_testing import (DEADLINE, Pose, box_link, box_of, corners_of, difference, load,
                            names_of, robot, visual)
from link_bounds.srv import GetBoxes, GetBoxesRequest
from node_testing import ALL, DYNAMIC, NODE, SIZES, STATIC, arm_bounds, joint_pose, shows
from object_testing import ObjectSender, marker, shows_box

NEAR = 1e-9  # m: tf2 interpolates an angle, the test computes it


def time_of(seconds):
    """To the nanosecond."""
    return rospy.Time(0, round(seconds * 1e9))


class GetBoxesTest(ArmsTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rospy.wait_for_service(NODE + "/get_boxes", DEADLINE)
        cls.call = rospy.ServiceProxy(NODE + "/get_boxes", GetBoxes, persistent=True)
        cls.objects = ObjectSender(NODE)

    def send_objects(self, *markers):
        """They are gone after the test. Returns when ~boxes names all of them."""
        self.addCleanup(self.boxes.wait_newest, lambda m: names_of(m) == ALL and not m.incomplete,
                        "no objects")
        self.addCleanup(self.objects.clear)
        self.objects.send(*markers)
        names = {"%s/%d" % (m.ns, m.id) for m in markers}
        return self.boxes.wait_newest(
            lambda m: names <= set(names_of(m)) | set(m.incomplete), "objects")

    def ask(self, stamp=0, span=0, frame="", names=()):
        return self.call(GetBoxesRequest(
            stamp=time_of(stamp), span=rospy.Duration.from_sec(span), frame=frame,
            names=list(names)))

    def answer(self, *args, **kwargs):
        """The boxes; all of them, if nothing else is expected."""
        answer = self.ask(*args, **kwargs)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.message == "", not answer.boxes.incomplete, answer.message)
        return answer.boxes

    def turn_arms(self):
        """Sends 30 and then 60 degrees; returns both stamps in seconds."""
        self.send_good(30, 30)
        first = self.now
        self.send_good(60, 60)
        return first, self.now

    def refuse(self, *words, **request):
        answer = self.ask(**request)
        self.assertFalse(answer.success)
        self.assertEqual((answer.boxes.boxes, answer.boxes.incomplete), ([], []))
        for word in words:
            self.assertIn(word, answer.message)

    def test_between_two_stamps(self):
        first, second = self.turn_arms()
        for part in (0.0, 0.25, 0.5, 0.9, 1.0):
            stamp = time_of(first + part)
            boxes = self.answer(first + part)
            self.assertEqual(names_of(boxes), ALL)
            self.assertEqual((boxes.header.stamp, boxes.header.frame_id), (stamp, "base"))
            for box in boxes.boxes:
                self.assertEqual(box.stamp, rospy.Time() if box.name in STATIC else stamp)
                angle = 0 if box.name in STATIC else 30 + 30 * part
                self.assertLess(difference(corners_of(box), arm_bounds(box.name, angle)), NEAR)
        self.assertEqual(second, first + 1)

    def test_the_latest_are_those_of_boxes(self):
        self.send_good(30, 40)
        expected = self.boxes.messages[-1]
        for frame in ("", "base", "/base"):
            boxes = self.answer(frame=frame)
            self.assertEqual((boxes.boxes, boxes.incomplete), (expected.boxes, []))
            self.assertEqual(boxes.header.stamp, expected.header.stamp)

    def test_in_the_frame_of_a_moving_link(self):
        first, _ = self.turn_arms()
        for stamp, angle in ((0, 60), (first, 30), (first + 0.5, 45)):
            boxes = self.answer(stamp, frame="left_tip")
            self.assertEqual(boxes.header.frame_id, "left_tip")
            self.assertLess(difference(corners_of(box_of(boxes, "left_tip")),
                                       Pose().box_bounds(SIZES["left_tip"])), NEAR)
            tip = joint_pose("left", angle) * joint_pose("left_tip", angle)
            for name in ("right", "mast"):
                pose = tip.inverse() * joint_pose(name, angle)
                self.assertLess(difference(corners_of(box_of(boxes, name)),
                                           pose.box_bounds(SIZES[name])), NEAR)

    def test_before_the_history_and_after_its_end(self):
        first, second = self.turn_arms()
        for stamp in (first - 20, second + 0.001):
            answer = self.ask(stamp)
            self.assertTrue(answer.success)
            self.assertTrue(shows(answer.boxes, {"base": 0, "mast": 0}, DYNAMIC))
            for words in ('left: no transform from "left" to "base" at %r' % float(stamp),
                          "reaches from", "to %r" % float(second), "2 more"):
                self.assertIn(words, answer.message)

    def test_only_the_paths_that_are_needed_count(self):
        self.send_good(30, 30)
        stamp = self.next_stamp()
        self.boxes.clear()
        self.tf.send(stamp, 60, ["right"])
        self.boxes.wait(lambda m: box_of(m, "right").stamp == stamp, "right alone")
        answer = self.ask(self.now)
        self.assertEqual(answer.boxes.incomplete, ["left", "left_tip"])
        self.assertEqual(names_of(answer.boxes), ["base", "mast", "right"])
        boxes = self.answer()
        self.assertEqual([box.stamp.to_sec() for box in boxes.boxes],
                         [0, 0, self.now - 1, self.now - 1, self.now])

    def test_names(self):
        self.send_objects(marker("crate/2"), marker("crate/10"))
        boxes = self.answer(names=["right", "crate/10", "base", "right", "crate/2"])
        self.assertEqual(names_of(boxes), ["base", "right", "crate/2", "crate/10"])

    def test_objects_of_the_past(self):
        first, second = self.turn_arms()
        size = (0.1, 0.2, 0.3)
        latest = self.send_objects(
            marker("held/1", scale=size, frame="left"),
            marker("fixed/1", scale=size, frame="left", stamp=time_of(first)))
        boxes = self.answer(first + 0.5)
        self.assertTrue(shows_box(boxes, "held/1", joint_pose("left", 45).box_bounds(size)))
        placed = joint_pose("left", 30)
        self.assertTrue(shows_box(boxes, "fixed/1", placed.box_bounds(size)))
        self.assertEqual(box_of(boxes, "fixed/1").stamp, time_of(first))
        self.assertEqual(self.answer().boxes, latest.boxes)
        in_left = self.answer(second, frame="left")
        self.assertTrue(shows_box(in_left, "held/1", Pose().box_bounds(size)))
        moved = joint_pose("left", 60).inverse() * placed
        self.assertTrue(shows_box(in_left, "fixed/1", moved.box_bounds(size)))
        self.assertEqual(box_of(in_left, "fixed/1").stamp, time_of(second))

    def test_objects_without_a_box(self):
        self.send_objects(marker("far/1", frame="nowhere"), marker("bad/1", kind=77))
        for stamp in (0, self.now):
            answer = self.ask(stamp)
            self.assertEqual(answer.boxes.incomplete, ["bad/1", "far/1"])
            self.assertEqual(names_of(answer.boxes), ALL)
            self.assertIn("bad/1: ", answer.message)
        self.refuse('"nowhere"', frame="nowhere")

    def test_the_message_explains_the_first_incomplete_name(self):
        """Also if that one has a box."""
        base = '<link name="base">%s%s</link>' % (
            visual('<box size="1 1 1"/>'), visual('<mesh filename="file:///none/missing.stl"/>'))
        load(NODE, robot([base, box_link("unsent", (1, 1, 1))], [("base", "unsent")]))
        for stamp in (0, self.now):
            answer = self.ask(stamp)
            self.assertEqual(answer.boxes.incomplete, ["base", "unsent"])
            self.assertEqual(names_of(answer.boxes), ["base"])
            self.assertTrue(answer.message.startswith("base: "), answer.message)
            self.assertIn("missing.stl", answer.message)
            self.assertTrue(answer.message.endswith("; incomplete are 1 more"), answer.message)

    def test_padding(self):
        load(NODE, padding=0.5)
        self.send_good_padded()
        bare = arm_bounds("left", 30)
        box = corners_of(box_of(self.answer(self.now), "left"))
        self.assertLess(difference(box, [c + (-0.5 if i < 3 else 0.5)
                                         for i, c in enumerate(bare)]), NEAR)

    def send_good_padded(self):
        stamp = self.next_stamp()
        self.tf.send(stamp, 30)
        self.boxes.wait(lambda m: m.header.stamp == stamp, "padded boxes")

    def test_a_span(self):
        """Contains what the boxes at its times contain."""
        first, second = self.turn_arms()
        swept = self.answer(second, span=1.0)
        for box in swept.boxes:
            for part in range(11):
                inner = corners_of(box_of(self.answer(first + part / 10, names=[box.name]),
                                          box.name))
                outer = corners_of(box)
                self.assertTrue(all(outer[i] <= inner[i] + NEAR for i in range(3)), box.name)
                self.assertTrue(all(outer[i] >= inner[i] - NEAR for i in range(3, 6)), box.name)
        self.assertEqual(swept.boxes, self.answer(0, span=1.0).boxes)

    def test_a_span_longer_than_the_history(self):
        self.turn_arms()
        answer = self.ask(self.now, span=100.0)
        self.assertTrue(answer.success)
        self.assertTrue(shows(answer.boxes, {"base": 0, "mast": 0}, DYNAMIC))
        self.assertIn("left: ", answer.message)

    def test_what_is_refused(self):
        self.refuse("span", "-0.5", "0 or more", span=-0.5)
        self.refuse('"nowhere"', "frame", '"base"', frame="nowhere")
        self.refuse('"bare"', "without geometry", names=["bare"])
        self.refuse('"lefty"', '"crate/7"', "~boxes", names=["left", "lefty", "crate/7"])

    def test_a_request_of_too_many_bytes_is_refused(self):
        self.refuse("the request has ", " bytes, more than 33554432; ask for fewer names",
                    names=["x" * (33 << 20)])

    def test_hostile_names_are_one_line(self):
        answer = self.ask(frame="a\nb\x1b[2J")
        self.assertFalse(answer.success)
        self.assertTrue(answer.message.isprintable(), answer.message)

    def test_names_that_are_asked_for_do_not_become_frames(self):
        for _ in range(2):
            self.refuse("never_sent", frame="never_sent")


if __name__ == "__main__":
    rospy.init_node("get_boxes_test")
    rostest.rosrun("link_bounds", "get_boxes", GetBoxesTest)
