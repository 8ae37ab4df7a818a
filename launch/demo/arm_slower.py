#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slows the demo's arm while a stopping box of one of its links meets an object, or is incomplete, and
while no message comes.

Subscribes to stopping and stopping_overlaps of link_bounds_publisher; publishes joint_mover/speed
(std_msgs/Float64), a factor from 0.1 to 1. For the demo alone: nothing here is made for safety.
"""

import os
import sys
import threading
import time

import rospy
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray
from std_msgs.msg import Float64

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments, run  # noqa: E402

SLOWER = 0.8  # times, with each message: the boxes shrink with the speed
FASTER, LONGEST = 1.0, 0.2  # plus in a second, but for at most that many seconds between messages
PERIOD, SILENCE = 0.1, 0.5  # s of wall time: of the watch, and what it bears without a message
SLOWEST = 0.1  # the arm comes out of an object that does not go away


class Slower:
    def __init__(self):
        self.speed, self.stamp, self.boxes = 1.0, rospy.Time(), AxisAlignedBoxArray()
        self.heard = time.monotonic()
        self.publisher = rospy.Publisher('joint_mover/speed', Float64, queue_size=1)
        rospy.Subscriber('link_bounds_publisher/stopping', AxisAlignedBoxArray, self.take_boxes,
                         queue_size=1, tcp_nodelay=True)
        rospy.Subscriber('link_bounds_publisher/stopping_overlaps', BoxOverlapArray, self.take,
                         queue_size=1, tcp_nodelay=True)

    def take_boxes(self, boxes):  # of stopping
        self.boxes = boxes

    def take(self, message):  # of stopping_overlaps
        self.heard = time.monotonic()
        boxes = self.boxes  # another thread replaces them
        meets = any(('/' in pair.first) != ('/' in pair.second) for pair in message.overlaps)
        seconds = max(0.0, min((message.header.stamp - self.stamp).to_sec(), LONGEST))
        if meets or boxes.incomplete:
            self.speed, self.stamp = self.speed * SLOWER, message.header.stamp
        elif boxes.header.stamp == message.header.stamp:  # those that the overlaps are of
            self.speed, self.stamp = self.speed + FASTER * seconds, message.header.stamp
        self.speed = min(1.0, max(SLOWEST, self.speed))
        self.publisher.publish(self.speed)

    def watch(self):  # every PERIOD; a node that hangs or has ended sees nothing
        if time.monotonic() - self.heard > SILENCE:
            self.speed = max(SLOWEST, self.speed * SLOWER)
            self.publisher.publish(self.speed)


def main():
    check_arguments(__doc__)
    rospy.init_node('arm_slower')
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    slower = Slower()
    while not ended.wait(PERIOD):
        slower.watch()


if __name__ == '__main__':
    run(main)
