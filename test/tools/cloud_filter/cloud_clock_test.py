#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""cloud_filter while the clock jumps back, as at the begin of each loop of a bag."""
import itertools
import math
import struct
import time
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, box_link, robot, transform, wait_for
from cloud_testing import cloud
from diagnostic_msgs.msg import DiagnosticArray
from link_bounds.msg import DistanceArray
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import Marker, MarkerArray


class CloudClock(unittest.TestCase):
    def setUp(self):
        self.output = Recorder("/cloud_filter/output", PointCloud2)
        self.status = Recorder("/diagnostics", DiagnosticArray)
        self.clock = rospy.Publisher("/clock", Clock, queue_size=100)
        self.clouds = rospy.Publisher("/cloud", PointCloud2, queue_size=100)
        self.tf = TfSender()
        rospy.set_param("/robot_description", robot([box_link("hand", (0.2, 0.2, 0.2))], []))
        self.tf.wait_for_listener()
        wait_for(lambda: self.clouds.get_num_connections() >= 1, "the filter listens")
        wait_for(lambda: self.clock.get_num_connections() >= 1, "the filter hears the clock")

    def send(self, seconds, x):
        """The hand is at x at that time."""
        self.clock.publish(Clock(rospy.Time(seconds)))
        self.tf.send(transform("sensor", "hand", rospy.Time(seconds), (x, 0, 0)))

    def is_removed(self, seconds, hand, x):
        """Whether a point at x is the robot's while the hand is there. What the filter hears before
        it hears the clock is lost, so all is sent again until the cloud comes back."""
        self.output.clear()

        def has_come():
            self.send(seconds, hand)
            self.clouds.publish(cloud(rospy.Time(seconds), [(x, 0, 0)]))
            time.sleep(0.1)
            return any(m.header.stamp == rospy.Time(seconds) for m in self.output.messages)
        wait_for(has_come, "the cloud comes back")
        message = self.output.messages[-1]
        return math.isnan(struct.unpack("<f", message.data[:4])[0])

    def time_of_status(self):
        return self.status.messages[-1].header.stamp if self.status.messages else None

    def wait_status(self, condition, what):
        self.status.wait(lambda message: any(condition(value.key, value.value)
                                             for status in message.status
                                             for value in status.values), what)

    def test_a_beginning_of_the_clock(self):
        """What the robot held before lives on; it goes first, because the clock begins once."""
        marker = Marker(ns="held", id=1, type=Marker.CUBE, frame_locked=True,
                        lifetime=rospy.Duration(20))
        marker.header.frame_id, marker.pose.orientation.w = "hand", 1
        marker.pose.position.x = 0.5
        marker.scale.x = marker.scale.y = marker.scale.z = 0.1
        objects = rospy.Publisher("/cloud_filter/objects", MarkerArray, queue_size=1)
        wait_for(lambda: objects.get_num_connections() >= 1, "the filter listens to objects")
        objects.publish(MarkerArray([marker]))
        self.status.clear()
        wait_for(lambda: len(self.status.messages) >= 3, "the filter hears of the object")
        steps = itertools.count()
        wait_for(lambda: self.is_removed(1000 + next(steps) / 100, 1, 1.5),
                 "the grid of the object is made")
        for seconds in (1001, 1002):
            self.assertTrue(self.is_removed(seconds, 1, 1.5))

    def test_a_jump_back(self):
        self.assertTrue(self.is_removed(1000, 1, 1))
        self.assertFalse(self.is_removed(1001, 1, 2))
        # This one waits for tf when the clock jumps; tf of its time never comes.
        self.clock.publish(Clock(rospy.Time(1002)))
        wait_for(lambda: self.time_of_status() == rospy.Time(1002), "the filter hears the clock")
        self.clouds.publish(cloud(rospy.Time(1002), [(1, 0, 0)]))
        self.wait_status(lambda key, value: (key, value) == ("waiting", "1"), "the cloud waits")
        self.send(500, 2)
        self.wait_status(lambda key, _: "the clock jumped back" in key, "the cloud is dropped")
        # What tf said of the time before the jump is forgotten.
        self.assertTrue(self.is_removed(501, 2, 2))
        self.assertFalse(self.is_removed(502, 2, 1))

    def test_missing_nearest_points_are_logged_while_the_clock_stands(self):
        """It stands within its first ten seconds. As in cloud_filter_test, the hand turns so fast
        that nothing is known of a point far away."""
        log, nearest = Recorder("/rosout", Log), Recorder("/cloud_filter/nearest", DistanceArray)
        for recorder in (log, nearest):
            wait_for(lambda: recorder.subscriber.get_num_connections() >= 1, recorder.topic)
        begin = rospy.Time(5)

        def is_logged():
            self.clock.publish(Clock(begin))
            for i in range(-5, 10):
                self.tf.send(transform("sensor", "hand", begin + rospy.Duration(i / 50), (0, 0, 0),
                                       (0, 0, math.sin(i / 2), math.cos(i / 2))))
            self.clouds.publish(cloud(begin, [(900, 0, 0), (0, 0, 2)], (0, 90000000)))
            time.sleep(0.1)
            return any(message.msg.startswith("no ~nearest: ") for message in log.messages)
        wait_for(is_logged, "why there are no nearest points")


if __name__ == "__main__":
    rospy.init_node("cloud_clock_test", disable_rostime=True)
    rostest.rosrun("link_bounds", "cloud_clock_test", CloudClock)
