#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the boxes of a link_bounds_publisher as a live table, in metres.

Parameter: ~topic (default link_bounds_publisher/boxes). Redraws in place on a terminal; else one
table after the other. A row with an asterisk is incomplete. The first line says if there is no
publisher, and if no message has come for more than a second of wall time, as while nothing changes.
"""

import os
import shutil
import sys
import textwrap
import threading
import time

import rospy
from link_bounds.msg import AxisAlignedBoxArray

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments, has_publisher, printable, run  # noqa: E402

TERMINAL_PERIOD = 0.5  # s of wall time, so that the table is updated while /clock stands still
PLAIN_PERIOD = 2.0
QUIET = 1.0  # s of wall time; a longer silence is told
GAP, MARK = '   ', ' * '  # after the name of a link; the mark if it is incomplete
HOME, CLEAR_LINE, CLEAR_BELOW, CLEAR_ALL = '\033[H', '\033[K', '\033[J', '\033[2J'


class Newest:
    """Keeps the last message for the thread that draws."""

    def __init__(self):
        self.boxes, self.time = None, time.monotonic()

    def take(self, boxes):
        self.boxes, self.time = boxes, time.monotonic()

    def warnings(self, has_publisher):
        """To be read before the table, because the end of a line may be cut."""
        silence = time.monotonic() - self.time
        return (('' if has_publisher else 'no publisher, ') +
                (f'no message for {int(silence)} s, ' if silence > QUIET else ''))


def table(message, topic, warnings, columns):
    """The lines of the table. What is incomplete comes first, because the last lines may be cut."""
    if message is None:
        return [f'{warnings}waiting for {topic}']
    names = [printable(name) for name in message.incomplete]
    count = f'{len(message.boxes)} boxes' + (f', {len(names)} incomplete,' if names else '')
    width = max([len(box.name) for box in message.boxes] + [len('link')])
    titles = ''.join(f'{title:^27}' for title in ('min x y z', 'max x y z', 'size x y z'))
    lines = [f'{warnings}{count} in frame {printable(message.header.frame_id)} '
             f'at {message.header.stamp.to_sec():.3f} s, metres']
    if names:
        lines += textwrap.wrap('incomplete: ' + ', '.join(names), columns, break_on_hyphens=False)
    lines.append(f'{"link":{width}}{titles}'.rstrip())
    return lines + [row(box, width, MARK if box.name in message.incomplete else GAP)
                    for box in message.boxes]


def row(box, width, mark):
    low, high = xyz(box.min), xyz(box.max)
    size = [b - a for a, b in zip(low, high)]
    return f'{printable(box.name):{width}}' + mark + GAP.join(
        ''.join(f'{round(value, 3) + 0:8.3f}' for value in triple)  # + 0: no minus zero
        for triple in (low, high, size))


def xyz(point):
    return point.x, point.y, point.z


def draw_in_place(lines):
    """Overwrites the last drawing; cuts what does not fit the terminal."""
    columns, rows = shutil.get_terminal_size()
    if len(lines) > rows - 1:
        shown = max(rows - 2, 1)
        lines = [*lines[:shown], f'and {len(lines) - shown} more lines'][:max(rows - 1, 1)]
    drawing = ''.join(line[:columns] + CLEAR_LINE + '\n' for line in lines)
    print(HOME + drawing + CLEAR_BELOW, end='', flush=True)


def main():
    check_arguments(__doc__)
    rospy.init_node('box_table', anonymous=True)
    topic = rospy.resolve_name(rospy.get_param('~topic', 'link_bounds_publisher/boxes'))
    newest, ended = Newest(), threading.Event()
    rospy.on_shutdown(ended.set)
    subscriber = rospy.Subscriber(topic, AxisAlignedBoxArray, newest.take, queue_size=1,
                                  tcp_nodelay=True)
    in_place = sys.stdout.isatty()
    print(CLEAR_ALL if in_place else '', end='', flush=True)
    while not ended.wait(TERMINAL_PERIOD if in_place else PLAIN_PERIOD):
        columns = shutil.get_terminal_size().columns if in_place else sys.maxsize
        lines = table(newest.boxes, topic, newest.warnings(has_publisher(subscriber)), columns)
        if in_place:
            draw_in_place(lines)
        else:
            print('\n'.join(lines) + '\n', flush=True)


if __name__ == '__main__':
    run(main)
