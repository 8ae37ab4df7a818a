#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node without a description or a clock says what it waits for, and continues by itself."""
import time
import unittest

import rospy
import rostest
from bounds_testing import Recorder, names_of, wait_for
from diagnostic_msgs.msg import DiagnosticStatus
from node_testing import ARMS, STATIC, Diagnostics, NodeProcess
from std_srvs.srv import Trigger

WAITING = "waiting for parameter robot_description"
REMINDER = 10.0  # wall seconds
CLOCK_PATIENCE = 5.0  # wall seconds


class Waiting(unittest.TestCase):
    def start(self, name, *arguments):
        node = NodeProcess(name, arguments)
        self.addCleanup(node.end)
        return node

    def test_for_the_description(self):
        start = time.monotonic()
        node = self.start("without_description")
        diagnostics = Diagnostics(node.name)
        wait_for(lambda: WAITING in node.output, "a first message")
        status = diagnostics.wait_for_new(lambda *_: True, "a status")
        self.assertEqual(status.level, DiagnosticStatus.WARN)
        self.assertIn("robot_description", status.message)
        rospy.wait_for_service(node.name + "/reload")
        answer = rospy.ServiceProxy(node.name + "/reload", Trigger)()
        self.assertFalse(answer.success)
        self.assertIn("robot_description", answer.message)
        wait_for(lambda: node.output.count(WAITING) >= 2, "a reminder")
        self.assertGreater(time.monotonic() - start, REMINDER * 0.9)
        boxes = Recorder(node.name + "/boxes")
        rospy.set_param("/robot_description", ARMS)
        self.addCleanup(rospy.delete_param, "/robot_description")
        message = boxes.wait(lambda m: True, "boxes without a restart")
        self.assertEqual(names_of(message), ["base"])
        self.assertEqual(message.incomplete, STATIC[1:] + ["left", "left_tip", "right"])

    def check_names(self, node, label, full_name):
        line = "waiting for parameter %s: parameter %s is not set" % (label, full_name)
        wait_for(lambda: line in node.output, line)
        Diagnostics(node.name).wait_for_new(
            lambda _, status: status.message == "waiting for " + label, label)
        rospy.wait_for_service(node.name + "/reload")
        answer = rospy.ServiceProxy(node.name + "/reload", Trigger)()
        self.assertIn("parameter %s is not set" % full_name, answer.message)

    def test_for_a_remapped_description(self):
        node = self.start("remapped", "robot_description:=/cell/urdf")
        self.check_names(node, "robot_description (remapped to /cell/urdf)", "/cell/urdf")
        boxes = Recorder(node.name + "/boxes")
        rospy.set_param("/cell/urdf", ARMS)
        self.addCleanup(rospy.delete_param, "/cell")
        boxes.wait(lambda m: names_of(m) == ["base"], "boxes of that description")

    def test_for_one_that_is_remapped_to_its_own_name(self):
        """As link_bounds.launch does."""
        node = self.start("not_remapped", "robot_description:=robot_description")
        self.check_names(node, "robot_description", "/robot_description")

    def test_for_the_clock(self):
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.delete_param, "/use_sim_time")
        rospy.set_param("/robot_description", ARMS)
        self.addCleanup(rospy.delete_param, "/robot_description")
        start = time.monotonic()
        node = self.start("without_clock")
        diagnostics = Diagnostics(node.name)
        status = diagnostics.wait_for_new(
            lambda _, status: "/clock" in status.message, "a word about /clock")
        self.assertEqual(status.level, DiagnosticStatus.WARN)
        self.assertGreater(time.monotonic() - start, CLOCK_PATIENCE * 0.9)
        wait_for(lambda: "/clock" in node.output, "a message about /clock")
        for _ in range(3):
            diagnostics.wait_for_new(lambda *_: True, "a status")
        self.assertEqual(node.output.count("/clock"), 1, node.output)


if __name__ == "__main__":
    rospy.init_node("waiting_test")
    rostest.rosrun("link_bounds", "waiting", Waiting)
