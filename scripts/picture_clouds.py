#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two pictures of one moment of launch/cloud_demo.launch, whose time it moves:
picture_clouds.py BEFORE.rviz AFTER.rviz PICTURE.png

Left: the cloud of the camera. Right: that of cloud_filter. rviz is started for each.
"""
import subprocess
import sys
import time

import rosgraph
import rosnode
import rospy
from PIL import Image
from rosgraph_msgs.msg import Clock
from rviz_stage import still_screen, to_size, wait_for
from sensor_msgs.msg import PointCloud2

MOMENT = 8.1             # s since the start, when the camera sees between the fingers
STEP, PACE = 0.02, 0.01  # s of ROS time, and s of wall time for each of them
NODES = {'/joint_mover', '/depth_camera', '/cloud_filter', '/robot_state_publisher'}


def listeners(topic):
    _, subscribers, _ = rosgraph.Master('picture_clouds').getSystemState()
    return set(dict(subscribers).get(topic, []))


class Time:
    def __init__(self):
        self.seconds = 0
        self.clock = rospy.Publisher('/clock', Clock, queue_size=1000, latch=True)
        self.go_on()

    def go_on(self):
        self.seconds += STEP
        self.clock.publish(Clock(rospy.Time.from_sec(self.seconds)))
        time.sleep(PACE)


def picture(now, display_config, clouds):
    """While clouds of the resting arm come, each as the one before."""
    rviz = subprocess.Popen(['rosrun', 'rviz', 'rviz', '--fullscreen', '--display-config',
                             display_config])
    try:
        wait_for(lambda: any(name.startswith('/rviz') for name in listeners(clouds)), 'rviz')
        for _ in range(500):
            now.go_on()
        return to_size(still_screen())
    finally:
        rviz.terminate()
        rviz.wait()


def main():
    wait_for(rosgraph.is_master_online, 'the ROS master')
    rospy.init_node('picture_clouds', disable_rostime=True)
    now = Time()
    wait_for(lambda: NODES <= listeners('/clock'), 'the nodes')
    filtered = []
    rospy.Subscriber('/cloud_filter/output', PointCloud2, filtered.append)
    while now.seconds < MOMENT:
        now.go_on()
    rosnode.kill_nodes(['/joint_mover'])
    wait_for(lambda: '/joint_mover' not in listeners('/clock'), 'the arm to rest')
    wait_for(lambda: now.go_on() or filtered, 'a filtered cloud')
    shots = [picture(now, path, topic) for path, topic in
             ((sys.argv[1], '/depth_camera/points'), (sys.argv[2], '/cloud_filter/output'))]
    both = Image.new('RGB', (shots[0].width + shots[1].width + 8, shots[0].height), '#8a94a0')
    both.paste(shots[0], (0, 0))
    both.paste(shots[1], (shots[0].width + 8, 0))
    both.save(sys.argv[3])


if __name__ == '__main__':
    main()
