#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""cloud_filter as a nodelet: it sends the same bytes as the program, others of its manager go on
without it, and a wrong parameter does not end the manager."""
import itertools
import math
import random
import subprocess
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, box_link, executable, robot, transform, wait_for
from cloud_testing import cloud, wait_status
from diagnostic_msgs.msg import DiagnosticArray
from link_bounds.msg import DistanceArray
from raw_messages import serialized
from sensor_msgs.msg import LaserScan, PointCloud2
from std_srvs.srv import Trigger

HAND = robot([box_link("base", (0.2, 0.2, 0.1)), box_link("left", (0.02, 0.02, 0.1), (0, 0.05, 0))],
             [("base", "left")])
OTHER = robot([box_link("base", (0.1, 0.3, 0.1))], [])
NODES = ["/%s/%s" % pair for pair in itertools.product(("organized", "compact"),
                                                       ("nodelet", "program"))]
TOPICS = {"output": PointCloud2, "robot_points": PointCloud2, "nearest": DistanceArray,
          "output_scan": LaserScan}


def random_cloud(stamp, count, rng):
    """Around the hand."""
    rows = [([rng.uniform(-0.2, 0.2) for _ in range(3)], rng.randrange(50000000))
            for _ in range(count)]
    return cloud(stamp, *zip(*rows))


def bytes_of(message):
    """Without the number that each publisher counts."""
    message.header.seq = 0
    return serialized(message)


class CloudNodelet(unittest.TestCase):
    def setUp(self):
        self.outputs = {(node, topic): Recorder(node + "/" + topic, kind)
                        for node in NODES for topic, kind in TOPICS.items()}
        self.status = Recorder("/diagnostics", DiagnosticArray)
        self.clouds = rospy.Publisher("/cloud", PointCloud2, queue_size=100)
        self.scans = rospy.Publisher("/scan", LaserScan, queue_size=100)
        self.tf = TfSender()
        rospy.set_param("/robot_description", HAND)
        rospy.set_param("/other_description", OTHER)
        for node in NODES:
            wait_status(self.status, node, lambda status: status.level == 1, is_new=False)
        for recorder in self.outputs.values():
            wait_for(lambda r=recorder: r.subscriber.get_num_connections() > 0, recorder.topic)
        # The manager and the programs: it has one connection for all of its nodelets.
        wait_for(lambda: self.clouds.get_num_connections() >= 3, "the filters listen to clouds")
        wait_for(lambda: self.scans.get_num_connections() >= 2, "the filters listen to scans")
        wait_for(lambda: self.tf.listeners() >= 3, "the filters listen to tf")
        self.stamp = rospy.Time.now()

    def send_tf(self):
        """The hand turns and moves, and so does the base of the other robot."""
        self.stamp += rospy.Duration(1)
        for k in range(-5, 15):
            seconds = 0.01 * k
            stamp = self.stamp + rospy.Duration(seconds)
            turn = (0, 0, math.sin(2 * seconds), math.cos(2 * seconds))
            self.tf.send(transform("sensor", "base", stamp, (seconds, 0, 0), turn),
                         transform("base", "left", stamp, (0, 0, 0.1 * seconds)))

    def newest(self, node, topic):
        return self.outputs[node, topic].wait(
            lambda message: message.header.stamp == self.stamp, "what was sent")

    def check_same(self, group, topic):
        nodelet, program = (self.newest("/%s/%s" % (group, node), topic)
                            for node in ("nodelet", "program"))
        self.assertEqual(bytes_of(nodelet), bytes_of(program), (group, topic))
        return program

    def unload(self, name):
        subprocess.run([executable("nodelet", "nodelet"), "unload", name, "/manager"], check=True,
                       timeout=60)

    def test_it_sends_what_the_program_sends(self):
        rng = random.Random(1)
        for count in (1, 500, 5000):
            self.send_tf()
            self.clouds.publish(random_cloud(self.stamp, count, rng))
            for group, topic in itertools.product(("organized", "compact"),
                                                  ("output", "robot_points", "nearest")):
                message = self.check_same(group, topic)
                if topic == "robot_points" and count > 1:
                    self.assertTrue(0 < message.width < count, message.width)
        scan = LaserScan(angle_min=-math.pi, angle_increment=0.01, range_min=0.01, range_max=10,
                         ranges=[rng.uniform(0.05, 0.2) for _ in range(600)])
        scan.header.stamp, scan.header.frame_id = self.stamp, "sensor"
        self.scans.publish(scan)
        ranges = self.check_same("organized", "output_scan").ranges
        self.assertTrue(0 < sum(map(math.isnan, ranges)) < 600)

        # A wrong parameter: no robot, until it is right and ~reload was called.
        wait_status(self.status, "/wrong", lambda status: status.level == 2 and
                    "no robot can be loaded: parameter ~padding" in status.message,
                    is_new=False)
        rospy.set_param("/wrong/padding", 0.01)
        answer = rospy.ServiceProxy("/wrong/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        wait_status(self.status, "/wrong", lambda status: status.level == 1, is_new=False)

        # The first one goes, and with it what the others share with it.
        self.unload("/organized/nodelet")
        wait_for(lambda: self.outputs["/organized/nodelet", "output"]
                 .subscriber.get_num_connections() == 0, "the nodelet is unloaded")
        for count in (700, 800):
            self.send_tf()
            self.clouds.publish(random_cloud(self.stamp, count, rng))
            self.check_same("compact", "output")


if __name__ == "__main__":
    rospy.init_node("cloud_nodelet_test")
    rostest.rosrun("link_bounds", "cloud_nodelet_test", CloudNodelet)
