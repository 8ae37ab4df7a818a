#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's arm slows while its stopping boxes meet objects, and goes on; all links have a box."""
import unittest

import rospkg
import rospy
import rostest
import yaml
from bounds_testing import Recorder, names_of
from node_testing import NODE
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from visualization_msgs.msg import MarkerArray

LINKS = ["base", "shoulder", "upper_arm", "elbow", "forearm", "wrist", "flange", "gripper",
         "finger_left", "finger_right"]
SLOW, FASTER = 0.5, 0.2  # of the full speed; FASTER is a difference
MEET = 120.0  # wall seconds within which the arm meets an object, and is free again
DISPLAYS = rospkg.RosPack().get_path("link_bounds") + "/launch/stopping_demo.rviz"


def speeds_between(older, newer):
    """Of the joints [rad/s or m/s]."""
    time = (newer.header.stamp - older.header.stamp).to_sec()
    return [abs(b - a) / time for a, b in zip(older.position, newer.position)]


class StoppingDemo(unittest.TestCase):
    def test_every_link_has_a_box(self):
        stopping = Recorder(NODE + "/stopping")
        stopping.wait(lambda m: not m.incomplete and names_of(m)[:len(LINKS)] == LINKS, "boxes")

    def test_the_arm_slows_and_goes_on(self):
        factors = Recorder("/joint_mover/speed", Float64)
        slow = factors.wait(lambda m: m.data < SLOW, "slow", MEET)
        joints = Recorder("/joint_states", JointState)
        joints.wait(lambda m: True, "joints")
        factors.clear()
        factors.wait(lambda m: m.data > slow.data + FASTER, "faster again", MEET)
        states = joints.messages
        speeds = [max(speeds_between(a, b)) for a, b in zip(states, states[1:])]
        self.assertLess(min(speeds), SLOW * max(speeds))

    def test_what_rviz_shows_is_published(self):
        with open(DISPLAYS, encoding="utf-8") as config:
            displays = yaml.safe_load(config)["Visualization Manager"]["Displays"]
        topics = [d["Marker Topic"] for d in displays if "Marker Topic" in d]
        self.assertEqual(len(topics), 2)
        for topic in topics:
            Recorder(topic, MarkerArray).wait(lambda m: m.markers, "markers")


if __name__ == "__main__":
    rospy.init_node("stopping_demo_test")
    rostest.rosrun("link_bounds", "stopping_demo", StoppingDemo)
