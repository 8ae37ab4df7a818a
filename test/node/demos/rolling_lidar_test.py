#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of doc/scene.md removes a moving tool from a scan, and nothing else, no object
either."""
import math
import os
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from bounds_testing import (Pose, Recorder, TfSender, box_link, box_of, robot, transform, turn,
                            wait_for)
from node_testing import NodeProcess
from object_testing import ObjectSender, marker
from page_testing import code_block
from sensor_msgs.msg import LaserScan
from visualization_msgs.msg import Marker

RAYS = 181
FOLLOWED = 60  # the last ray that follows the tool
SCAN_TIME = 0.1  # s
TOOL, WALL = 2.0, 5.0  # m
TIMEOUT = 60.0  # s; this machine may be slow
ARM = robot([box_link("base", (0.2, 0.2, 0.2)), box_link("tool", (0.2, 0.2, 0.2))],
            [("base", "tool")])


class RollingLidar(unittest.TestCase):
    """The lidar turns by one degree with each ray. The tool goes with the first of them, so that
    all of these hit it; none of the tool's poses alone explains more than a few."""

    def setUp(self):
        script = tempfile.NamedTemporaryFile("w", suffix=".py", encoding="utf-8")
        script.write(code_block("doc/scene.md", "### A rolling lidar", "python"))
        script.flush()
        self.addCleanup(script.close)
        self.tf, self.tf_static = TfSender(), TfSender(is_static=True)
        self.scans = Recorder("/rolling_lidar/scan", LaserScan)
        self.publisher = rospy.Publisher("/scan", LaserScan, queue_size=10)
        rospy.set_param("/rolling_lidar/links", ["base", "tool"])
        consumer = subprocess.Popen([sys.executable, script.name], env=os.environ)
        self.addCleanup(consumer.wait)
        self.addCleanup(consumer.kill)
        rospy.set_param("/robot_description", ARM)
        self.boxes = Recorder("/link_bounds_publisher/boxes")
        node = NodeProcess("link_bounds_publisher", timeout=TIMEOUT)
        self.addCleanup(node.end)
        self.boxes.wait(lambda m: True, "a model")
        self.tf.wait_for_listener()
        self.tf_static.wait_for_listener()
        wait_for(lambda: self.publisher.get_num_connections() > 0 and
                 self.scans.subscriber.get_num_connections() > 0, "connected")

    def move_tool(self, start):
        """Around the lidar, from the first ray on; returns when the node knows it."""
        step = SCAN_TIME / (RAYS - 1)
        self.tf_static.send(transform("base", "lidar", rospy.Time()),
                            transform("arm", "tool", rospy.Time(), (TOOL, 0, 0)))
        for ray, degrees in ((0, -30), (FOLLOWED, -30 + FOLLOWED), (RAYS, -30 + FOLLOWED)):
            stamp = start + rospy.Duration(ray * step)
            self.tf.send(transform("base", "arm", stamp, (0, 0, 0), turn((0, 0, 1), degrees)))
        self.boxes.wait_newest(lambda m: not m.incomplete and box_of(m, "tool").stamp == stamp,
                               "the tool at the end")

    def send_scan(self, start):
        scan = LaserScan()
        scan.header.stamp = start
        scan.header.frame_id = "lidar"
        scan.angle_min, scan.angle_increment = math.radians(-30), math.radians(1)
        scan.angle_max = math.radians(-30 + RAYS - 1)
        scan.time_increment, scan.range_max = SCAN_TIME / (RAYS - 1), 10
        scan.ranges = [TOOL if i <= FOLLOWED else WALL for i in range(RAYS)]
        self.publisher.publish(scan)

    def test_the_tool_alone_is_removed(self):
        start = rospy.Time(1000)
        self.move_tool(start)
        objects = ObjectSender("/link_bounds_publisher")
        objects.send(marker("pallet/1", pose=Pose((0, WALL, 0))),
                     marker("broken/1", Marker.MESH_RESOURCE, mesh_resource="file:///no.stl"))
        self.boxes.wait(lambda m: m.incomplete == ["broken/1"] and box_of(m, "pallet/1"),
                        "the objects")
        self.send_scan(start + rospy.Duration(1))  # tf does not know so much: it is dropped
        self.send_scan(start)
        scan = self.scans.wait(lambda m: True, "a scan")
        self.assertEqual(scan.header.stamp, start)
        self.assertEqual(list(scan.ranges),
                         [math.inf if i <= FOLLOWED else WALL for i in range(RAYS)])


if __name__ == "__main__":
    rospy.init_node("rolling_lidar_test")
    rostest.rosrun("link_bounds", "rolling_lidar_example", RollingLidar)
