#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""When the master dies, connections stay; the node registers everything with the next master."""
import signal
import subprocess
import sys
import time
import unittest

import rosgraph
import rospy
from bounds_testing import DEADLINE, Recorder, wait_for
from node_testing import ALL, ARMS, NODE, ArmsTf, Diagnostics, NodeProcess, Repeater
from own_master import OwnMasterTest, entries, is_known
from patience import PATIENCE
from std_srvs.srv import Trigger

STRANGER = "stranger"  # the argument of a second process of this script
BACK_AT_MASTER = 5.0 * PATIENCE  # wall seconds
PROMPT = 10.0 * PATIENCE  # wall seconds for the end of a node on a busy machine
RATE = 100  # Hz
LOST = "lost the ROS master"
BACK = "knows this node again"


def run(*command):
    """The output of a command, which connects as a new node."""
    return subprocess.run(command, check=True, timeout=DEADLINE,
                          stdout=subprocess.PIPE).stdout.decode()


class MasterRestart(OwnMasterTest):
    def setUp(self):
        rospy.set_param("/robot_description", ARMS)
        self.node = NodeProcess(NODE[1:], timeout=0.0)
        self.addCleanup(self.node.end)
        self.boxes = Recorder(NODE + "/boxes")
        self.addCleanup(self.boxes.subscriber.unregister)
        self.boxes.wait(lambda m: True, "boxes")

    def wait_for_output(self, text, count):
        wait_for(lambda: self.node.output.count(text) >= count, "%s, time %d" % (text, count))

    def restart_master(self):
        self.master.kill()
        self.wait_for_output(LOST, 1)
        self.master.start()
        start = time.monotonic()
        wait_for(lambda: is_known(NODE), "the new master knows the node")
        self.assertLess(time.monotonic() - start, BACK_AT_MASTER)
        self.wait_for_output(BACK, 1)

    def check_said_once(self):
        self.assertEqual(self.node.output.count(LOST), 1, self.node.output)
        self.assertEqual(self.node.output.count(BACK), 1, self.node.output)

    def test_what_is_connected_goes_on(self):
        """Each message has its boxes, or was joined with a later one while the machine was busy."""
        tf = ArmsTf()
        diagnostics = Diagnostics()
        sent = []

        def send():
            sent.append(rospy.Time(1000 + len(sent) // RATE, len(sent) % RATE * (10 ** 9 // RATE)))
            tf.send(sent[-1])
        sender = Repeater(RATE, send)
        try:
            self.boxes.wait(lambda m: not m.incomplete, "all boxes")
            self.restart_master()
            after_restart = len(sent)
            wait_for(lambda: len(sent) > after_restart + RATE, "a second more")
        finally:
            sender.stop()
        self.boxes.wait(lambda m: m.header.stamp == sent[-1], "the last update")
        first = next(m.header.stamp for m in self.boxes.messages if not m.incomplete)
        answered = {m.header.stamp for m in self.boxes.messages}
        unanswered = [stamp for stamp in sent if stamp >= first and stamp not in answered]
        if unanswered:
            diagnostics.wait_for_new(lambda *_: True, "a status")
        self.assertLessEqual(len(unanswered), diagnostics.joined(0), unanswered)
        self.check_said_once()

    def test_a_new_master_learns_everything(self):
        before = entries(NODE)
        self.assertEqual(len(before["services"]), 5)
        self.restart_master()
        self.assertEqual(entries(NODE), before)
        self.assertIn(NODE, run("rosnode", "list"))
        self.check_said_once()

    def test_a_new_master_that_knows_a_part_learns_the_rest(self):
        """Another nodelet of the process may register before the node is missed."""
        before = entries(NODE)
        self.master.kill()
        self.wait_for_output(LOST, 1)
        self.node.interrupt(signal.SIGSTOP)
        try:
            self.master.start()
            rosgraph.Master(NODE).registerPublisher("/early", "std_msgs/String", before["uri"])
        finally:
            self.node.interrupt(signal.SIGCONT)
        self.wait_for_output(BACK, 1)
        after = entries(NODE)
        after["publications"].remove(("/early", "std_msgs/String"))
        self.assertEqual(after, before)
        self.check_said_once()

    def test_who_comes_after_the_restart_is_served(self):
        self.restart_master()
        for topic in ("/boxes", "/markers", "/groups"):
            self.assertIn("base", run("rostopic", "echo", "-n", "1", NODE + topic))
        rospy.set_param("/robot_description", ARMS)
        self.assertIn("success: True", run("rosservice", "call", NODE + "/reload"))
        self.assertIn("CheckPath", run("rosservice", "info", NODE + "/check_path"))
        stranger = subprocess.Popen([sys.executable, __file__, STRANGER])
        self.addCleanup(stranger.wait)
        self.addCleanup(stranger.kill)
        message = self.boxes.wait(lambda m: not m.incomplete, "boxes by the tf of a new node")
        self.assertEqual([box.name for box in message.boxes], ALL)

    def test_a_master_that_pauses_is_only_spoken_of(self):
        before = entries(NODE)
        self.master.signal(signal.SIGSTOP)
        try:
            self.wait_for_output(LOST, 1)
        finally:
            self.master.signal(signal.SIGCONT)
        self.wait_for_output(BACK, 1)
        self.assertEqual(entries(NODE), before)
        self.check_said_once()

    def test_a_reload_without_a_master_changes_nothing(self):
        reload = rospy.ServiceProxy(NODE + "/reload", Trigger, persistent=True)
        tf = ArmsTf()
        self.addCleanup(tf.end)
        self.assertTrue(reload().success)
        self.send_and_wait(tf, rospy.Time(1000))
        self.master.kill()
        self.addCleanup(self.master.start)
        count = len(self.boxes.messages)
        answer = reload()
        self.assertFalse(answer.success)
        self.assertIn("master", answer.message)
        after = rospy.Time(1001)
        self.send_and_wait(tf, after)
        self.assertEqual([m.header.stamp for m in self.boxes.messages[count:]], [after])

    def send_and_wait(self, tf, stamp):
        """Waits for the boxes of this stamp, which come after all that the node sent before."""
        tf.send(stamp)
        self.boxes.wait(lambda m: m.header.stamp == stamp and not m.incomplete, "all boxes")

    def test_a_node_ends_promptly_without_a_master(self):
        self.master.kill()
        self.addCleanup(self.master.start)
        self.wait_for_output(LOST, 1)
        start = time.monotonic()
        self.node.interrupt(signal.SIGTERM)
        self.assertEqual(self.node.wait(), 0)
        self.assertLess(time.monotonic() - start, PROMPT)


    def test_a_node_ends_though_the_master_hangs(self):
        """By SIGALRM: it cannot unregister."""
        self.addCleanup(self.master.start)
        self.addCleanup(self.master.kill)
        self.master.signal(signal.SIGSTOP)
        for number in signal.SIGTERM, signal.SIGINT, signal.SIGTERM:
            self.node.interrupt(number)
        self.assertEqual(self.node.wait(), -signal.SIGALRM)


def send_tf_for_ever():
    """A node that the first master never saw."""
    rospy.init_node(STRANGER)
    tf = ArmsTf()
    rate = rospy.Rate(RATE)
    while not rospy.is_shutdown():
        tf.send(rospy.Time.now())
        rate.sleep()


if __name__ == "__main__":
    if STRANGER in sys.argv:
        send_tf_for_ever()
    else:
        unittest.main()
