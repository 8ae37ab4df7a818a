#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the frames of the animated picture: picture_arm.py FOLDER

Each frame shows the arm in rviz with the node's markers and, beside it, the node's boxes as
numbers, all of one stamp. The first frame follows the last one without a jump.
"""
import math
import sys

from PIL import Image, ImageDraw
from rviz_stage import FAINT, INK, NOISE, PAPER, Stage, changed_pixels, font, rgb

FRAMES = 84
# Joint: middle and amplitude in rad or m, cycles in the complete picture, phase in cycles.
MOTION = {'shoulder_pan': (-0.5, 0.8, 1, 0.0),
          'shoulder_lift': (0.15, 0.4, 1, 0.25),
          'elbow_bend': (1.5, 0.35, 1, 0.3),
          'forearm_roll': (0.4, 1.2, 1, 0.3),
          'wrist_bend': (0.2, 0.7, 1, 0.7),
          'wrist_roll': (0.0, 1.4, 1, 0.1),
          'finger_left_slide': (0.03, 0.025, 2, 0.0)}
MARKED, MARK = 'forearm', (0.55, 0.15, 0.75)  # the link whose colour joins picture and table
TABLE_WIDTH = 372
COLUMNS = ('<12', '>6', '>6', '>7', '>6', '>7', '>6')


def positions(frame):
    return {joint: middle + amplitude * math.sin(2 * math.pi * (cycles * frame / FRAMES + phase))
            for joint, (middle, amplitude, cycles, phase) in MOTION.items()}


def line(cells):
    return ''.join(f'{cell:{layout}}' for cell, layout in zip(cells, COLUMNS))


def row(box):
    ends = (box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z)
    return line([box.name] + [f'{round(end, 2) + 0:.2f}' for end in ends])  # + 0: no minus zero


def table(boxes, height):
    """The numbers of a message as a picture."""
    picture = Image.new('RGB', (TABLE_WIDTH, height), PAPER)
    pen = ImageDraw.Draw(picture)
    y = (height - 22 * (len(boxes.boxes) + 3)) // 2
    pen.text((0, y), '~boxes', INK, font(15, '-Bold'))
    pen.text((70, y + 3), f'at each tf update; metres, frame {boxes.header.frame_id}', FAINT,
             font(11))
    pen.text((0, y + 34), line([''] + [axis + end for axis in 'xyz' for end in (' min', ' max')]),
             FAINT, font(12))
    for number, box in enumerate(boxes.boxes):
        is_marked = box.name == MARKED
        pen.text((0, y + 56 + 22 * number), row(box), rgb(MARK) if is_marked else INK,
                 font(12, '-Bold' if is_marked else ''))
    return picture


def mark(marker):
    """Changes the colour of a marker of the marked link."""
    if marker.ns == MARKED:
        marker.color.r, marker.color.g, marker.color.b = MARK
    return marker


def main():
    folder = sys.argv[1]
    stage = Stage('picture_arm')
    stage.warm_up(positions(-1))
    scene = first = None
    for frame in range(FRAMES + 1):  # one more, which must equal the first
        boxes, markers = stage.pose(positions(frame))
        stage.draw([mark(marker) for marker in markers.markers])
        scene = stage.picture()
        first = first or scene
        if frame < FRAMES:
            page = Image.new('RGB', (scene.width + TABLE_WIDTH, scene.height), PAPER)
            page.paste(scene)
            page.paste(table(boxes, scene.height), (scene.width, 0))
            page.save(f'{folder}/{frame:03}.png')
    if changed_pixels(first, scene) > NOISE:
        raise SystemExit('the frame after the last one is not the first one: rviz was too slow')


if __name__ == '__main__':
    main()
