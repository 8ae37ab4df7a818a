#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the arm beside a ball, and how far they are apart: picture_distances.py PICTURE.png

Line and number are those of ~distance_markers. Boxes are not drawn.
"""
import sys

import rospy
from link_bounds.msg import Distance
from rviz_stage import Stage, wait_for
from visualization_msgs.msg import Marker, MarkerArray

NODE = 'link_bounds_publisher/'
POSE = {'shoulder_pan': -0.6, 'shoulder_lift': 0.75, 'elbow_bend': 1.9, 'forearm_roll': 0.0,
        'wrist_bend': 0.5, 'wrist_roll': 0.4, 'finger_left_slide': 0.03}  # in rad and m
PLACE, SIZE = (0.437, -0.299, 0.645), (0.08, 0.08, 0.08)  # of the ball [m]
ACCURACY = 1e-4  # m, the default of distance_accuracy; reached when triangles are loaded
CUT = (10, 10, 450, 410)  # left, top, right, bottom of what is shown


def ball():
    marker = Marker(ns='ball', type=Marker.SPHERE)
    marker.header.frame_id = 'base'
    marker.pose.position.x, marker.pose.position.y, marker.pose.position.z = PLACE
    marker.pose.orientation.w = 1
    marker.scale.x, marker.scale.y, marker.scale.z = SIZE
    marker.color.r, marker.color.g, marker.color.b, marker.color.a = 0.6, 0.68, 0.78, 1
    return marker


class Newest:
    """The last message of a topic."""

    def __init__(self, topic, kind):
        self._message = None
        rospy.Subscriber(NODE + topic, kind, self._take)

    def _take(self, message):
        self._message = message

    def wait(self, condition, what):
        wait_for(lambda: self._message and condition(self._message), what)
        return self._message


def main():
    stage = Stage('picture_distances')
    nearest = Newest('nearest', Distance)
    markers = Newest('distance_markers', MarkerArray)
    sender = rospy.Publisher(NODE + 'object', Marker, queue_size=1, latch=True)
    sender.publish(ball())
    stage.warm_up(POSE)
    nearest.wait(lambda m: m.first == 'forearm' and m.distance_max - m.distance <= ACCURACY,
                 'the distance between forearm and ball')
    boxes, _ = stage.pose(POSE)
    lines = markers.wait(lambda m: m.markers[0].header.stamp == boxes.header.stamp, 'distances')
    stage.draw([ball()] + lines.markers)
    stage.picture().crop(CUT).save(sys.argv[1])


if __name__ == '__main__':
    main()
