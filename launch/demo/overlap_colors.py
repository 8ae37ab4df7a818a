#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the boxes of a link_bounds_publisher: red where one overlaps another, yellow where it is
incomplete, so that nothing is known of the rest, else blue. When that node has ended, nothing.

Subscribes to ~boxes and ~overlaps of link_bounds_publisher, publishes ~markers
(visualization_msgs/MarkerArray) below its own name. Parameters: ~rate (Hz, default 30), ~only_links
(default false): draws the links alone, red where one overlaps an object.
"""

import itertools
import os
import re
import sys

import rospy
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray
from visualization_msgs.msg import Marker, MarkerArray

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments, has_publisher, run, run_regularly  # noqa: E402

QUADS = ((1, 3, 7, 5), (0, 4, 6, 2), (2, 6, 7, 3), (0, 1, 5, 4), (4, 5, 7, 6), (0, 2, 3, 1))
EDGES = [(a, b) for a, b in itertools.combinations(range(8), 2) if bin(a ^ b).count('1') == 1]
COLORS = {'free': (0.1, 0.7, 1.0), 'overlapping': (1.0, 0.15, 0.1), 'incomplete': (1.0, 0.8, 0.1)}
FACE_ALPHA, EDGE_WIDTH = 0.2, 0.004  # -, m
OBJECT = re.compile(r'.*/-?\d+|/.*/.*', re.DOTALL)  # a link of such a name counts as an object


def corners(box):
    """Bit 0 of a corner's number chooses the max of x, bit 1 of y, bit 2 of z."""
    low, high = box.min, box.max
    return [Point(high.x if i & 1 else low.x, high.y if i & 2 else low.y,
                  high.z if i & 4 else low.z) for i in range(8)]


def faces(box):
    corner = corners(box)
    return [corner[i] for a, b, c, d in QUADS for i in (a, b, c, a, c, d)]


def edges(box):
    corner = corners(box)
    return [corner[i] for edge in EDGES for i in edge]


def drawing(header, state, kind, points):
    """One marker for all boxes of a state; rviz refuses an empty one, so that is deleted."""
    result = Marker(header=header, ns=state, id=kind, type=kind,
                    action=Marker.ADD if points else Marker.DELETE, points=points)
    result.pose.orientation.w = 1
    is_edges = kind == Marker.LINE_LIST
    result.scale.x = EDGE_WIDTH if is_edges else 1
    result.scale.y = result.scale.z = 0 if is_edges else 1
    result.color.r, result.color.g, result.color.b = COLORS[state]
    result.color.a = 1 if is_edges else FACE_ALPHA
    return result


def is_link(name):
    return not OBJECT.fullmatch(name)


def drawings(boxes, overlaps, only_links):
    drawn, pairs = boxes.boxes, [(pair.first, pair.second) for pair in overlaps.overlaps]
    if only_links:
        drawn = [box for box in drawn if is_link(box.name)]
        pairs = [pair for pair in pairs if is_link(pair[0]) != is_link(pair[1])]
    states = dict.fromkeys(boxes.incomplete, 'incomplete')
    states.update((name, 'overlapping') for pair in pairs for name in pair)
    result = []
    for state in COLORS:
        shown = [box for box in drawn if states.get(box.name, 'free') == state]
        for kind, points_of in ((Marker.TRIANGLE_LIST, faces), (Marker.LINE_LIST, edges)):
            points = [point for box in shown for point in points_of(box)]
            result.append(drawing(boxes.header, state, kind, points))
    return MarkerArray(result)


class OverlapColors:
    """Draws the last message of each topic."""

    def __init__(self):
        self.only_links = rospy.get_param('~only_links', False)
        self.forget()
        self.publisher = rospy.Publisher('~markers', MarkerArray, queue_size=10)
        node = 'link_bounds_publisher/'
        self.topic = rospy.Subscriber(node + 'boxes', AxisAlignedBoxArray, self.take_boxes,
                                      queue_size=1, tcp_nodelay=True)
        rospy.Subscriber(node + 'overlaps', BoxOverlapArray, self.take_overlaps, queue_size=1,
                         tcp_nodelay=True)

    def forget(self):
        self.boxes, self.overlaps = None, BoxOverlapArray()

    def take_boxes(self, message):
        self.boxes = message

    def take_overlaps(self, message):
        self.overlaps = message

    def publish(self):
        if self.boxes is None:
            return
        if has_publisher(self.topic):
            self.publisher.publish(drawings(self.boxes, self.overlaps, self.only_links))
        else:
            self.forget()
            self.publisher.publish(MarkerArray([Marker(action=Marker.DELETEALL)]))


def main():
    check_arguments(__doc__)
    rospy.init_node('overlap_colors')
    run_regularly(30, OverlapColors().publish)


if __name__ == '__main__':
    run(main)
