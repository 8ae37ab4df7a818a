#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two robots side by side: their frames in tf are prefixed, the names of their boxes are not."""
import math
import signal
import subprocess
import unittest

import rospkg
import rospy
import rostest
from visualization_msgs.msg import MarkerArray

from bounds_testing import (JointSender, Pose, Recorder, TfSender, corners_of, difference,
                            executable, load, names_of, transform, turn, visual, wait_for)

TOLERANCE = 1e-9  # metres
FIRST_WITH_PREFIX = (1, 15, 2)  # of robot_state_publisher
SIZE, CENTRE = (0.2, 0.5, 1.1), (0.7, 0.0, 0.0)
LINK = '<link name="%s">' + visual('<box size="%r %r %r"/>' % SIZE, CENTRE) + '</link>'
JOINT = ('<joint name="%s" type="%s"><parent link="base"/><child link="%s"/>'
         '<origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>')
DESCRIPTION = '<robot name="one_arm">%s</robot>' % (
    LINK % "base" + LINK % "arm" + JOINT % ("elbow", "continuous", "arm"))
# A name that begins with a slash can be in one robot only: it is the same frame for all.
WITH_TABLE = DESCRIPTION.replace(
    "</robot>", LINK % "/table" + JOINT % ("to_table", "fixed", "/table") + "</robot>")
DESCRIPTIONS = {"left": WITH_TABLE, "right": DESCRIPTION}
FRAMES = {"left": {"base": "left/base", "arm": "left/arm", "/table": "table"},
          "right": {"base": "right/base", "arm": "right/arm"}}
DEGREES = {"left": 30, "right": 45}


def node(side):
    return "/" + side + "/link_bounds_publisher"


def state_publisher_knows_prefixes():
    version = rospkg.RosPack().get_manifest("robot_state_publisher").version
    return tuple(int(part) for part in version.split(".")) >= FIRST_WITH_PREFIX


def arm_pose(side):
    return Pose((1, 0, 0), turn((0, 0, 1), DEGREES[side]))


def link_bounds(base_from_link):
    return (base_from_link * Pose(CENTRE)).box_bounds(SIZE)


class TwoRobotsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("two_robots_test")
        cls.boxes = {side: Recorder(node(side) + "/boxes") for side in DESCRIPTIONS}
        for side, description in DESCRIPTIONS.items():
            load(node(side), description)
        cls.state_publishers = []
        if state_publisher_knows_prefixes():
            cls.move_by_state_publishers()
        else:
            cls.move_by_tf()

    @classmethod
    def move_by_state_publishers(cls):
        program = executable("robot_state_publisher", "robot_state_publisher")
        cls.state_publishers = [subprocess.Popen([program, "__ns:=/" + side])
                                for side in DESCRIPTIONS]
        cls.messages = {side: JointSender("/%s/joint_states" % side).move(
            {"elbow": math.radians(DEGREES[side])}, cls.boxes[side]) for side in DESCRIPTIONS}

    @classmethod
    def move_by_tf(cls):
        tf, static_tf = TfSender(), TfSender(is_static=True)
        wait_for(lambda: tf.listeners() >= 2 and static_tf.listeners() >= 2, "both nodes listen")
        stamp = rospy.Time.now()
        static_tf.send(transform("left/base", "table", stamp, (1, 0, 0)))
        for side in DESCRIPTIONS:
            pose = arm_pose(side)
            tf.send(transform(side + "/base", side + "/arm", stamp, pose.xyz, pose.xyzw))
        cls.messages = {side: boxes.wait(lambda m: m.boxes and not m.incomplete, "all boxes")
                        for side, boxes in cls.boxes.items()}

    @classmethod
    def tearDownClass(cls):
        for process in cls.state_publishers:
            process.send_signal(signal.SIGINT)
            process.wait(timeout=20)

    def test_names_of_boxes_are_those_of_the_description(self):
        for side, message in self.messages.items():
            self.assertEqual(names_of(message), list(FRAMES[side]))

    def test_frame_has_the_prefix(self):
        for side, message in self.messages.items():
            self.assertEqual(message.header.frame_id, side + "/base")

    def test_each_robot_moves_by_itself(self):
        for side, message in self.messages.items():
            self.assertLess(difference(corners_of(message.boxes[0]), link_bounds(Pose())),
                            TOLERANCE)
            self.assertLess(difference(corners_of(message.boxes[1]),
                                       link_bounds(arm_pose(side))), TOLERANCE)

    def test_name_with_a_slash_takes_no_prefix(self):
        table = self.messages["left"].boxes[2]
        self.assertEqual(table.name, "/table")
        self.assertLess(difference(corners_of(table), link_bounds(Pose((1, 0, 0)))),
                        TOLERANCE)

    def test_namespaces_of_markers_are_names_in_tf(self):
        for side, frames in FRAMES.items():
            message = Recorder(node(side) + "/markers", MarkerArray).wait(
                lambda m: m.markers, "boxes")
            self.assertEqual({marker.ns for marker in message.markers}, set(frames.values()))
            self.assertEqual({m.header.frame_id for m in message.markers}, {side + "/base"})


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "two_robots", TwoRobotsTest)
