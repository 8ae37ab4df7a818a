#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node gives back the memory that huge tf messages need."""
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, names_of, transform, wait_for
from emulation import is_emulated
from node_testing import (ALL, ARMS, SANITIZED, ArmsTf, Diagnostics, NodeProcess, resident_bytes,
                          value_of)
from patience import PATIENCE
from raw_messages import as_bytes, serialized
from tf2_msgs.msg import TFMessage

MANY = 300000  # transforms in one message
ROUNDS = 3
MEBIBYTE = 1 << 20
KEPT = 4 * MEBIBYTE  # by the C library and in roscpp's buffers
DEADLINE = 60.0 * PATIENCE  # wall seconds to send, receive and read one of them


class TfMemory(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.set_param("/robot_description", ARMS)
        cls.node = NodeProcess("tf_memory_node")
        cls.boxes = Recorder(cls.node.name + "/boxes")
        cls.diagnostics = Diagnostics(cls.node.name)
        cls.tf = ArmsTf()
        cls.tf_static = TfSender(is_static=True)
        cls.tf_static.wait_for_listener()
        cls.now = 1000

    @classmethod
    def tearDownClass(cls):
        cls.node.end()

    def send_arms(self):
        type(self).now += 1
        self.boxes.clear()
        self.tf.send(rospy.Time(self.now))
        self.boxes.wait(lambda m: names_of(m) == ALL and m.header.stamp.secs == self.now, "boxes")

    def counter(self, key):
        status = self.diagnostics.wait_for_new(lambda _, s: True, "a status")
        return int(value_of(status, key))

    def check(self, sender, child, key, is_latched=False):
        """Sends huge messages of one transform, which are counted under the key."""
        self.send_arms()
        before = resident_bytes(self.node.pid)
        one = serialized(TFMessage([transform("nowhere", child, rospy.Time(1000))]))
        data = MANY.to_bytes(4, "little") + MANY * one[4:]
        message = as_bytes(TFMessage(), data)
        kept = KEPT + (len(data) if is_latched else 0)  # roscpp keeps a latched one
        for _ in range(ROUNDS):
            count = self.counter(key)
            sender.publish(message)
            self.diagnostics.wait_for_new(
                lambda _, s: int(value_of(s, key)) >= count + MANY - 1, "all of them", DEADLINE)
            if SANITIZED:
                print("skipped: a sanitizer keeps memory that was freed")
                continue
            if is_emulated(self.node.pid):
                print("skipped: an emulator has memory of its own in the process")
                continue
            wait_for(lambda: resident_bytes(self.node.pid) < before + kept,
                     "the memory is back; MiB before and at first: %.1f, %.1f" % (
                         before / MEBIBYTE, resident_bytes(self.node.pid) / MEBIBYTE))
            print("memory [MiB]: %.1f before, %.1f after %d transforms in one message" % (
                before / MEBIBYTE, resident_bytes(self.node.pid) / MEBIBYTE, MANY))
        self.send_arms()

    def test_a_huge_message(self):
        self.check(self.tf, "moving", "transforms refused, stamp repeated")

    def test_a_huge_static_message(self):
        self.check(self.tf_static, "fixed", "transforms taken", is_latched=True)


if __name__ == "__main__":
    rospy.init_node("tf_memory_test")
    rostest.rosrun("link_bounds", "tf_memory", TfMemory)
