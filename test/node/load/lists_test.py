#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Large lists of cubes that are replaced faster than their triangles can be prepared: what is
replaced is forgotten, and ~reload does not wait for it."""
import array
import itertools
import struct
import time
import unittest

import rospy
from bounds_testing import TfSender, transform, wait_for
from load_testing import LoadTest, MemoryWatch, cube, link_names
from node_testing import NODE, Repeater
from patience import PATIENCE
from raw_messages import as_bytes, serialized
from visualization_msgs.msg import Marker, MarkerArray

LISTS, CELLS = 8, 100000
PERIOD = 0.8  # s, in which each list is new
SECONDS = 12
COLUMN = 100  # cells
SIZE = 0.05  # m
RELOAD = 5 * PATIENCE  # s; 0.01 without a listener
GROWTH = 100e6  # bytes more than with lists that rest


def cells(shift):
    """The bytes of the points of a list."""
    points = array.array("d")
    for i in range(CELLS):
        points.extend((SIZE * (i // COLUMN), SIZE * (i % COLUMN), shift))
    return struct.pack("<I", CELLS) + points.tobytes()


def message(number, points):
    """A MarkerArray of one list with these cells. It is serialized beforehand, so that sending
    takes little time of this process."""
    marker = cube(number, (0, 1, 2.0 * number), SIZE)
    marker.type, marker.ns = Marker.CUBE_LIST, "list"
    # Behind the points: colors, text, mesh_resource, all empty, and mesh_use_embedded_materials.
    tail = struct.pack("<III", 0, 0, 0) + b"\0"
    body = serialized(marker)
    assert body.endswith(struct.pack("<I", 0) + tail)
    return as_bytes(MarkerArray(), struct.pack("<I", 1) + body[:-len(tail) - 4] + points + tail)


class Lists(LoadTest):
    LINKS = 2

    def setUp(self):
        self.start_node(distance_limit=0.2)
        self.listener = self.listen("distances")
        self.tf = TfSender()
        self.tf.wait_for_listener()
        self.addCleanup(self.tf.end)
        self.publisher = rospy.Publisher(NODE + "/objects", MarkerArray, queue_size=100)
        wait_for(lambda: self.publisher.get_num_connections(), "the node takes objects")
        self.addCleanup(self.publisher.unregister)
        variants = [cells(0.001 * i) for i in range(3)]
        self.messages = [[message(number, points) for number in range(LISTS)]
                         for points in variants]

    def send_tf(self):
        self.tf.send(*(transform("base", name, rospy.Time.now(), (0, 0.9, 0))
                       for name in link_names(self.LINKS)))

    def test_what_is_replaced_is_forgotten(self):
        poses = Repeater(20, self.send_tf)
        self.addCleanup(poses.stop)
        for prepared in self.messages[0]:
            self.publisher.publish(prepared)
        wait_for(lambda: self.statuses.newest("objects") == LISTS, "all lists")
        wait_for(self.rests, "lists that rest", 120 * PATIENCE)
        rest = MemoryWatch(self.node.pid)
        rest_mb = rest.first / 1e6
        turns = itertools.cycle(itertools.chain.from_iterable(self.messages))
        lists = Repeater(LISTS / PERIOD, lambda: self.publisher.publish(next(turns)))
        self.addCleanup(lists.stop)
        time.sleep(SECONDS)  # the length of the load
        reload_seconds = self.reload_seconds()
        growth = rest.end()
        print("memory %.1f MB at rest, +%.1f MB; reload %.2f s" % (
            rest_mb, growth / 1e6, reload_seconds), flush=True)
        self.assertLess(reload_seconds, RELOAD)
        self.assertLess(growth, GROWTH)

    def rests(self):
        """Whether the node has used less than a tenth of a core for a second."""
        before, start = self.cpu(), time.monotonic()
        time.sleep(1)  # the length of the measurement
        return self.cpu() - before < 0.1 * (time.monotonic() - start)

    def cpu(self):
        return time.clock_gettime(~self.node.pid << 3 | 2)  # of another process [s]


if __name__ == "__main__":
    unittest.main()
