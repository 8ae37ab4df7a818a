#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes a picture of one moment of scripts/pictures_scene.launch: picture_scene.py PICTURE.png

All motion is a function of ROS time, so the picture is the same each time. At the end, the nodes
that move something are stopped and time goes on for a moment, so that the boxes are those of the
last poses.
"""
import sys
import time

import rosgraph
import rosnode
import rospy
from rosgraph_msgs.msg import Clock
from rviz_stage import still_screen, to_size, wait_for

MOMENT = 20.0  # s since the start, when the hand is in the box of another object
SETTLING = 0.5  # s of ROS time: many periods of overlap_colors
STEP, PACE = 0.02, 0.01  # s of ROS time, and s of wall time for each of them
MOVERS = ['/joint_mover', '/scene_objects']


def set_time(clock, seconds):
    clock.publish(Clock(rospy.Time.from_sec(seconds)))


def pass_time(clock, start, end):
    for step in range(round(start / STEP) + 1, round(end / STEP) + 1):
        set_time(clock, step * STEP)
        time.sleep(PACE)


def listeners(topic):
    _, subscribers, _ = rosgraph.Master('picture_scene').getSystemState()
    return set(dict(subscribers).get(topic, []))


def is_all_there():
    clocked = {*MOVERS, '/link_bounds_publisher', '/overlap_colors', '/rviz'}
    return clocked <= listeners('/clock') and '/rviz' in listeners('/overlap_colors/markers')


def main():
    wait_for(rosgraph.is_master_online, 'the ROS master')
    rospy.init_node('picture_scene')
    clock = rospy.Publisher('/clock', Clock, queue_size=1000, latch=True)
    set_time(clock, 0.001)  # near 0: some nodes count from the first time that they see
    wait_for(is_all_there, 'rviz and what it shows')
    pass_time(clock, 0, MOMENT)
    rosnode.kill_nodes(MOVERS)
    wait_for(lambda: not listeners('/clock') & set(MOVERS), 'the end of the moving nodes')
    pass_time(clock, MOMENT, MOMENT + SETTLING)
    to_size(still_screen()).save(sys.argv[1])


if __name__ == '__main__':
    main()
