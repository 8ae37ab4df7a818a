#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""max_rate: without a limit each update is published, or counted as joined with a newer one while
the machine was busy; with a limit the newest state still arrives."""
import time
import unittest

import rospy
import rostest
from bounds_testing import (Recorder, box_of, corners_of, difference, latched, load, names_of,
                            union, wait_for)
from footprint_test import is_rectangle
from geometry_msgs.msg import Polygon
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray
from node_testing import (ALL, ARMS, NODE, ArmsTf, Delays, Diagnostics, NodeProcess,
                          value_of)
from object_testing import ObjectSender, deletion, marker
from patience import PATIENCE

UPDATES = 400
LATE = 0.3 * PATIENCE  # wall seconds beyond what the machine takes
SLOW = 0.01 / PATIENCE  # Hz; one period is longer than any deadline here
INTERVAL = 0.005 * PATIENCE  # wall seconds between updates


class Arrivals:
    """The wall time of arrival and the stamp of each message of a topic."""

    def __init__(self, topic):
        self.times = []
        self._subscriber = rospy.Subscriber(
            topic, AxisAlignedBoxArray,
            lambda message: self.times.append((time.monotonic(), message.header.stamp)),
            queue_size=1000, tcp_nodelay=True)


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

    def send_next(self, record=lambda stamp: None):
        MaxRate.now += 0.01
        stamp = rospy.Time.from_sec(self.now)
        record(stamp)
        self.tf.send(stamp)
        return stamp

    def flood(self):
        """Sends all updates at their rate; returns their stamps and how long it took."""
        sent = self.timed_flood()
        return [stamp for _, stamp in sent], sent[-1][0] - sent[0][0]

    def timed_flood(self, record=lambda stamp: None):
        """The same; returns when each was sent, and its stamp."""
        start = time.monotonic()
        sent = []
        while len(sent) < UPDATES:
            time.sleep(max(0.0, start + len(sent) * INTERVAL - time.monotonic()))
            sent.append((time.monotonic(), self.send_next(record)))
        return sent

    def wait_for_last(self, stamp):
        self.boxes.wait(lambda m: m.header.stamp == stamp, "the last update before silence")
        self.groups.wait(lambda m: m.header.stamp == stamp, "the last groups")

    def test_every_update_is_answered_once_and_in_order(self):
        self.start(0.0)
        diagnostics = Diagnostics()
        diagnostics.wait_until_counted()
        start = time.monotonic()
        stamps, _ = self.flood()
        self.wait_for_last(stamps[-1])
        diagnostics.wait_until_counted()
        answered = [m.header.stamp for m in self.boxes.messages]
        self.assertEqual(answered, sorted(set(answered).intersection(stamps)))
        self.assertEqual(len(stamps) - len(answered), diagnostics.joined(start))
        self.assertGreater(len(answered), UPDATES / 2)
        self.assertEqual([m.header.stamp for m in self.groups.messages], answered)

    def test_a_limit_holds_and_the_newest_state_follows(self):
        rate = 10.0 / PATIENCE
        self.start(rate)
        stamps, seconds = self.flood()
        self.wait_for_last(stamps[-1])
        answered = [m.header.stamp for m in self.boxes.messages]
        # One may come at the very start and one follows the end.
        self.assertLessEqual(len(answered), rate * seconds + 2)
        self.assertGreater(len(answered), 2)
        self.assertEqual(answered, sorted(set(answered)))
        self.assertEqual([m.header.stamp for m in self.groups.messages], answered)

    def test_what_is_shown_is_the_newest_and_at_most_a_period_late(self):
        rate = 1.0 / PATIENCE
        self.start(rate)
        beside = NodeProcess("beside", timeout=0.0)
        self.addCleanup(beside.end)
        delays = Delays(beside.name)
        self.addCleanup(delays.end)
        Recorder(beside.name + "/boxes").wait(lambda m: True, "the node beside it")
        arrivals = Arrivals(NODE + "/boxes")
        wait_for(lambda: arrivals.times, "the latched message")
        sent = self.timed_flood(delays.record)
        self.wait_for_last(sent[-1][1])
        late = LATE + delays.longest(beside.name)
        wait_for(lambda: arrivals.times[-1][1] == sent[-1][1], "the last arrival")
        for moment, stamp in arrivals.times[1:]:
            known = [other for time_sent, other in sent if time_sent < moment - late]
            self.assertTrue(not known or stamp >= known[-1], "an old state is shown")
        for time_sent, stamp in sent:
            shown = next(moment for moment, other in arrivals.times if other >= stamp)
            self.assertLess(shown - time_sent, 1 / rate + late)

    def test_a_single_update_after_silence_is_shown(self):
        self.start(1.0)
        stamp = self.send_next()
        message = self.boxes.wait(lambda m: m.header.stamp == stamp, "the single update")
        self.assertEqual(box_of(message, "left").stamp, stamp)

    def test_a_new_subscriber_is_shown_what_boxes_shows(self):
        self.start(0.0)
        objects = ObjectSender(NODE)
        self.addCleanup(load, NODE)
        self.addCleanup(objects.clear)
        objects.send(marker("gone/1"))
        self.boxes.wait(lambda m: "gone/1" in names_of(m), "the object")
        diagnostics = Diagnostics()
        self.boxes.clear()
        load(NODE, max_rate=SLOW, overlap_margin=10.0, parts_per_link=2)
        shown = self.boxes.wait(lambda m: len(m.boxes) == len(ALL) + 1, "boxes of the reload")
        objects.send(deletion("gone/1"), marker("new/1"))
        MaxRate.now += 0.01
        self.tf.send(rospy.Time.from_sec(self.now), 60)
        # Diagnostics tell when both messages have come; ~boxes waits for its period.
        updates = int(value_of(diagnostics.wait_for_new(lambda *_: True, "a status"), "updates"))
        MaxRate.now += 0.01
        self.tf.send(rospy.Time.from_sec(self.now), 75)
        diagnostics.wait_for_new(
            lambda _, status: int(value_of(status, "updates")) > updates, "the last update")
        self.assertEqual(self.boxes.messages, [shown])
        self.check_overlaps(latched(NODE + "/overlaps", BoxOverlapArray), shown)
        self.check_parts(latched(NODE + "/parts"), shown)
        self.assertTrue(is_rectangle(latched(NODE + "/footprint", Polygon), 30))
        self.assertEqual(self.boxes.messages, [shown])

    def check_overlaps(self, overlaps, boxes):
        self.assertEqual(overlaps.header.stamp, boxes.header.stamp)
        found = {name for pair in overlaps.overlaps for name in (pair.first, pair.second)}
        self.assertEqual(found, set(names_of(boxes)))

    def check_parts(self, parts, boxes):
        self.assertEqual(parts.header.stamp, boxes.header.stamp)
        for name in ALL:
            bounds = union([corners_of(part) for part in parts.boxes if part.name == name])
            self.assertLess(difference(bounds, corners_of(box_of(boxes, name))), 1e-9)


if __name__ == "__main__":
    rospy.init_node("max_rate_test")
    rostest.rosrun("link_bounds", "max_rate", MaxRate)
