#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""zone_events.py against what is true, without a node: messages of both topics that come late, are
lost, or have stamps that go back."""
import collections
import os
import random
import sys
import unittest
import unittest.mock

import roslib.packages
import rospy
from link_bounds.msg import (AxisAlignedBox, AxisAlignedBoxArray, BoxOverlap,
                             BoxOverlapArray)
from std_msgs.msg import Header

sys.path.append(os.path.join(roslib.packages.get_pkg_dir("link_bounds"), "launch", "demo"))
from zone_events import QUIET, Watch, kind, tell  # noqa: E402

ZONE = "zones/1"
LINKS = ("base", "elbow", "hand")
INSIDE, OUTSIDE, INCOMPLETE, GONE = "inside", "outside", "incomplete", "gone"
SEQUENCES, STEPS = 600, 40
LATE = 3  # messages of one topic that the other one is ahead, at most


class Sequence:
    """Some random steps of a few links, and what zone_events.py says of them."""

    def __init__(self, seed, back, lost):
        """`back`: how often stamps go back; then they may stay, too. `lost`: how often messages are
        lost."""
        self._random = random.Random(seed)
        self._back, self._lost = back, lost
        self._watch = Watch("zones", self._hear)
        self._states = dict.fromkeys(LINKS, OUTSIDE)
        self._stamp = 1000
        self._last_outside = dict.fromkeys(LINKS, -1)  # step
        self._last_shown_inside = dict.fromkeys(LINKS, -1)  # step, by messages that were delivered
        self._queues = {self._watch.take_boxes: collections.deque(),
                        self._watch.take_overlaps: collections.deque()}
        self.said_inside = set()
        self.faults = []
        self.told = 0

    def run(self):
        for step in range(STEPS):
            self._step(step)
            for _ in range(self._random.randrange(6)):
                self._random.choice((self._deliver, self._deliver, self._watch.settle))()
        while any(self._queues.values()):
            self._deliver()
        for _ in range(QUIET + 5):
            self._watch.settle()
        known = {link for link in LINKS if self._states[link] in (INSIDE, OUTSIDE)}
        inside = {link for link in known if self._states[link] == INSIDE}
        if self.said_inside & known != inside:
            self.faults.append("at the end %s are inside, said are %s" %
                               (sorted(inside), sorted(self.said_inside)))

    def _step(self, step):
        for link in LINKS:
            if self._random.random() < 0.3:
                self._states[link] = self._random.choices((INSIDE, OUTSIDE, INCOMPLETE, GONE),
                                                          (5, 5, 2, 1))[0]
            if self._states[link] == OUTSIDE:
                self._last_outside[link] = step
        goes_back = self._random.random() < self._back
        self._stamp += (-self._random.randrange(1, 20) if goes_back else
                        self._random.randrange(0 if self._back else 1, 3))
        header = Header(stamp=rospy.Time(self._stamp))
        having = {state: [link for link in LINKS if self._states[link] == state]
                  for state in (INSIDE, OUTSIDE, INCOMPLETE)}
        boxes = AxisAlignedBoxArray(
            header=header, incomplete=having[INCOMPLETE],
            boxes=[AxisAlignedBox(name=name) for name in
                   having[INSIDE] + having[OUTSIDE] + [ZONE]])
        overlaps = BoxOverlapArray(header=header, overlaps=[
            BoxOverlap(first=name, second=ZONE) for name in having[INSIDE]])
        for queue, message in zip(self._queues.values(), (boxes, overlaps)):
            if queue and self._random.random() < self._lost:
                queue.popleft()
            queue.append((step, message))
        for take, queue in self._queues.items():
            while len(queue) > LATE:
                self._take_next(take, queue)

    def _deliver(self):
        take, queue = self._random.choice(list(self._queues.items()))
        if queue:
            self._take_next(take, queue)

    def _take_next(self, take, queue):
        step, message = queue.popleft()
        for pair in getattr(message, "overlaps", ()):
            self._last_shown_inside[pair.first] = step
        take(message)

    def _hear(self, text):
        self.told += 1
        for link in LINKS:
            if text == "link %s entered zone %s" % (link, ZONE):
                self._expect(link not in self.said_inside, text)
                self.said_inside.add(link)
            elif text == "link %s left zone %s" % (link, ZONE):
                is_true = self._last_outside[link] > self._last_shown_inside[link]
                # After messages that were lost nobody can tell which of one stamp belong together.
                is_known = not (self._back and self._lost)
                self._expect(link in self.said_inside and (is_true or not is_known), text)
                self.said_inside.discard(link)
            elif text == "link %s is not watched: it has no box any more" % link:
                self.said_inside.discard(link)

    def _expect(self, is_true, text):
        if not is_true:
            self.faults.append(text)


class ZoneEventsRandom(unittest.TestCase):
    def check(self, **chances):
        told = 0
        for seed in range(SEQUENCES):
            sequence = Sequence(seed, **chances)
            sequence.run()
            self.assertEqual(sequence.faults, [], "seed %d" % seed)
            told += sequence.told
        self.assertGreater(told, 10 * SEQUENCES)

    def test_messages_that_are_late_or_lost(self):
        self.check(back=0, lost=0.1)

    def test_stamps_that_go_back(self):
        self.check(back=0.1, lost=0)

    def test_both_do_not_last(self):
        self.check(back=0.1, lost=0.1)

    def test_a_lost_message_of_one_stamp_costs_one_visit(self):
        """Ten visits of half a second, at 100 Hz, with two messages that are lost."""
        told = []
        watch = Watch("zones", told.append)
        boxes = AxisAlignedBoxArray(
            boxes=[AxisAlignedBox(name=name) for name in ("hand", ZONE)])
        for i in range(1000):
            watch.take_boxes(boxes)
            visits = [BoxOverlap(first="hand", second=ZONE)] * (i % 100 < 50)
            if i not in (120, 520):
                watch.take_overlaps(BoxOverlapArray(overlaps=visits))
            if i % 10 == 9:
                watch.settle()
        for event in "entered", "left":
            count = told.count("link hand %s zone %s" % (event, ZONE))
            self.assertIn(count, (8, 9, 10), told)

    def test_a_link_leaves_though_one_topic_is_often_ahead(self):
        """Messages of one stamp, as with neighbours; every other look falls between two topics."""
        told = []
        watch = Watch("zones", told.append)
        boxes = AxisAlignedBoxArray(
            boxes=[AxisAlignedBox(name=name) for name in ("hand", ZONE)])
        for i in range(40):
            watch.take_boxes(boxes)
            watch.settle()
            visits = [BoxOverlap(first="hand", second=ZONE)] * (i < 20)
            watch.take_overlaps(BoxOverlapArray(overlaps=visits))
            watch.settle()
            if i == 24:
                self.assertEqual(told[-1], "link hand left zone " + ZONE)
        self.assertEqual(len(told), 3, told)

    def test_a_log_that_cannot_be_written_keeps_no_event_back(self):
        told, full = [], OSError(28, "No space left on device")
        with unittest.mock.patch("rospy.loginfo", side_effect=full):
            tell("link hand entered zone", told.append)
        self.assertEqual(told, ["link hand entered zone"])

    def test_boxes_of_neighbours_are_no_objects(self):
        """What is an object has left where it has no box any more."""
        for name in "ball/1", "a/b/-2", "/5":
            self.assertEqual(kind(name), "object " + name)
        for name in "/robot_b/7", "/robot_b/ball/1", "elbow", "ball/":
            self.assertEqual(kind(name), "link " + name)


if __name__ == "__main__":
    unittest.main()
