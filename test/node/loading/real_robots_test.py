#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node's boxes of real robots, moved by robot_state_publisher, are the true ones."""
import json
import os
import signal
import subprocess
import sys
import unittest
from xml.etree import ElementTree

import rospy
import rostest

from bounds_testing import (JointSender, Recorder, corners_of, difference, executable, load,
                            names_of)

NODE = "/link_bounds_publisher"
DATA = os.environ.get("LINK_BOUNDS_DATA")
ROBOTS = os.path.join(DATA or "", "robots")
HAS_TRUTH = bool(DATA) and os.path.exists(os.path.join(ROBOTS, "truth"))
SKIPPED = ("skipped: real_robots: LINK_BOUNDS_DATA "
           + ("has no robots/truth" if DATA else "is not set"))

# The truth was computed from decimal texts in double, our vertices are float32.
RELATIVE_TOLERANCE = 4e-6  # of the largest |coordinate| or the size of a box
ABSOLUTE_TOLERANCE = 1e-8  # metres


def tolerance(box):
    size = max(high - low for low, high in zip(box[:3], box[3:]))
    return RELATIVE_TOLERANCE * max(size, *map(abs, box)) + ABSOLUTE_TOLERANCE


class Robot:
    """A robot of the data set: description and true boxes."""

    def __init__(self, name):
        with open(os.path.join(ROBOTS, "truth", name + ".json"), encoding="utf-8") as file:
            truth = json.load(file)
        with open(os.path.join(ROBOTS, truth["urdf"]), encoding="utf-8") as file:
            self.description = file.read()
        self.root = truth["root_link"]
        self.configurations = [config["joints"] for config in truth["configs"]]
        self._states = truth["links"]

    def boxes(self, configuration, geometry):
        """By name, in the order of the description; six coordinates each."""
        result = {}
        for link in ElementTree.fromstring(self.description.encode()).findall("link"):
            state = self._states[link.get("name")][configuration][geometry]
            if state:
                result[link.get("name")] = state["aabb_min"] + state["aabb_max"]
        return result


class RealRobotsTest(unittest.TestCase):
    compared = 0
    worst = 0.0  # metres

    @classmethod
    def tearDownClass(cls):
        print("truth: %d boxes compared; worst error %.3g m" % (cls.compared, cls.worst))

    @classmethod
    def setUpClass(cls):
        rospy.init_node("real_robots_test")
        cls.boxes = Recorder(NODE + "/boxes")
        cls.joint_sender = JointSender()

    def check_robot(self, name):
        real_robot = Robot(name)
        self.assertGreater(len(real_robot.configurations), 2)
        load(NODE, real_robot.description)
        state_publisher = subprocess.Popen(
            [executable("robot_state_publisher", "robot_state_publisher"), "__name:=of_" + name])
        try:
            for geometry in ("visual", "collision"):
                load(NODE, geometry=geometry)
                for index in range(len(real_robot.configurations)):
                    self.check_configuration(real_robot, index, geometry)
        finally:
            state_publisher.send_signal(signal.SIGINT)
            state_publisher.wait(timeout=20)

    def check_configuration(self, real_robot, index, geometry):
        message = self.joint_sender.move(real_robot.configurations[index], self.boxes)
        truth = real_robot.boxes(index, geometry)
        self.assertEqual(message.header.frame_id, real_robot.root)
        self.assertEqual(names_of(message), list(truth))
        self.assertGreater(len(truth), 5)
        for box in message.boxes:
            expected = truth[box.name]
            error = difference(corners_of(box), expected)
            self.assertLess(error, tolerance(expected),
                            "%s, configuration %d, %s" % (box.name, index, geometry))
            RealRobotsTest.compared += 1
            RealRobotsTest.worst = max(RealRobotsTest.worst, error)

    def test_panda(self):
        self.check_robot("panda")

    def test_ur5e(self):
        self.check_robot("ur5e")

    def test_gen3_robotiq_2f_85(self):
        self.check_robot("gen3_robotiq_2f_85")


class NothingTest(unittest.TestCase):
    """Without data not one test runs, so none is counted as passed."""


if __name__ == "__main__":
    if "--say-skipped" in sys.argv:
        if not HAS_TRUTH:
            print(SKIPPED)
    else:
        rostest.rosrun("link_bounds", "real_robots",
                       RealRobotsTest if HAS_TRUTH else NothingTest)
