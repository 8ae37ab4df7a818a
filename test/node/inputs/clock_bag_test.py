#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bag that is played in a loop with its clock: each round shows the boxes of its own time."""
import os
import shutil
import subprocess
import tempfile
import threading
import time
import unittest

import rosbag
import rospy
import rostest
from bounds_testing import box_of, load, wait_for
from link_bounds.msg import AxisAlignedBoxArray
from node_testing import ALL, ARMS, DYNAMIC, NODE, arm_transform, at_angles, shows
from patience import PATIENCE
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

BEGIN = 1000.0  # s, stamps of the bag
LENGTH = 3.0  # s
PERIOD = 0.01  # s between the transforms
ROUNDS = 4
RIGHT_AGAIN = 0.5  # wall seconds after a wrap
JUMP = 1.0  # s; where the clock goes back by more, a new round begins
DEADLINE = 90.0 * PATIENCE  # wall seconds for all rounds


def stamp_at(index):
    return rospy.Time.from_sec(BEGIN + PERIOD * index)


def degrees_at(stamp):
    """The arms turn a bit with each transform of the bag."""
    return 20 + 0.1 * round((stamp.to_sec() - BEGIN) / PERIOD)


def write_bag(path):
    """Records the arms. The mast is static and comes first."""
    with rosbag.Bag(path, "w") as bag:
        mast = arm_transform("mast", rospy.Time(), 0)
        bag.write("/tf_static", TFMessage([mast]), stamp_at(0))
        for index in range(round(LENGTH / PERIOD)):
            stamp = stamp_at(index)
            bag.write("/tf", TFMessage([arm_transform(link, stamp, degrees_at(stamp))
                                        for link in DYNAMIC]), stamp)


class Record:
    """Boxes and wraps of the clock, each with its wall time of arrival."""

    def __init__(self):
        self._lock = threading.Lock()
        self.boxes = []
        self.wraps = []
        self._clock = 0.0
        self._subscribers = [
            rospy.Subscriber(NODE + "/boxes", AxisAlignedBoxArray, self._add_boxes,
                             queue_size=10000, tcp_nodelay=True),
            rospy.Subscriber("/clock", Clock, self._add_clock, queue_size=10000,
                             tcp_nodelay=True)]

    def _add_boxes(self, message):
        with self._lock:
            self.boxes.append((time.monotonic(), message))

    def _add_clock(self, message):
        with self._lock:
            seconds = message.clock.to_sec()
            if seconds < self._clock - JUMP:
                self.wraps.append(time.monotonic())
            self._clock = seconds

    def copy(self):
        with self._lock:
            return list(self.boxes), list(self.wraps)


def is_complete(message):
    return [box.name for box in message.boxes] == ALL


def split_into_rounds(boxes):
    """A round ends where the clock has jumped and the moving links have no boxes."""
    rounds = [[]]
    for received, message in boxes:
        if is_complete(message):
            rounds[-1].append((received, message))
        elif rounds[-1]:
            rounds.append([])
    return [found for found in rounds if found]


class ClockBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load(NODE, ARMS, timeout=2.0)
        folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, folder)
        bag = os.path.join(folder, "arms.bag")
        write_bag(bag)
        record = Record()
        player = subprocess.Popen(["rosbag", "play", "--loop", "--clock", "--quiet",
                                   "--wait-for-subscribers", bag], stdin=subprocess.DEVNULL)
        cls.addClassCleanup(player.wait)
        cls.addClassCleanup(player.terminate)
        wait_for(lambda: len(record.copy()[1]) >= ROUNDS, "%d rounds" % ROUNDS, DEADLINE)
        wait_for(lambda: len(split_into_rounds(record.copy()[0])) > ROUNDS, "their boxes")
        boxes, cls.wraps = record.copy()
        cls.rounds = split_into_rounds(boxes)

    def test_every_box_is_that_of_its_stamp(self):
        for _, message in (entry for found in self.rounds for entry in found):
            degrees = degrees_at(box_of(message, "left").stamp)
            self.assertTrue(shows(message, at_angles(degrees, degrees)), message)

    def test_nothing_of_the_old_round_is_published_in_the_new_one(self):
        for found in self.rounds:
            stamps = [message.header.stamp for _, message in found]
            self.assertEqual(stamps, sorted(stamps))

    def test_each_round_begins_with_its_beginning(self):
        for found in self.rounds:
            first = found[0][1].header.stamp.to_sec()
            self.assertLess(first, BEGIN + RIGHT_AGAIN)

    def test_boxes_are_right_in_time_after_each_wrap(self):
        for wrap, found in zip(self.wraps, self.rounds[1:]):
            self.assertLess(abs(found[0][0] - wrap), RIGHT_AGAIN)


if __name__ == "__main__":
    rospy.init_node("clock_bag_test")
    rostest.rosrun("link_bounds", "clock_bag", ClockBag)
