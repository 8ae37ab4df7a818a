#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two running nodes of one name: the master ends the older one, if it can reach it."""
import signal
import time
import unittest

import rosgraph
import rospy
from bounds_testing import Recorder, names_of, wait_for
from node_testing import ALL, ARMS, NODE, ArmsTf, NodeProcess
from own_master import OwnMasterTest

REASON = "new node registered with same name"  # of roscpp
TAKEN = "knows another node as " + NODE
BACK = "knows this node again"
LONELY = "has had no box"  # on a busy machine, while nothing sends tf yet
POLLS = 3.0  # wall seconds, in which the node asks the master three times


def address():
    """Where the master finds the node of this name; "" while there is none."""
    try:
        return rosgraph.Master("/asking").lookupNode(NODE)
    except rosgraph.MasterException:
        return ""


class SameName(OwnMasterTest):
    def setUp(self):
        self.older = self.start()
        self.older_address = address()
        self.boxes = Recorder(NODE + "/boxes")
        self.addCleanup(self.boxes.subscriber.unregister)
        self.boxes.wait(lambda m: True, "boxes of the older node")
        self.tf = ArmsTf()
        self.addCleanup(self.tf.end)

    def start(self):
        """A node that has registered."""
        before = address()
        rospy.set_param("/robot_description", ARMS)
        node = NodeProcess(NODE[1:], timeout=0.0)
        self.addCleanup(node.end)
        wait_for(lambda: address() not in ("", before), "the node has registered")
        return node

    def check_one_warning(self):
        warnings = [line for line in self.older.output.splitlines()
                    if "WARN" in line and LONELY not in line]
        self.assertEqual(len(warnings), 1, self.older.output)

    def check_served(self):
        """Sends until all boxes arrive, because a node may only just have connected to tf."""
        self.boxes.clear()
        wait_for(lambda: self.tf.send(rospy.Time.now()) or
                 [m for m in self.boxes.messages if names_of(m) == ALL], "all boxes")

    def test_the_master_ends_the_older_node(self):
        self.check_served()
        younger = self.start()
        self.assertEqual(self.older.wait(), 0)
        self.assertEqual(self.older.output.count(REASON), 1, self.older.output)
        self.assertNotIn(TAKEN, self.older.output)
        self.check_served()
        self.assertTrue(younger.is_running)
        self.assertNotIn("WARN", younger.output)

    def test_an_older_node_that_the_master_cannot_reach_warns_once(self):
        """It is paused while the master is restarted, so the new master never knew it."""
        self.older.interrupt(signal.SIGSTOP)
        self.master.kill()
        self.master.start()
        younger = self.start()
        self.older.interrupt(signal.SIGCONT)
        wait_for(lambda: TAKEN in self.older.output, "a warning")
        end = time.monotonic() + POLLS
        wait_for(lambda: time.monotonic() > end, "further questions to the master")
        self.check_served()
        self.check_one_warning()
        self.assertNotEqual(address(), self.older_address)
        younger.interrupt(signal.SIGTERM)
        wait_for(lambda: address() == self.older_address, "the older node has registered again")
        wait_for(lambda: BACK in self.older.output, "a word about it")
        self.check_served()
        self.check_one_warning()


if __name__ == "__main__":
    unittest.main()
