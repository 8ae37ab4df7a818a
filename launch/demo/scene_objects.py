#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene around the demo's arm: parcels on a round belt, jumping balls, a waving sheet, a mesh.

Publishes link_bounds_publisher/objects (visualization_msgs/MarkerArray). Parameters: ~rate (Hz,
default 30), ~mesh (URI, default none), ~mesh_scale (default 1), ~frame (default base).
"""

import math
import os
import sys

import rospy
from geometry_msgs.msg import Point
from visualization_msgs.msg import Marker, MarkerArray

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments, number_parameter, run, run_regularly  # noqa: E402

PARCELS, BALLS = 5, 3
BELT_RADIUS, BELT_HEIGHT, BELT_PERIOD = 0.65, 0.3, 24.0  # m, m, s
SHEET_CELLS, SHEET_SIDE = 14, 0.5  # m
SHEET_PLACE = (-0.4, 0.3, 0.85)


def marker(ns, number, kind, color, frame):
    result = Marker(ns=ns, id=number, type=kind, action=Marker.ADD)
    result.header.frame_id = frame
    result.pose.orientation.w = 1
    result.scale.x = result.scale.y = result.scale.z = 1
    result.color.r, result.color.g, result.color.b = color
    result.color.a = 1
    return result


def turn(message, axis, angle):
    """`axis` has length 1."""
    q = message.pose.orientation
    q.x, q.y, q.z = (math.sin(angle / 2) * a for a in axis)
    q.w = math.cos(angle / 2)


def place(message, x, y, z):
    message.pose.position = Point(x, y, z)
    return message


def parcel(number, seconds, frame):
    """Rides around the arm and turns on its way."""
    result = marker('parcels', number, Marker.CUBE, (0.85, 0.65, 0.4), frame)
    result.scale.x, result.scale.y, result.scale.z = 0.12, 0.08 + 0.02 * number, 0.1
    angle = 2 * math.pi * (seconds / BELT_PERIOD + number / PARCELS)
    turn(result, (0, 0, 1), 2.3 * angle)
    return place(result, BELT_RADIUS * math.cos(angle), BELT_RADIUS * math.sin(angle), BELT_HEIGHT)


def ball(number, seconds, frame):
    """Jumps on the floor."""
    result = marker('balls', number, Marker.SPHERE, (0.45, 0.75, 0.45), frame)
    radius = 0.05 + 0.02 * number
    result.scale.x = result.scale.y = result.scale.z = 2 * radius
    angle = 2 * math.pi * number / BALLS + 0.2 * seconds
    height = radius + 0.7 * abs(math.sin((1.1 + 0.3 * number) * seconds))
    return place(result, 0.4 * math.cos(angle), 0.4 * math.sin(angle), height)


def sheet(seconds, frame):
    """Two triangles per cell of a square that waves."""
    def vertex(i, j):
        x, y = (SHEET_SIDE * (k / SHEET_CELLS - 0.5) for k in (i, j))
        return Point(x, y, 0.06 * math.sin(9 * x + 2 * seconds) * math.cos(7 * y + seconds))

    result = marker('sheet', 0, Marker.TRIANGLE_LIST, (0.75, 0.6, 0.85), frame)
    for i in range(SHEET_CELLS):
        for j in range(SHEET_CELLS):
            a, b, c, d = (vertex(*ij) for ij in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            result.points += [a, b, c, a, c, d]
    turn(result, (1, 0, 0), 0.4 * math.sin(0.5 * seconds))
    return place(result, *SHEET_PLACE)


def mesh(uri, scale, seconds, frame):
    result = marker('mesh', 0, Marker.MESH_RESOURCE, (0.6, 0.7, 0.8), frame)
    result.mesh_resource = uri
    result.scale.x = result.scale.y = result.scale.z = scale
    turn(result, (0.6, 0, 0.8), 0.5 * seconds)
    return place(result, 0.4, -0.35, 0.8)


def scene(seconds, frame, uri, scale):
    objects = [parcel(number, seconds, frame) for number in range(PARCELS)]
    objects += [ball(number, seconds, frame) for number in range(BALLS)]
    objects.append(sheet(seconds, frame))
    if uri:
        objects.append(mesh(uri, scale, seconds, frame))
    return MarkerArray(objects)


def main():
    check_arguments(__doc__)
    rospy.init_node('scene_objects')
    publisher = rospy.Publisher('link_bounds_publisher/objects', MarkerArray, queue_size=10)
    frame = rospy.get_param('~frame', 'base')
    uri, scale = rospy.get_param('~mesh', ''), number_parameter('mesh_scale', 1)
    start = rospy.Time.now()
    run_regularly(30, lambda: publisher.publish(
        scene((rospy.Time.now() - start).to_sec(), frame, uri, scale)))


if __name__ == '__main__':
    run(main)
