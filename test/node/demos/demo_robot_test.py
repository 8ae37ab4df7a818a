#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo robot's boxes from tf are those that urdf_bounds computes from the same joints."""
import json
import subprocess
import unittest
from xml.etree import ElementTree

import rospkg
import rospy
import rostest

from bounds_testing import (JointSender, Recorder, corners_of, difference, executable, load,
                            names_of, union)
from demo_testing import POSES

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-9  # metres; both sides use the same meshes and differ in rounding only
URDF = rospkg.RosPack().get_path("link_bounds") + "/launch/demo/demo.urdf"


def expected(joint_values, geometry="visual"):
    """What urdf_bounds prints, boxes and groups as lists of six coordinates."""
    command = [executable("link_bounds", "urdf_bounds"), URDF, "--format", "json", "--geometry",
               geometry] + ["%s:=%r" % item for item in joint_values.items()]
    found = json.loads(subprocess.run(command, stdout=subprocess.PIPE, timeout=60,
                                      check=True).stdout.decode())
    return {name: box["min"] + box["max"]
            for name, box in {**found["boxes"], **found["groups"]}.items()}


class DemoRobotTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("demo_robot_test")
        cls.boxes = Recorder(NODE + "/boxes")
        cls.groups = Recorder(NODE + "/groups")
        cls.joint_sender = JointSender()
        cls.links = ElementTree.parse(URDF).getroot().findall("link")

    def move(self, joint_values):
        return self.joint_sender.move(joint_values, self.boxes)

    def check_boxes(self, message, wanted):
        self.assertGreater(len(message.boxes), 5)
        for box in message.boxes:
            self.assertLess(difference(corners_of(box), wanted[box.name]), TOLERANCE, box.name)

    def test_boxes_are_those_of_urdf_bounds(self):
        load(NODE)
        for pose in POSES:
            self.check_boxes(self.move(pose), expected(pose))

    def test_geometry_both(self):
        load(NODE, geometry="both")
        for pose in POSES[1:3]:
            wanted = expected(pose, "both")
            self.assertGreater(
                max(difference(wanted[name], box) for name, box in expected(pose).items()), 0.001)
            self.check_boxes(self.move(pose), wanted)

    def test_order_is_that_of_the_link_elements(self):
        load(NODE)
        with_visual = [link.get("name") for link in self.links if link.find("visual") is not None]
        self.assertEqual(names_of(self.move(POSES[0])), with_visual)

    def test_link_without_geometry_has_no_box(self):
        load(NODE, geometry="both")
        without = [link.get("name") for link in self.links if len(link) == 0]
        self.assertEqual(without, ["tool0"])
        message = self.move(POSES[0])
        self.assertNotIn("tool0", names_of(message) + message.incomplete)

    def test_frame_is_the_root_link(self):
        load(NODE)
        self.assertEqual(self.move(POSES[1]).header.frame_id, "base")

    def test_group_robot_is_the_union(self):
        load(NODE)
        for pose in POSES:
            boxes = self.move(pose)
            groups = self.groups.wait(lambda m, stamp=boxes.header.stamp: m.header.stamp == stamp,
                                      "the groups of the same time")
            self.assertEqual((names_of(groups), groups.incomplete), (["robot"], []))
            self.assertEqual(groups.header.frame_id, "base")
            robot = corners_of(groups.boxes[0])
            self.assertEqual(robot, union([corners_of(box) for box in boxes.boxes]))
            self.assertLess(difference(robot, expected(pose)["robot"]), TOLERANCE)


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "demo_robot", DemoRobotTest)
