#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Large lists that change faster than their triangles can be prepared, as an octomap does."""
import time
import unittest

import rospy
import rostest
from bounds_testing import Recorder, robot, wait_for
from link_bounds.msg import Distance, DistanceArray
from node_testing import SANITIZED, NodeProcess, Repeater, resident_bytes
from object_testing import marker
from patience import PATIENCE
from raw_messages import as_bytes, serialized
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

LISTS = 8
SIDE = 50 if SANITIZED else 316  # cells
MIDDLE = SIDE // 2
HOLE = 6  # cells to each side
CELL = 0.01  # m
RATE = 1.25  # Hz; a list is prepared once it has not changed for half a second
ROUNDS = 40
MEBIBYTE = 1 << 20
BOUND = 160 * MEBIBYTE  # three times what is needed
PROMPT = 10.0 * PATIENCE  # s for ~reload; ten times and more what it takes


def post(number):
    """A part of the link, in the hole of a list: its convex hull touches the post."""
    x, y = 4 * number + CELL * MIDDLE, CELL * MIDDLE
    return ('<visual><origin xyz="%g %g 0"/><geometry><box size="0.02 0.02 1"/></geometry></visual>'
            % (x, y))


def plane(number, height):
    """A list of cubes with a hole, away from the others."""
    points = [(4 * number + CELL * i, CELL * j, height) for i in range(SIDE) for j in range(SIDE)
              if max(abs(i - MIDDLE), abs(j - MIDDLE)) > HOLE]
    return marker("o/%d" % number, Marker.CUBE_LIST, (CELL, CELL, CELL), points=points)


def scene(height):
    """All lists, serialized once: that takes longer than a round."""
    array = MarkerArray([plane(k, height) for k in range(LISTS)])
    return as_bytes(array, serialized(array))


class ChangingLists(unittest.TestCase):
    def test_the_newest_lists_count_and_nothing_piles_up(self):
        link = '<link name="base">%s</link>' % "".join(post(k) for k in range(LISTS))
        rospy.set_param("/robot_description", robot([link], []))
        node = NodeProcess("lists", timeout=0.0, distance_limit=0.1)
        self.addCleanup(node.end)
        scenes = [scene(height) for height in (0.11, 0.12)]
        publisher = rospy.Publisher(node.name + "/objects", MarkerArray, queue_size=1)
        distances = Recorder(node.name + "/distances", DistanceArray)
        wait_for(lambda: publisher.get_num_connections() > 0 and distances.messages, "the node")
        sent = []

        def send():
            publisher.publish(scenes[len(sent) % 2])
            sent.append(resident_bytes(node.pid))

        sender = Repeater(RATE, send)
        self.addCleanup(sender.stop)
        wait_for(lambda: len(sent) >= ROUNDS, "all rounds", 10 * ROUNDS / RATE)
        begin = time.monotonic()
        self.assertTrue(rospy.ServiceProxy(node.name + "/reload", Trigger)().success)
        took = time.monotonic() - begin
        sender.stop()
        print("MiB: %s; reload took %.2f s" % ([size // MEBIBYTE for size in sent[::4]], took))
        self.assertLess(took, PROMPT)
        if SANITIZED:
            print("skipped: memory of changing lists, a sanitizer needs more")
        else:
            self.assertLess(max(sent), BOUND)
        distances.clear()
        distances.wait(
            lambda m: len(m.distances) == LISTS and
            all(found.level == Distance.MESH for found in m.distances), "all trees", 60 * PATIENCE)


if __name__ == "__main__":
    rospy.init_node("changing_lists_test")
    rostest.rosrun("link_bounds", "changing_lists", ChangingLists)
