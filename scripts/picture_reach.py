#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the boxes that two links and the whole arm never leave: picture_reach.py MARKERS.yaml
PICTURE.png

The markers are those of urdf_bounds --reach --format markers.
"""
import sys

import genpy
import yaml
from PIL import ImageDraw
from rviz_stage import Stage, font, rgb
from visualization_msgs.msg import MarkerArray

POSE = {'shoulder_pan': -0.6, 'shoulder_lift': 0.5, 'elbow_bend': 0.9, 'forearm_roll': 0.0,
        'wrist_bend': 0.5, 'wrist_roll': 0.4, 'finger_left_slide': 0.03}  # in rad and m
# Namespace of a marker: what its box is of, colour.
DRAWN = {'upper_arm': ('upper arm', (0.55, 0.15, 0.75)), 'forearm': ('forearm', (0.05, 0.45, 0.75)),
         'robot': ('whole arm', (0.85, 0.35, 0.0))}
WIDTH = 0.012  # m, of an edge


def main():
    stage = Stage('picture_reach')
    reach = MarkerArray()
    with open(sys.argv[1], encoding='utf-8') as file:
        genpy.message.fill_message_args(reach, [yaml.safe_load(file)])
    markers = [marker for marker in reach.markers if marker.ns in DRAWN]
    for marker in markers:
        marker.scale.x = WIDTH
        marker.color.r, marker.color.g, marker.color.b = DRAWN[marker.ns][1]
        marker.color.a = 1
    stage.warm_up(POSE)
    stage.draw(markers)
    picture = stage.picture()
    pen = ImageDraw.Draw(picture)
    pen.text((16, 14), 'never left by', 'black', font(18))
    for number, (label, colour) in enumerate(DRAWN.values(), 1):
        y = 14 + 28 * number
        pen.rectangle((16, y + 3, 34, y + 19), rgb(colour))
        pen.text((44, y), label, rgb(colour), font(18, '-Bold'))
    picture.save(sys.argv[2])


if __name__ == '__main__':
    main()
