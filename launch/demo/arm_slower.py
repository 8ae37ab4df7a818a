#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slows the demo's arm while a stopping box of one of its links meets an object.

Subscribes to stopping_overlaps of link_bounds_publisher; publishes joint_mover/speed
(std_msgs/Float64), a factor from 0 to 1. For the demo alone: nothing here is made for safety.
"""

import os
import sys

import rospy
from link_bounds.msg import BoxOverlapArray
from std_msgs.msg import Float64

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments  # noqa: E402

SLOWER, FASTER = 0.8, 0.02  # times and plus, with each message: the boxes shrink with the speed


class Slower:
    def __init__(self):
        self.speed = 1.0
        self.publisher = rospy.Publisher('joint_mover/speed', Float64, queue_size=1)
        rospy.Subscriber('link_bounds_publisher/stopping_overlaps', BoxOverlapArray, self.take,
                         queue_size=1, tcp_nodelay=True)

    def take(self, message):
        meets = any(('/' in pair.first) != ('/' in pair.second) for pair in message.overlaps)
        self.speed = self.speed * SLOWER if meets else min(1.0, self.speed + FASTER)
        self.publisher.publish(self.speed)


if __name__ == '__main__':
    check_arguments(__doc__)
    rospy.init_node('arm_slower')
    slower = Slower()
    rospy.spin()
