#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the boxes that the links of the arm never leave: picture_reach.py MARKERS.yaml PICTURE.png

The markers are those of urdf_bounds --reach --format markers.
"""
import sys

import genpy
import yaml
from rviz_stage import Stage
from visualization_msgs.msg import MarkerArray

POSE = {'shoulder_pan': -0.6, 'shoulder_lift': 0.5, 'elbow_bend': 0.9, 'forearm_roll': 0.0,
        'wrist_bend': 0.5, 'wrist_roll': 0.4, 'finger_left_slide': 0.03}  # in rad and m


def main():
    stage = Stage('picture_reach')
    reach = MarkerArray()
    with open(sys.argv[1], encoding='utf-8') as file:
        genpy.message.fill_message_args(reach, [yaml.safe_load(file)])
    stage.warm_up(POSE)
    stage.draw(reach.markers)
    stage.picture().save(sys.argv[2])


if __name__ == '__main__':
    main()
