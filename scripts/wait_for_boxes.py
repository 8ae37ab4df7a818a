#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waits until link_bounds_publisher has published a box; exit status 1 if it is interrupted."""

import sys
import threading
import time

import rosgraph
import rospy
from link_bounds.msg import AxisAlignedBoxArray


def main():
    while not rosgraph.is_master_online():
        time.sleep(0.2)
    rospy.init_node('wait_for_boxes', anonymous=True)
    seen = threading.Event()
    rospy.on_shutdown(seen.set)
    rospy.Subscriber('link_bounds_publisher/boxes', AxisAlignedBoxArray,
                     lambda message: message.boxes and seen.set(), queue_size=1)
    seen.wait()
    return int(rospy.is_shutdown())


if __name__ == '__main__':
    sys.exit(main())
