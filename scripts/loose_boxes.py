#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Publishes, on /loose_boxes, the boxes that others would give the links of robot_description.

A loose box is made of the eight corners of the box of the resting link, turned with the link: what
is drawn beside the exact boxes for comparison. Prints the volumes of both.
"""
import itertools
import json
import subprocess
from xml.etree import ElementTree

import rospy
import tf2_ros
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBoxArray
from visualization_msgs.msg import Marker, MarkerArray

EDGES = [(a, b) for a, b in itertools.combinations(range(8), 2) if bin(a ^ b).count('1') == 1]


def resting_boxes(description):
    """Minimum and maximum of each link in its own frame, from the link alone as a robot."""
    boxes = {}
    for link in ElementTree.fromstring(description).findall('link'):
        robot = ElementTree.Element('robot', name='one_link')
        robot.append(link)
        out = subprocess.run(['rosrun', 'link_bounds', 'urdf_bounds', '-', '--format', 'json'],
                             input=ElementTree.tostring(robot), stdout=subprocess.PIPE, check=True)
        boxes.update(json.loads(out.stdout)['boxes'])
    return boxes


def turned(q, v):
    """A vector under a quaternion: v + 2 w (u x v) + 2 u x (u x v)."""
    u = (q.x, q.y, q.z)
    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    t = [2 * c for c in cross(u, v)]
    return [a + q.w * b + c for a, b, c in zip(v, t, cross(u, t))]


def loose_box(box, transform):
    ends = [box['min'], box['max']]
    offset = transform.translation
    corners = [turned(transform.rotation, [ends[i][0], ends[j][1], ends[k][2]])
               for i, j, k in itertools.product((0, 1), repeat=3)]
    shifted = [(c[0] + offset.x, c[1] + offset.y, c[2] + offset.z) for c in corners]
    return [[f(values) for values in zip(*shifted)] for f in (min, max)]


def volume(low, high):
    return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])


def marker_of(name, low, high, header):
    marker = Marker(header=header, ns=name, type=Marker.LINE_LIST, frame_locked=True)
    marker.pose.orientation.w = 1
    marker.scale.x = 0.003
    marker.color.r, marker.color.a = 0.9, 1
    ends = [low, high]
    corners = [Point(ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2][2]) for i in range(8)]
    for a, b in EDGES:
        marker.points += [corners[a], corners[b]]
    return marker


def main():
    rospy.init_node('loose_boxes')
    resting = resting_boxes(rospy.get_param('robot_description'))
    buffer = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(buffer)
    publisher = rospy.Publisher('loose_boxes', MarkerArray, queue_size=1, latch=True)

    def publish(exact):
        array, sums = MarkerArray(), [0, 0]
        for box in exact.boxes:
            transform = buffer.lookup_transform(exact.header.frame_id, box.name, rospy.Time(),
                                                rospy.Duration(5))
            low, high = loose_box(resting[box.name], transform.transform)
            array.markers.append(marker_of(box.name, low, high, exact.header))
            sums[0] += volume(*([p.x, p.y, p.z] for p in (box.min, box.max)))
            sums[1] += volume(low, high)
        publisher.publish(array)
        rospy.loginfo_once('volumes: exact %.5f, loose %.5f cubic metres, ratio %.2f', *sums,
                           sums[1] / sums[0])

    rospy.Subscriber('link_bounds_publisher/boxes', AxisAlignedBoxArray, publish)
    rospy.spin()
    del listener


if __name__ == '__main__':
    main()
