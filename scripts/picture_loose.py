#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one pose with exact and with loose boxes, and their volumes: picture_loose.py PICTURE.png

A loose box is what other tools compute: the box around the eight corners of the link's box at rest,
which are turned with the link.
"""
import copy
import itertools
import json
import subprocess
import sys
from xml.etree import ElementTree

import rospy
import tf2_ros
from PIL import Image, ImageDraw
from rviz_stage import INK, PAPER, Stage, font, rgb

# In rad and m: most links are turned about two axes.
POSE = {'shoulder_pan': -0.75, 'shoulder_lift': 0.55, 'elbow_bend': 0.6, 'forearm_roll': 0.6,
        'wrist_bend': 0.9, 'wrist_roll': 0.5, 'finger_left_slide': 0.02}
BLUE, RED = (0.05, 0.5, 0.77), (0.85, 0.1, 0.1)
TITLE_HEIGHT = 66
CUT = (10, 60, 430, 420)  # left, top, right, bottom of what is shown


def resting_boxes(description):
    """Minimum and maximum of each link in its own frame, from a robot of that link alone."""
    boxes = {}
    for link in ElementTree.fromstring(description).findall('link'):
        robot = ElementTree.Element('robot', name='one_link')
        robot.append(link)
        out = subprocess.run(['rosrun', 'link_bounds', 'urdf_bounds', '-', '--format', 'json'],
                             input=ElementTree.tostring(robot), stdout=subprocess.PIPE, check=True)
        boxes.update(json.loads(out.stdout)['boxes'])
    return {name: (box['min'], box['max']) for name, box in boxes.items()}


def turned(q, v):
    """The vector v turned by a quaternion (u, w): v + 2 w (u x v) + 2 u x (u x v)."""
    u = (q.x, q.y, q.z)
    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    t = [2 * c for c in cross(u, v)]
    return [a + q.w * b + c for a, b, c in zip(v, t, cross(u, t))]


def loose_box(box, transform):
    offset = transform.translation
    corners = [turned(transform.rotation, corner) for corner in itertools.product(*zip(*box))]
    shifted = [(c[0] + offset.x, c[1] + offset.y, c[2] + offset.z) for c in corners]
    return tuple([f(values) for values in zip(*shifted)] for f in (min, max))


def exact_boxes(message):
    return {box.name: tuple([end.x, end.y, end.z] for end in (box.min, box.max))
            for box in message.boxes}


def loose_boxes(message, tf):
    resting = resting_boxes(rospy.get_param('robot_description'))
    return {box.name: loose_box(resting[box.name], tf.lookup_transform(
        message.header.frame_id, box.name, message.header.stamp, rospy.Duration(10)).transform)
        for box in message.boxes}


def volume(boxes):
    """The sum, in cubic metres."""
    total = 0
    for low, high in boxes.values():
        x, y, z = (b - a for a, b in zip(low, high))
        total += x * y * z
    return total


def moved(marker, box, color):
    """A copy of the marker in another colour, around another box."""
    result = copy.deepcopy(marker)
    result.color.r, result.color.g, result.color.b = color
    for axis, low, high in zip('xyz', *box):
        setattr(result.pose.position, axis, (low + high) / 2)
        if marker.points:
            for point in result.points:
                setattr(point, axis, (high - low) / 2 * (1 if getattr(point, axis) > 0 else -1))
        else:
            setattr(result.scale, axis, high - low)
    return result


def edges_beside(markers):
    """Copies of the edges under other names, to be drawn beside markers of the same links."""
    edges = [copy.deepcopy(marker) for marker in markers if marker.points]
    for marker in edges:
        marker.ns = 'beside/' + marker.ns
    return edges


def titled(scene, name, text, color, share):
    """The cut scene below its title and a bar that fills a share of its width."""
    scene = scene.crop(CUT)
    picture = Image.new('RGB', (scene.width, scene.height + TITLE_HEIGHT), PAPER)
    picture.paste(scene, (0, TITLE_HEIGHT))
    pen = ImageDraw.Draw(picture)
    pen.text((20, 12), name, rgb(color), font(20, '-Bold'))
    pen.text((95, 18), text, INK, font(13))
    pen.rectangle((20, 46, 20 + share * (scene.width - 40), 58), rgb(color))
    return picture


def main():
    stage = Stage('picture_loose')
    tf = tf2_ros.Buffer()
    listener = tf2_ros.TransformListener(tf)
    stage.warm_up(POSE)
    message, markers = stage.pose(POSE)
    exact, loose = exact_boxes(message), loose_boxes(message, tf)
    listener.unregister()
    blue = [moved(marker, exact[marker.ns], BLUE) for marker in markers.markers]
    red = [moved(marker, loose[marker.ns], RED) for marker in markers.markers]
    ratio = volume(loose) / volume(exact)
    stage.draw(blue)
    left = titled(stage.picture(), 'exact', f'{volume(exact):.3f} m³', BLUE, 1 / ratio)
    stage.draw(red + edges_beside(blue))
    right = titled(stage.picture(), 'loose', f'{volume(loose):.3f} m³, {ratio:.2f} times as much',
                   RED, 1)
    picture = Image.new('RGB', (left.width + right.width, left.height), PAPER)
    picture.paste(left)
    picture.paste(right, (left.width, 0))
    picture.save(sys.argv[1])


if __name__ == '__main__':
    main()
