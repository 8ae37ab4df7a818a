#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A frame that tf does not connect is named in one warning after five seconds, with the usual
causes; again only after it was connected in between; also while there is no /clock."""
import re
import time
import unittest

import rospy
import rostest
from bounds_testing import DEADLINE, Recorder, TfSender, names_of, wait_for
from node_testing import ALL, ARMS, NodeProcess, Repeater, arm_transform
from object_testing import ObjectSender, marker
from patience import PATIENCE

LOST = 5.0  # wall seconds until the warning
LATE = 3.0 * PATIENCE  # wall seconds on a busy machine
WATCHED = 2 * LOST + LATE  # after which there must still be one warning
TIMEOUT = 0.5  # ROS seconds
SILENT = ["/tf:=/silent", "/tf_static:=/silent"]  # as without a robot_state_publisher
STARTED = "bounding 5 links"
CAUSES = "usual causes:"
LINE = re.compile(r"\[ ?(?:INFO|WARN)\] \[(\d+\.\d+)")  # with wall time


def wait_until(end):
    wait_for(lambda: time.monotonic() > end, "the time", WATCHED + DEADLINE)


def send_arms(tf):
    """As a robot_state_publisher sends them."""
    now = rospy.Time.now()
    tf.send(*[arm_transform(link, now, 0) for link in ALL[1:]])


class Node(NodeProcess):
    """A node that has loaded its robot."""

    def __init__(self, name, arguments=(), **parameters):
        super().__init__(name, arguments, **parameters)
        wait_for(lambda: STARTED in self.output, "the robot is loaded")

    def lines(self, text):
        return [line for line in self.output.splitlines() if text in line]


class LostFrames(unittest.TestCase):
    """The nodes live side by side: each test waits for the same seconds."""

    @classmethod
    def setUpClass(cls):
        rospy.set_param("/robot_description", ARMS)
        tf = TfSender()
        cls.repeaters = [Repeater(20, lambda: send_arms(tf))]
        cls.misspelt = Node("misspelt", fixed_frame="wolrd")
        cls.alone = Node("alone", SILENT)
        cls.with_object = Node("with_object")
        ObjectSender(cls.with_object.name).send(
            marker("scene/1", frame="nowhere"), marker("scene/2", frame="nowhere"),
            marker("scene/3"))
        cls.with_sender = Node("with_sender")
        objects = ObjectSender(cls.with_sender.name)
        cls.repeaters.append(Repeater(10, lambda: objects.send(
            marker("seen/1", frame="nowhere", stamp=rospy.Time.now()),
            marker("seen/2", frame="left", stamp=rospy.Time.now()))))
        rospy.set_param("/use_sim_time", True)
        cls.clockless = Node("clockless", SILENT)
        rospy.delete_param("/use_sim_time")
        cls.end = time.monotonic() + WATCHED

    @classmethod
    def tearDownClass(cls):
        for repeater in cls.repeaters:
            repeater.stop()
        for node in (cls.misspelt, cls.alone, cls.with_object, cls.with_sender, cls.clockless):
            node.end()

    def check_one_warning(self, node, *words):
        wait_until(self.end)
        warnings = node.lines(CAUSES)
        self.assertEqual(len(warnings), 1, node.output)
        for word in words:
            self.assertIn(word, warnings[0])
        start, warned = [float(LINE.search(line).group(1))
                         for line in node.lines(STARTED) + warnings]
        self.assertGreater(warned - start, LOST - 0.1)
        self.assertLess(warned - start, LOST + LATE)

    def test_misspelt_fixed_frame(self):
        self.check_one_warning(self.misspelt, "no link", 'fixed_frame "wolrd"', "is misspelt",
                               "robot_state_publisher")

    def test_no_robot_state_publisher(self):
        self.check_one_warning(self.alone, 'link "mast" (and 3 more links)',
                               'no transform from "mast" to "base"',
                               "robot_state_publisher does not run", "joint_states")

    def test_without_a_clock(self):
        self.check_one_warning(self.clockless, 'no transform from "mast" to "base"')

    def test_object_in_a_frame_that_does_not_exist(self):
        self.check_one_warning(self.with_object, 'object "scene/1" from "/lost_frames"',
                               'no transform from "nowhere" to "base"',
                               'the frame "nowhere" is misspelt, or nobody publishes it')

    def test_object_that_is_sent_again_before_it_is_given_up(self):
        self.check_one_warning(self.with_sender, 'object "seen/1"',
                               'no transform from "nowhere" to "base"')

    def test_again_only_after_it_was_right(self):
        tf = TfSender(namespace="/other")
        node = Node("interrupted", ["/tf:=/other/tf"], timeout=TIMEOUT)
        self.addCleanup(node.end)
        boxes = Recorder(node.name + "/boxes")
        tf.wait_for_listener()
        for count in (1, 2):
            sender = Repeater(20, lambda: send_arms(tf))
            boxes.wait_newest(lambda m: names_of(m) == ALL, "all boxes")
            wait_until(time.monotonic() + 1)  # the node looks twice a second
            sender.stop()
            wait_for(lambda n=count: len(node.lines(CAUSES)) >= n, "%d warnings" % count)
            warnings = node.lines(CAUSES)
            self.assertEqual(len(warnings), count, node.output)
            self.assertIn('link "mast" (and 3 more links) has had no box for 5 s: stale: no '
                          'transform accepted', warnings[-1])


if __name__ == "__main__":
    rospy.init_node("lost_frames_test")
    rostest.rosrun("link_bounds", "lost_frames", LostFrames)
