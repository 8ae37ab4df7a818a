#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's arm slows while its stopping boxes meet objects, and goes on; all links have a box."""
import sys
import unittest

import numpy
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
SLOW, FASTER, SLOWEST = 0.5, 0.3, 0.1  # of the full speed; FASTER is a difference
MEET = 120.0  # wall seconds within which the arm meets an object, and is free again
LAUNCH = rospkg.RosPack().get_path("link_bounds") + "/launch/"
DISPLAYS = LAUNCH + "stopping_demo.rviz"
EVERY = 5  # states, of which there are 50 in a second
STEP = 0.001  # s
LONGEST = 600.0  # s, longer than this test runs

sys.path.append(LAUNCH + "demo")
from joint_mover import make_swing, movable_joints  # noqa: E402


def speeds_of(states):
    """From state to state, of the full speed: how far each is on the way of joint_mover."""
    swings = [make_swing(i, joint, 0.8) for i, joint in
              enumerate(movable_joints(rospy.get_param("robot_description")))]
    way = numpy.array([[swing.position(seconds) for swing in swings]
                       for seconds in numpy.arange(0.0, LONGEST, STEP)])
    rows = [0]
    for state in states:
        ahead = way[rows[-1]:rows[-1] + 1000] if len(rows) > 1 else way
        rows.append(rows[-1] + numpy.abs(ahead - state.position).max(axis=1).argmin())
    times = [state.header.stamp.to_sec() for state in states]
    return STEP * numpy.diff(rows[1:]) / numpy.diff(times)


class StoppingDemo(unittest.TestCase):
    def test_every_link_has_a_box(self):
        stopping = Recorder(NODE + "/stopping")
        stopping.wait(lambda m: not m.incomplete and names_of(m)[:len(LINKS)] == LINKS, "boxes")

    def test_the_arm_slows_and_goes_on(self):
        factors = Recorder("/joint_mover/speed", Float64)
        joints = Recorder("/joint_states", JointState)
        slow = factors.wait(lambda m: m.data < SLOW, "slow", MEET)
        factors.clear()
        factors.wait(lambda m: m.data > slow.data + FASTER, "faster again", MEET)
        self.assertGreaterEqual(min(m.data for m in factors.messages), SLOWEST)
        end = rospy.Time.now() + rospy.Duration(1)  # on a busy machine joints come seldom
        joints.wait(lambda m: m.header.stamp > end, "joints at that speed")
        speeds = speeds_of(joints.messages[::EVERY])
        print("from %.2f to %.2f of the full speed" % (min(speeds), max(speeds)))
        self.assertLess(min(speeds), SLOW + 0.1)
        self.assertGreater(max(speeds), min(speeds) + FASTER - 0.1)
        self.assertLess(max(speeds), 1.1)

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
