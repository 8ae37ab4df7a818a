# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base of tests with the arms: each test begins with good poses and all boxes."""
import unittest

import rospy
from bounds_testing import Recorder, load
from node_testing import ARMS, NODE, ArmsTf, at_angles, shows


class ArmsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.tf = ArmsTf()
        cls.now = 1000

    def setUp(self):
        load(NODE, ARMS)
        self.send_good(30, 30)

    def next_stamp(self):
        type(self).now += 1
        return rospy.Time(self.now)

    def send_good(self, left, right):
        stamp = self.next_stamp()
        self.boxes.clear()
        self.tf.send_arms(stamp, left, right)
        self.boxes.wait(lambda m: m.header.stamp == stamp and shows(m, at_angles(left, right)),
                        "good boxes")
