#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""link_bounds.launch rviz:=true starts rviz in the fixed frame of the node, whatever the root link,
tf_prefix and names are. A script takes the place of rviz."""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest
from bounds_testing import wait_for
from node_testing import ARMS

CONFIGURATION = rospkg.RosPack().get_path("link_bounds") + "/launch/link_bounds.rviz"
LAUNCH_LIMIT = 60.0  # wall seconds on a busy machine
FAKE = """#!/bin/sh
printf '%s\\n' "$@" > "$RVIZ_ARGUMENTS.new"
mv "$RVIZ_ARGUMENTS.new" "$RVIZ_ARGUMENTS"
"""


class RvizFrame(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.arguments = os.path.join(self.folder, "arguments")
        path = os.path.join(self.folder, "rviz")
        with open(path, "w", encoding="ascii") as file:
            file.write(FAKE)
        os.chmod(path, 0o755)

    def arguments_of_rviz(self, *launch_arguments):
        """What rviz gets from link_bounds.launch."""
        environment = dict(os.environ, RVIZ_ARGUMENTS=self.arguments,
                           PATH=self.folder + os.pathsep + os.environ["PATH"])
        launch = subprocess.Popen(["roslaunch", "--wait", "link_bounds", "link_bounds.launch",
                                   "rviz:=true", *launch_arguments], env=environment,
                                  stdin=subprocess.DEVNULL)
        try:
            wait_for(lambda: os.path.exists(self.arguments), "rviz starts", LAUNCH_LIMIT)
        finally:
            launch.send_signal(signal.SIGINT)
            launch.wait(LAUNCH_LIMIT)
        with open(self.arguments, encoding="utf-8") as file:
            return file.read().split("\n")[:-1]

    def check(self, arguments, frame):
        self.assertEqual(arguments[:2], ["--display-config", CONFIGURATION])
        self.assertEqual(arguments[-2:], ["--fixed-frame", frame])

    def test_without_rviz(self):
        script = os.path.join(os.path.dirname(CONFIGURATION), "rviz_in_fixed_frame.py")
        for distro, package in (("Debian", "rviz"), ("one", "ros-one-rviz")):
            done = subprocess.run([sys.executable, script], timeout=LAUNCH_LIMIT, check=False,
                                  env=dict(os.environ, PATH=self.arguments, ROS_DISTRO=distro),
                                  stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr.decode(), "rviz_in_fixed_frame: rviz is not installed; "
                             f"install its package {package}\n")

    def test_root_link(self):
        rospy.set_param("/robot_description", ARMS)
        self.addCleanup(rospy.delete_param, "/robot_description")
        self.check(self.arguments_of_rviz(), "base")

    def test_a_config_file_reaches_the_node_and_wins(self):
        rospy.set_param("/robot_description", ARMS)
        self.addCleanup(rospy.delete_param, "/robot_description")
        config = os.path.join(self.folder, "config.yaml")
        with open(config, "w", encoding="ascii") as file:
            file.write("fixed_frame: from_file\n")
        self.check(self.arguments_of_rviz("config:=" + config, "fixed_frame:=from_argument"),
                   "from_file")

    def test_other_names(self):
        rospy.set_param("/cell/urdf", ARMS)
        arguments = self.arguments_of_rviz(
            "name:=other", "tf_prefix:=left", "robot_description:=/cell/urdf")
        self.check(arguments, "left/base")
        self.assertIn("robot_description:=/cell/urdf", arguments)
        for topic in ("markers", "distance_markers"):
            self.assertIn("/link_bounds_publisher/%s:=other/%s" % (topic, topic), arguments)


if __name__ == "__main__":
    rospy.init_node("rviz_frame_test")
    rostest.rosrun("link_bounds", "rviz_frame", RvizFrame)
