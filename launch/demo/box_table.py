#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the boxes of a link_bounds_publisher as a live table, in metres.

Parameter: ~topic (default link_bounds_publisher/boxes). Redraws in place on a terminal; else one
table after the other.
"""

import os
import shutil
import sys
import threading

import rospy
from link_bounds.msg import AxisAlignedBoxArray

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments  # noqa: E402

TERMINAL_PERIOD = 0.5  # s of wall time, so that the table is updated while /clock stands still
PLAIN_PERIOD = 2.0
HOME, CLEAR_LINE, CLEAR_BELOW, CLEAR_ALL = '\033[H', '\033[K', '\033[J', '\033[2J'


class Newest:
    """Keeps the last message for the thread that draws."""

    def __init__(self):
        self.boxes = None

    def take(self, boxes):
        self.boxes = boxes


def table(message, topic):
    """The lines of the table."""
    if message is None:
        return [f'waiting for {topic}']
    width = max([len(box.name) for box in message.boxes] + [len('link')])
    titles = ''.join(f'{title:^27}' for title in ('min x y z', 'max x y z', 'size x y z'))
    lines = [f'{len(message.boxes)} boxes in frame {printable(message.header.frame_id)} '
             f'at {message.header.stamp.to_sec():.3f} s, metres',
             f'{"link":{width}}{titles}'.rstrip()]
    lines += [row(box, width) for box in message.boxes]
    if message.incomplete:
        lines.append('incomplete: ' + ', '.join(map(printable, message.incomplete)))
    return lines


def printable(text):
    """One line: control characters, which could move the cursor, become spaces."""
    return ''.join(c if c.isprintable() else ' ' for c in text)


def row(box, width):
    low, high = xyz(box.min), xyz(box.max)
    size = [b - a for a, b in zip(low, high)]
    return f'{printable(box.name):{width}}' + ''.join(
        '   ' + ''.join(f'{round(value, 3) + 0:8.3f}' for value in triple)  # + 0: no minus zero
        for triple in (low, high, size))


def xyz(point):
    return point.x, point.y, point.z


def draw_in_place(lines):
    """Overwrites the last drawing; cuts what does not fit the terminal."""
    columns, rows = shutil.get_terminal_size()
    if len(lines) > rows - 1:
        lines = lines[:rows - 2] + [f'and {len(lines) - rows + 2} more lines']
    drawing = ''.join(line[:columns] + CLEAR_LINE + '\n' for line in lines)
    print(HOME + drawing + CLEAR_BELOW, end='', flush=True)


def main():
    check_arguments(__doc__)
    rospy.init_node('box_table', anonymous=True)
    topic = rospy.resolve_name(rospy.get_param('~topic', 'link_bounds_publisher/boxes'))
    newest, ended = Newest(), threading.Event()
    rospy.on_shutdown(ended.set)
    rospy.Subscriber(topic, AxisAlignedBoxArray, newest.take, queue_size=1, tcp_nodelay=True)
    in_place = sys.stdout.isatty()
    print(CLEAR_ALL if in_place else '', end='', flush=True)
    while not ended.wait(TERMINAL_PERIOD if in_place else PLAIN_PERIOD):
        lines = table(newest.boxes, topic)
        if in_place:
            draw_in_place(lines)
        else:
            print('\n'.join(lines) + '\n', flush=True)


if __name__ == '__main__':
    main()
