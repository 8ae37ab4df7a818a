#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clock jumps: what is forgotten, what is kept, and that nothing of the old era returns."""
import itertools
import time
import unittest

import rospy
import rostest
from bounds_testing import (NodeLog, Recorder, at, box_of, corners_of, difference, load, names_of,
                            wait_for)
from diagnostic_msgs.msg import DiagnosticStatus
from node_testing import (ALL, ARMS, DYNAMIC, NODE, STATIC, ArmsTf, Diagnostics, Repeater,
                          SimulatedClock, arm_bounds, value_of)
from patience import PATIENCE
from rosgraph_msgs.msg import Log

TOLERANCE = 1e-12  # m
BACK_AGAIN = 0.5 * PATIENCE  # wall seconds in which boxes of the new era must appear
TRIES = 3  # a busy machine may take longer, but not each time
JUMPS = 10
DOUBT = 0.5  # wall seconds after a jump in which stamps far ahead are dropped


class TimeJump(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.diagnostics = Diagnostics()
        cls.clock = SimulatedClock(cls.diagnostics)
        cls.tf = ArmsTf()
        cls.now = 0
        load(NODE, ARMS, timeout=2.0)

    def setUp(self):
        TimeJump.now += 1000
        self.clock.set(self.now)
        self.tf.send(at(self.now))
        self.wait_for_all(self.now)
        self.boxes.clear()

    def wait_for_all(self, seconds, degrees=30):
        """Waits for all boxes at that time and checks them."""
        message = self.boxes.wait(
            lambda m: names_of(m) == ALL and box_of(m, "left").stamp == at(seconds),
            "all boxes of time %g" % seconds)
        self.assertEqual(message.incomplete, [])
        for name in ALL:
            box = corners_of(box_of(message, name))
            self.assertLess(difference(box, arm_bounds(name, degrees)), TOLERANCE, name)

    def jump_back(self):
        """By 5 s; returns the new time as soon as the node has noticed the jump."""
        new_now = self.now - 5
        self.clock.publish(new_now)
        message = self.boxes.wait(lambda m: "left" not in names_of(m), "loss of dynamic boxes")
        self.assertEqual((names_of(message), message.incomplete), (STATIC, DYNAMIC))
        return new_now

    def dropped(self, status=None):
        """How many transforms were dropped after jumps, as this status says or a new one."""
        status = status or self.diagnostics.wait_for_new(lambda _, s: True, "a status")
        return int(value_of(status, "transforms dropped after a clock jump"))

    def answer_in_doubt(self, send):
        """The first boxes after `send`, which jumps back and sends a late transform and a new one.
        Where that took so long that the node may take the late one, all is tried again."""
        for _ in range(TRIES):
            late, new = at(self.now - 2), at(self.now - 4.99)
            start = time.monotonic()
            send(late, new)
            message = self.boxes.wait(
                lambda m, stamps=(late, new): any(box.stamp in stamps for box in m.boxes),
                "boxes of the new era")
            if late not in [box.stamp for box in message.boxes]:
                return message
            self.assertGreater(time.monotonic() - start, DOUBT, "a late transform was taken")
            self.setUp()
        raise AssertionError("each time the boxes came later than %g s after the jump" % DOUBT)

    def check_two_poses(self):
        """Of the new era; an edge with a sample of a later stamp would not show both."""
        self.wait_for_all(self.now - 4.99, degrees=30)
        self.tf.send(at(self.now - 4.98), degrees=45)
        self.wait_for_all(self.now - 4.98, degrees=45)
        self.assertNotIn(at(self.now - 2), [m.header.stamp for m in self.boxes.messages])

    def test_only_static_boxes_survive_a_jump_back(self):
        self.jump_back()
        self.assertEqual(names_of(self.boxes.messages[-1]), STATIC)

    def test_boxes_of_the_new_era_are_back_in_time(self):
        def is_back():
            self.setUp()
            new_now = self.jump_back()
            start = time.monotonic()
            self.tf.send(at(new_now), degrees=45)
            self.wait_for_all(new_now, degrees=45)
            return time.monotonic() - start < BACK_AGAIN
        self.assertTrue(any(is_back() for _ in range(TRIES)))

    def test_late_transform_that_races_the_clock_harms_nothing(self):
        def send(late, new):
            self.clock.publish(self.now - 5)
            self.tf.send(late)
            self.boxes.wait(lambda m: "left" not in names_of(m), "loss of dynamic boxes")
            self.tf.send(new)
        self.answer_in_doubt(send)
        self.check_two_poses()

    def test_late_transform_after_the_jump_harms_nothing(self):
        def send(late, new):
            self.jump_back()
            self.tf.send(late)
            self.tf.send(new)
        self.answer_in_doubt(send)
        self.check_two_poses()

    def test_late_transform_beside_a_new_one_in_a_message_is_dropped_alone(self):
        def send(late, new):
            self.jump_back()
            self.tf.send_transforms(self.tf.transform("left", new, 30),
                                    self.tf.transform("right", late, 30),
                                    self.tf.transform("left_tip", new, 30))
        dropped = self.dropped()
        message = self.answer_in_doubt(send)
        self.assertEqual(names_of(message), ["base", "mast", "left", "left_tip"])
        self.assertEqual(message.incomplete, ["right"])
        self.diagnostics.wait_for_new(lambda _, status: self.dropped(status) == dropped + 1,
                                      "one more dropped transform")
        self.tf.send(at(self.now - 4.98), degrees=45, links=["right"])
        self.boxes.wait(lambda m: names_of(m) == ALL and not m.incomplete, "the right arm, too")

    def test_stamps_ahead_count_again_when_the_doubt_is_over(self):
        new_now = self.jump_back()
        over = time.monotonic() + 2 * DOUBT
        wait_for(lambda: time.monotonic() > over, "end of the doubt")
        self.tf.send(at(new_now + 3))
        self.wait_for_all(new_now + 3)

    def test_every_transform_in_order_after_a_jump_is_answered(self):
        """Or is joined with a newer one while the machine is busy."""
        self.diagnostics.wait_until_counted()
        start = time.monotonic()
        new_now = self.jump_back()
        stamps = [at(new_now + 0.01 * i) for i in range(1, 41)]
        for stamp in stamps:
            self.tf.send(stamp)
        self.boxes.wait(lambda m: m.header.stamp == stamps[-1], "the last stamp")
        answered = [m.header.stamp for m in self.boxes.messages if "left" in names_of(m)]
        self.assertEqual(answered, sorted(set(answered).intersection(stamps)))
        self.diagnostics.wait_until_counted()
        self.assertEqual(len(stamps) - len(answered), self.diagnostics.joined(start))

    def test_a_twentieth_of_a_second_back_is_no_jump(self):
        self.wait_for_level(DiagnosticStatus.OK)
        self.clock.set(self.now - 0.05)
        self.wait_for_level(DiagnosticStatus.OK)
        self.tf.send(at(self.now + 0.01))
        self.wait_for_all(self.now + 0.01)
        self.assertTrue(all(names_of(m) == ALL for m in self.boxes.messages))

    def test_diagnostics_warn_of_a_jump_for_a_while(self):
        new_now = self.jump_back()
        self.tf.send(at(new_now))
        self.wait_for_all(new_now)
        status = self.wait_for_level(DiagnosticStatus.WARN)
        self.assertIn("clock", status.message)
        self.wait_for_level(DiagnosticStatus.OK)

    def test_jumps_in_a_loop_are_counted_and_logged_at_most_once_in_ten_seconds(self):
        log = NodeLog(NODE)
        log.connect()
        begin, start = len(log.messages), time.monotonic()
        steps = itertools.cycle([0, -5])
        sender = Repeater(10, lambda: self.clock.publish(self.now + next(steps)))
        self.addCleanup(sender.stop)

        def jumps(status):
            return int(value_of(status, "clock jumps"))

        before = jumps(self.diagnostics.wait_for_new(lambda *_: True, "a status"))
        self.diagnostics.wait_for_new(lambda _, s: jumps(s) > before + JUMPS, "some jumps")
        sender.stop()
        lines = [line for line in log.lines(Log.WARN, begin, None) if "jumped back" in line]
        self.assertLessEqual(len(lines), 1 + (time.monotonic() - start) / 10)

    def test_forward_jump_loses_nothing_but_stale_links(self):
        self.wait_for_level(DiagnosticStatus.OK)
        self.clock.set(self.now + 500)
        message = self.boxes.wait(lambda m: m.incomplete, "stale links")
        self.assertEqual((names_of(message), message.incomplete), (STATIC, DYNAMIC))
        self.tf.send(at(self.now + 500), degrees=45)
        self.wait_for_all(self.now + 500, degrees=45)
        self.wait_for_level(DiagnosticStatus.OK)

    def wait_for_level(self, level):
        return self.diagnostics.wait_for_new(
            lambda _, status: status.level == level, "level %d" % level)


if __name__ == "__main__":
    rospy.init_node("time_jump_test")
    rostest.rosrun("link_bounds", "time_jump", TimeJump)
