#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the arm on its way to a ball, and what it can reach until it stands: picture_stopping.py
PICTURE.png

The boxes are those of ~stopping_markers. The ball is red, because a box of the gripper meets it.
"""
import sys

import rospy
from link_bounds.msg import BoxOverlapArray
from picture_distances import ball
from rviz_stage import Stage, wait_for
from sensor_msgs.msg import JointState
from visualization_msgs.msg import MarkerArray

NODE = 'link_bounds_publisher/'
POSE = {'shoulder_pan': -0.7, 'shoulder_lift': 0.5, 'elbow_bend': 1.5, 'forearm_roll': 0.0,
        'wrist_bend': 0.3, 'wrist_roll': 0.4, 'finger_left_slide': 0.03}  # in rad and m
SPEEDS = {'shoulder_pan': 1.0, 'wrist_bend': 0.4}  # rad/s
PERIOD, COUNT = 0.03, 10  # s and messages of the motion; robot_state_publisher takes 50 per second
PLACE, SIZE = (0.62, -0.2, 0.5), (0.12, 0.12, 0.12)  # of the ball [m]
CUT = (10, 10, 450, 410)  # left, top, right, bottom of what is shown


class Motion:
    """Of the joints until POSE; what the node says of its end."""

    def __init__(self):
        self._news = {}
        for topic, kind in (('stopping_markers', MarkerArray),
                            ('stopping_overlaps', BoxOverlapArray)):
            rospy.Subscriber(NODE + topic, kind, self._take, topic)
        self._joints = rospy.Publisher('joint_states', JointState, queue_size=COUNT)
        wait_for(self._joints.get_num_connections, 'robot_state_publisher')

    def _take(self, message, topic):
        self._news[topic] = message

    def send(self):
        """Returns the stamp of the end. Stamps are even however busy the machine is."""
        start = rospy.Time.now()
        for i in range(COUNT, -1, -1):
            message = JointState(name=list(POSE))
            message.header.stamp = start + rospy.Duration((COUNT - i) * PERIOD)
            message.position = [value - SPEEDS.get(joint, 0) * i * PERIOD
                                for joint, value in POSE.items()]
            self._joints.publish(message)
            rospy.sleep(PERIOD)
        return message.header.stamp

    def markers(self, stamp):
        """Once they and the overlaps have come."""
        def are_there():
            markers, overlaps = (self._news.get(topic) for topic in
                                 ('stopping_markers', 'stopping_overlaps'))
            return (markers and markers.markers and markers.markers[0].header.stamp == stamp and
                    overlaps and overlaps.header.stamp == stamp)
        wait_for(are_there, 'stopping boxes')
        meets = any('ball/0' in (pair.first, pair.second)
                    for pair in self._news['stopping_overlaps'].overlaps)
        if not meets:
            raise SystemExit('no stopping box meets the ball')
        return self._news['stopping_markers'].markers


def main():
    stage = Stage('picture_stopping')
    motion = Motion()
    stage.warm_up(POSE)
    sphere = ball()
    sphere.pose.position.x, sphere.pose.position.y, sphere.pose.position.z = PLACE
    sphere.scale.x, sphere.scale.y, sphere.scale.z = SIZE
    sphere.color.r, sphere.color.g, sphere.color.b = 0.85, 0.2, 0.15
    sender = rospy.Publisher(NODE + 'object', type(sphere), queue_size=1, latch=True)
    sender.publish(sphere)
    wait_for(sender.get_num_connections, 'the node')
    boxes = motion.markers(motion.send())
    stage.draw([sphere] + boxes)
    stage.picture().crop(CUT).save(sys.argv[1])


if __name__ == '__main__':
    main()
