#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stamps from the future, the past and twice, gaps, and publishers that disagree."""
import re
import threading
import time
import unittest

import rospy
import rostest
from bounds_testing import (DEADLINE, NodeLog, Recorder, TfSender, box_of, corners_of, difference,
                            load, names_of, wait_for)
from diagnostic_msgs.msg import DiagnosticStatus
from node_testing import (ALL, ARMS, NODE, TOLERANCE, ArmsTf, Diagnostics, NodeProcess, Repeater,
                          arm_bounds, at_angles, shows, value_of)
from rosgraph_msgs.msg import Log

LEFT = ["left", "left_tip"]
ARM_AT_45 = {"base": 0, "mast": 0, "left": 45, "left_tip": 45}
WITHOUT_LEFT = {"base": 0, "mast": 0, "right": 30}
TIMEOUT = 2.0  # ROS seconds; long enough for the senders on a busy machine
GAP = 5.0  # wall seconds
YEAR_2100 = rospy.Time(4102444800)
AGREED = 50  # transforms of each publisher


def late_publishers(status):
    """Name and lateness of each."""
    prefix = "publisher behind: "
    return [(pair.key[len(prefix):], pair.value) for pair in status.values
            if pair.key.startswith(prefix)]


class TfTimes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.diagnostics = Diagnostics()
        cls.tf = ArmsTf()
        cls.log = NodeLog(NODE)
        wait_for(lambda: load(NODE, ARMS, no_such_parameter=1) or cls.log.messages,
                 "a warning arrives")

    def setUp(self):
        """Sends the arms at 30 degrees, 50 times a second; self.left(stamp) sends the left one."""
        load(NODE, ARMS, timeout=TIMEOUT)
        self.lock = threading.Lock()
        self.left = self.send_left
        self.sender = Repeater(50, self.send_both)
        self.addCleanup(self.sender.stop)
        self.wait_for(at_angles(30, 30))

    def send_both(self):
        with self.lock:
            now = rospy.Time.now()
            self.tf.send(now, 30, ["right"])
            self.left(now)

    def send_left(self, stamp):
        self.left_sent, self.left_stamp = time.monotonic(), stamp
        self.tf.send(stamp, 30, LEFT)

    def now_on(self, left):
        """Replaces self.left; no call of the old function is under way afterwards."""
        with self.lock:
            self.left = left

    def wait_for(self, degrees, incomplete=()):
        self.boxes.clear()
        return self.boxes.wait(lambda m: shows(m, degrees, incomplete), "the expected boxes")

    def check_others(self, messages):
        """All links but the left arm have their exact boxes."""
        self.assertTrue(messages)
        for message in messages:
            for name in WITHOUT_LEFT:
                self.assertLess(difference(corners_of(box_of(message, name)),
                                           arm_bounds(name, 30)), TOLERANCE, name)
            self.assertLessEqual(set(message.incomplete), set(LEFT))

    def poison(self):
        """Sends one stamp of the year 2100 on one edge; its link becomes stale."""
        begin = len(self.log.messages)
        with self.lock:
            self.boxes.clear()
            self.tf.send(YEAR_2100, 30, ["left"])
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        return begin

    def test_a_stamp_of_2100_blocks_its_link_alone_until_a_reload(self):
        begin = self.poison()

        def warnings():
            return [line for line in self.log.lines(Log.WARN, begin, None)
                    if '"left"' in line and "older" in line and "~reload" in line]
        wait_for(warnings, "a warning that names the frame and the remedy")
        load(NODE, ARMS, timeout=TIMEOUT)
        self.boxes.wait(lambda m: shows(m, at_angles(30, 30)) and m is self.boxes.messages[-1],
                        "the arm again")
        self.assertEqual(len(warnings()), 1)
        self.check_others(self.boxes.messages)

    def test_a_reload_heals_also_when_the_next_transform_comes_later(self):
        self.poison()
        self.now_on(lambda stamp: None)
        load(NODE, ARMS, timeout=TIMEOUT)
        self.wait_for(WITHOUT_LEFT, LEFT)
        self.now_on(self.send_left)
        self.wait_for(at_angles(30, 30))

    def test_repeated_stamps_become_stale(self):
        repeated = rospy.Time.now()
        self.boxes.clear()
        self.now_on(lambda stamp: self.send_left(repeated))
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        self.check_others(self.boxes.messages)
        self.now_on(self.send_left)
        self.wait_for(at_angles(30, 30))

    def test_stamps_that_run_backwards_become_stale_and_never_move_the_link(self):
        """They are accepted into the history, but none is newer."""
        self.boxes.clear()
        last = self.boxes.wait(lambda m: shows(m, at_angles(30, 30)), "news")

        def send_earlier_and_earlier(_):
            self.left_stamp -= rospy.Duration(0.001)
            self.tf.send(self.left_stamp, 45, LEFT)
        self.now_on(send_earlier_and_earlier)
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        after = self.boxes.messages[self.boxes.messages.index(last):]
        self.check_others(after)
        self.assertTrue(all(shows(m, at_angles(30, 30)) or shows(m, WITHOUT_LEFT, LEFT)
                            for m in after))

    def test_a_clock_that_steps_back_is_told(self):
        """The arm moves on with stamps five seconds behind, until they pass the newest one."""
        begin = len(self.log.messages)
        self.boxes.clear()
        step = rospy.Duration(5)
        self.now_on(lambda stamp: self.tf.send(stamp - step, 45, LEFT))
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        self.check_others(self.boxes.messages)
        node = rospy.get_name()

        def is_told(_, status):
            behind = dict(late_publishers(status)).get(node)
            return (status.level == DiagnosticStatus.WARN and "run behind" in status.message
                    and behind and "left" in behind and
                    0 < float(re.search(r"^by ([0-9.]+) s", behind).group(1)) < 5)
        self.diagnostics.wait_for_new(is_told, "the lag, frame and publisher in /diagnostics")

        def warnings():
            return [line for line in self.log.lines(Log.WARN, begin, None)
                    if '"left"' in line and node in line and "is late" in line]
        wait_for(warnings, "a warning that names frame and publisher")
        self.wait_for(at_angles(45, 30))
        self.assertEqual(len(warnings()), 1)
        self.diagnostics.wait_for_new(
            lambda _, status: value_of(status, "publishers behind") == "0", "all is well again")

    def test_publishers_that_are_a_little_late_are_neither_stale_nor_told(self):
        begin = len(self.log.messages)
        older, newer = ArmsTf(), ArmsTf()

        def send_twice(stamp):
            newer.send(stamp, 30, LEFT)
            older.send(stamp - rospy.Duration(0.005), 30, LEFT)
        self.now_on(send_twice)
        self.boxes.clear()
        end = time.monotonic() + 2 * TIMEOUT
        wait_for(lambda: time.monotonic() > end, "two timeouts")
        self.assertFalse([m for m in self.boxes.messages if m.incomplete])
        self.assertFalse(self.log.lines(Log.WARN, begin, None))
        status = self.diagnostics.wait_for_new(lambda *_: True, "a status")
        self.assertEqual(value_of(status, "publishers behind"), "0")

    def test_a_late_publisher_beside_a_healthy_one_is_told(self):
        begin = len(self.log.messages)
        late = ArmsTf()

        def send_twice(stamp):
            self.send_left(stamp)
            late.send(stamp - rospy.Duration(5), 45, LEFT)
        self.now_on(send_twice)
        self.boxes.clear()
        self.diagnostics.wait_for_new(
            lambda _, status: rospy.get_name() in dict(late_publishers(status)), "who is late")
        wait_for(lambda: [line for line in self.log.lines(Log.WARN, begin, None)
                          if '"left"' in line and "is late" in line], "a warning")
        self.assertFalse([m for m in self.boxes.messages if not shows(m, at_angles(30, 30))])

    def test_stamps_older_than_the_history_become_stale(self):
        self.boxes.clear()
        self.now_on(lambda stamp: self.tf.send(stamp - rospy.Duration(20), 45, LEFT))
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        self.check_others(self.boxes.messages)
        self.now_on(self.send_left)
        self.wait_for(at_angles(30, 30))

    def test_a_gap_of_five_seconds(self):
        self.now_on(lambda stamp: None)
        silent = self.left_sent
        self.boxes.clear()
        self.boxes.wait(lambda m: shows(m, WITHOUT_LEFT, LEFT), "a stale arm")
        self.assertGreater(time.monotonic() - silent, 0.9 * TIMEOUT)
        wait_for(lambda: time.monotonic() > silent + GAP, "the end of the gap")
        with self.lock:
            self.tf.send(rospy.Time.now(), 45, LEFT)
        self.boxes.wait(lambda m: shows(m, at_angles(45, 30)), "the arm where it is now")
        self.check_others(self.boxes.messages)

    def test_publishers_that_disagree(self):
        """The newest stamp counts, and each box is that of its stamp. A busy machine joins messages:
        then more are sent."""
        self.sender.stop()
        load(NODE, ARMS)
        tfs = ArmsTf(), ArmsTf()
        begin, end = rospy.Time.now(), time.monotonic() + DEADLINE
        degrees, shown = {}, []
        self.boxes.clear()
        while len(shown) <= AGREED // 2:
            self.assertLess(time.monotonic(), end, "too few boxes")
            for i in range(len(degrees) + 1, len(degrees) + 2 * AGREED):
                stamp = begin + rospy.Duration(0.01 * i)
                degrees[stamp] = (30, 45)[i % 2]
                tfs[i % 2].send(stamp, degrees[stamp])
            self.boxes.wait(lambda m: m.header.stamp == max(degrees), "the last stamp")
            shown = [m for m in self.boxes.messages if m.header.stamp in degrees]
        for message in shown:
            angle = degrees[message.header.stamp]
            self.assertTrue(shows(message, at_angles(angle, angle)), message)

    def start_fresh(self, name):
        """A node with tf topics of its own, which knows no frame yet."""
        self.sender.stop()
        rospy.set_param("/robot_description", ARMS)
        node = NodeProcess(name, ["/tf:=/%s/tf" % name, "/tf_static:=/%s/tf_static" % name],
                           timeout=TIMEOUT)
        self.addCleanup(node.end)
        boxes = Recorder(node.name + "/boxes")
        boxes.wait(lambda m: True, "the node has started")
        senders = TfSender(False, node.name), TfSender(True, node.name)
        for sender in senders:
            sender.wait_for_listener()
        return boxes, *senders

    def arm(self, stamp, degrees):
        return [self.tf.transform(link, stamp, degrees) for link in ("mast", "left", "left_tip")]

    def test_first_static_then_dynamic_stays_static(self):
        boxes, dynamic, static = self.start_fresh("static_first")
        static.send(*self.arm(rospy.Time(), 30))
        boxes.wait(lambda m: "left" in names_of(m), "the static arm")
        dynamic.send(*self.arm(rospy.Time.now(), 45))
        message = boxes.wait(lambda m: shows(m, ARM_AT_45, ["right"]),
                             "the arm where it was put last")
        self.assertEqual({box.stamp for box in message.boxes}, {rospy.Time(0)})
        end = time.monotonic() + 1.5 * TIMEOUT
        wait_for(lambda: time.monotonic() > end, "the time")
        self.assertEqual(boxes.messages[-1], message)

    def test_first_dynamic_then_static_stays_dynamic(self):
        boxes, dynamic, static = self.start_fresh("dynamic_first")
        dynamic.send(*self.arm(rospy.Time.now(), 45))
        boxes.wait(lambda m: shows(m, ARM_AT_45, ["right"]), "the dynamic arm")
        boxes.clear()
        static.send(*self.arm(rospy.Time(), 30))
        boxes.wait(lambda m: shows(m, {"base": 0}, [n for n in ALL if n != "base"]), "stale links")
        self.assertFalse([m for m in boxes.messages if "left" in names_of(m)])


if __name__ == "__main__":
    rospy.init_node("tf_times_test")
    rostest.rosrun("link_bounds", "tf_times", TfTimes)
