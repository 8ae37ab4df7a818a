#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A subscriber of large messages that stops reading costs bounded memory, gets the newest message
when it reads again, and takes nothing from others."""
import time
import unittest

from bounds_testing import wait_for
from load_testing import LoadTest, MemoryWatch, overlapping_cubes, touching_cubes
from patience import PATIENCE
from raw_subscriber import stamp_of

HZ, SECONDS = 50, 6
GROWTH = 64e6  # bytes: eight times the bound of a topic and subscriber
ENOUGH = 2  # times GROWTH that must have been sent, or nothing was shown
DEADLINE = 60 * PATIENCE  # s


class Stopped(LoadTest):
    LINKS = 2

    def check(self, topic):
        other, boxes = self.listen(topic), self.listen("boxes")
        self.drive(HZ, 2)  # buffers reach their size
        wait_for(lambda: other.newest, topic)
        stopped = self.stop_reading(topic)
        seen, boxes_seen = other.count, boxes.count
        memory = MemoryWatch(self.node.pid)
        updates, end = 0, time.monotonic() + DEADLINE
        while (other.count - seen) * len(other.newest) <= ENOUGH * GROWTH:
            self.assertLess(time.monotonic(), end, "too few messages of " + topic)
            updates += self.drive(HZ, SECONDS)["updates"]
        wait_for(lambda: boxes.count - boxes_seen >= updates, "all boxes", DEADLINE)
        newest = wait_for(lambda: stamp_of(other.newest) == stamp_of(boxes.newest) and
                          stamp_of(boxes.newest), "the newest of " + topic, DEADLINE)
        growth, sent = memory.end(), (other.count - seen) * len(other.newest)
        print("%s: memory +%.1f MB, %.1f MB sent" % (topic, growth / 1e6, sent / 1e6))
        while stamp_of(stopped.read_message()) != newest:
            pass  # fails when nothing comes any more
        self.assertLess(growth, GROWTH)

    def test_of_overlaps(self):
        self.start_node()
        self.add(overlapping_cubes(400))
        self.check("overlaps")

    def test_of_distances(self):
        self.start_node(distance_limit=0.2)
        self.add(touching_cubes(500))
        self.check("distances")


if __name__ == "__main__":
    unittest.main()
