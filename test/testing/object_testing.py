# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Markers as a publisher of objects sends them, and the boxes that they must get."""
import math

import rospy
from bounds_testing import Pose, box_of, corners_of, difference, wait_for
from geometry_msgs.msg import Point
from visualization_msgs.msg import Marker, MarkerArray

TOLERANCE = 1e-9  # m; more than the outward rounding, far less than any real fault


def marker(name, kind=Marker.CUBE, scale=(1, 1, 1), pose=Pose(), frame="base", points=(),
           stamp=rospy.Time(), **fields):
    """An ADD of the object NS/ID."""
    ns, _, number = name.rpartition("/")
    result = Marker(ns=ns, id=int(number), type=kind, action=Marker.ADD, **fields)
    result.header.frame_id = frame
    result.header.stamp = stamp
    p, q = result.pose.position, result.pose.orientation
    p.x, p.y, p.z = pose.xyz
    q.x, q.y, q.z, q.w = pose.xyzw
    result.scale.x, result.scale.y, result.scale.z = scale
    result.points = [Point(*xyz) for xyz in points]
    result.color.a = 1
    return result


def deletion(name):
    result = marker(name)
    result.action = Marker.DELETE
    return result


def ellipsoid_bounds(pose, size):
    """The six coordinates around an ellipsoid of these diameters at a pose."""
    axes = [[c - o for c, o in zip(pose.moved(axis), pose.xyz)]
            for axis in ((size[0], 0, 0), (0, size[1], 0), (0, 0, size[2]))]
    radius = [math.sqrt(sum(axis[k] ** 2 for axis in axes)) / 2 for k in range(3)]
    return ([o - r for o, r in zip(pose.xyz, radius)] + [o + r for o, r in zip(pose.xyz, radius)])


def shows_box(message, name, bounds):
    """True if the box is there, exact and complete."""
    box = box_of(message, name)
    return (box is not None and name not in message.incomplete and
            difference(corners_of(box), bounds) < TOLERANCE)


class ObjectSender:
    """A publisher of objects, which waits for the node before it sends."""

    def __init__(self, node):
        self._array = rospy.Publisher(node + "/objects", MarkerArray, queue_size=1000)
        self._single = rospy.Publisher(node + "/object", Marker, queue_size=1000)
        for publisher in (self._array, self._single):
            wait_for(lambda p=publisher: p.get_num_connections() > 0, "the node takes objects")

    def send(self, *markers):
        self._array.publish(MarkerArray(list(markers)))

    def send_alone(self, message):
        self._single.publish(message)

    def clear(self):
        self.send(Marker(action=Marker.DELETEALL))
