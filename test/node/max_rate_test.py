#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Without a limit every update is answered; with one the newest state still arrives."""
import time
import unittest

import rospy
import rostest
from bounds_testing import Recorder, box_of, load
from node_testing import ALL, ARMS, NODE, ArmsTf

UPDATES = 400
INTERVAL = 0.005  # wall seconds between updates, 200 Hz


class MaxRate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.groups = Recorder(NODE + "/groups")
        cls.tf = ArmsTf()
        cls.now = 1000.0

    def start(self, max_rate):
        load(NODE, ARMS, max_rate=max_rate)
        self.send_next()
        first = rospy.Time.from_sec(self.now)
        self.boxes.wait(lambda m: len(m.boxes) == len(ALL) and m.header.stamp == first, "a start")
        self.groups.wait(lambda m: m.header.stamp == first, "its groups")
        self.boxes.clear()
        self.groups.clear()

    def send_next(self):
        MaxRate.now += 0.01
        stamp = rospy.Time.from_sec(self.now)
        self.tf.send(stamp)
        return stamp

    def flood(self):
        """Sends all updates at their rate; returns their stamps and how long it took."""
        start = time.monotonic()
        stamps = []
        while len(stamps) < UPDATES:
            if time.monotonic() - start >= len(stamps) * INTERVAL:
                stamps.append(self.send_next())
        return stamps, time.monotonic() - start

    def wait_for_last(self, stamp):
        self.boxes.wait(lambda m: m.header.stamp == stamp, "the last update before silence")
        self.groups.wait(lambda m: m.header.stamp == stamp, "the last groups")

    def test_every_update_is_answered_once_and_in_order(self):
        self.start(0.0)
        stamps, _ = self.flood()
        self.wait_for_last(stamps[-1])
        self.assertEqual([m.header.stamp for m in self.boxes.messages], stamps)
        self.assertEqual([m.header.stamp for m in self.groups.messages], stamps)

    def test_a_limit_holds_and_the_newest_state_follows(self):
        self.start(10.0)
        stamps, seconds = self.flood()
        self.wait_for_last(stamps[-1])
        answered = [m.header.stamp for m in self.boxes.messages]
        # One may come at the very start and one follows the end.
        self.assertLessEqual(len(answered), 10 * seconds + 2)
        self.assertGreater(len(answered), 2)
        self.assertEqual(answered, sorted(set(answered)))
        self.assertEqual([m.header.stamp for m in self.groups.messages], answered)

    def test_a_single_update_after_silence_is_shown(self):
        self.start(1.0)
        stamp = self.send_next()
        message = self.boxes.wait(lambda m: m.header.stamp == stamp, "the single update")
        self.assertEqual(box_of(message, "left").stamp, stamp)


if __name__ == "__main__":
    rospy.init_node("max_rate_test")
    rostest.rosrun("link_bounds", "max_rate", MaxRate)
