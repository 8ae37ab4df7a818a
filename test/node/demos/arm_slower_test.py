#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""arm_slower.py without a node: what lets the arm go slower or faster, as doc/scene.md shows."""
import inspect
import os
import sys
import textwrap
import time
import unittest
import unittest.mock

import rospy
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlap, BoxOverlapArray
from page_testing import PACKAGE, code_block
from std_msgs.msg import Header

sys.path.append(os.path.join(PACKAGE, "launch", "demo"))
from arm_slower import SILENCE, SLOWER, SLOWEST, Slower  # noqa: E402

HALF = 0.5  # of the full speed
NOW, LATER = 100.0, 100.1  # s


def header(seconds):
    return Header(stamp=rospy.Time.from_sec(seconds))


class ArmSlower(unittest.TestCase):
    def speed_after(self, *pairs, incomplete=(), boxes=LATER):
        """At half speed before, of a message with these pairs beside boxes of that stamp."""
        with unittest.mock.patch("rospy.Publisher"), unittest.mock.patch("rospy.Subscriber"):
            slower = Slower()
        slower.speed, slower.stamp = HALF, rospy.Time.from_sec(NOW)
        slower.take_boxes(AxisAlignedBoxArray(header=header(boxes), incomplete=list(incomplete)))
        slower.take(BoxOverlapArray(header=header(LATER), overlaps=[
            BoxOverlap(first=first, second=second) for first, second in pairs]))
        self.assertEqual(slower.publisher.publish.call_args[0], (slower.speed,))
        return slower.speed

    def test_faster_where_no_link_meets_an_object(self):
        self.assertAlmostEqual(self.speed_after(), HALF + LATER - NOW)
        self.assertGreater(self.speed_after(("hand", "base"), ("balls/1", "parcels/1")), HALF)

    def test_slower_where_a_link_meets_an_object(self):
        self.assertAlmostEqual(self.speed_after(("hand", "balls/1")), HALF * SLOWER)
        self.assertGreater(HALF * SLOWER, SLOWEST)

    def test_slower_where_a_link_is_incomplete(self):
        self.assertAlmostEqual(self.speed_after(incomplete=["hand"]), HALF * SLOWER)

    def test_no_faster_by_boxes_of_another_stamp(self):
        self.assertEqual(self.speed_after(boxes=NOW), HALF)

    def test_slower_without_messages(self):
        with unittest.mock.patch("rospy.Publisher"), unittest.mock.patch("rospy.Subscriber"):
            slower = Slower()
        slower.watch()
        slower.publisher.publish.assert_not_called()
        for silent, speed in (SILENCE / 2, 1.0), (SILENCE * 2, SLOWER):
            slower.heard = time.monotonic() - silent
            slower.watch()
            self.assertEqual(slower.speed, speed)
        for _ in range(100):
            slower.watch()
        self.assertEqual(slower.publisher.publish.call_args[0], (SLOWEST,))
        slower.take(BoxOverlapArray(header=header(LATER)))
        slower.publisher.publish.reset_mock()
        slower.watch()
        slower.publisher.publish.assert_not_called()

    def test_the_page_shows_it(self):
        shown = code_block("doc/scene.md", "## Can it still stop?", "python")
        own = [textwrap.dedent(inspect.getsource(function))
               for function in (Slower.take_boxes, Slower.take, Slower.watch)]
        self.assertEqual(shown, "\n".join(own))


if __name__ == "__main__":
    unittest.main()
