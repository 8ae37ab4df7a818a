#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many pairs within distance_limit: boxes stay as fast as without them, and a message has a bound."""
import statistics
import time
import unittest

from bounds_testing import Recorder, wait_for
from link_bounds.msg import DistanceArray
from load_testing import OTHER, LoadTest, overlapping_cubes, touching_cubes
from node_testing import NODE, value_of
from patience import PATIENCE

TIME = "time per tf message, mean of the last second [ms]"
RATIO = 4
BESIDE = 0.2 * PATIENCE  # ms, for the copy of the scene that distances are computed of
MAX_PAIRS = 10000
FEW = 200


class Pairs(LoadTest):
    LINKS = 2

    def test_a_listener_of_distances_costs_no_time_of_tf(self):
        cubes = overlapping_cubes(800)
        self.start_node()
        self.add(cubes)
        _, other = self.start_other(cubes)
        listener = self.listen("distances")
        wait_for(lambda: listener.count, "distances")
        start = time.monotonic()
        heard, _ = self.end_drive(self.start_drive(100, 5, (NODE, OTHER)))
        times = [self.median_time(statuses, start) for statuses in (self.statuses, other)]
        print("time per tf message %.3f ms with distances, %.3f ms without" % tuple(times))
        self.assertEqual(heard["unanswered"], 0)
        self.assertLess(times[0], RATIO * times[1] + BESIDE)

    @staticmethod
    def median_time(statuses, start):
        """Of the means of some seconds [ms]."""
        texts = [value_of(status, TIME) for _, status, _ in statuses.since(start)]
        return statistics.median(float(text) for text in texts if text != "none")

    def distances(self, **parameters):
        """Those of one message, and what diagnostics say beside it."""
        self.start_node(**parameters)
        self.add(touching_cubes(2000, 0.001))
        recorder = Recorder(NODE + "/distances", DistanceArray)
        self.addCleanup(recorder.subscriber.unregister)
        message = recorder.wait(lambda m: m.distances, "distances")
        status = self.statuses.wait_for_new(lambda *_: True, "diagnostics")
        self.node.end()
        recorder.subscriber.unregister()  # or the next one would share the connection
        return message, " ".join("%s: %s" % (pair.key, pair.value) for pair in status.values)

    def test_a_message_has_a_bounded_number_of_pairs(self):
        message, _ = self.distances(distance_limit=0.1)
        self.assertEqual(len(message.distances), MAX_PAIRS)

    def test_the_nearest_pairs_are_sent_and_the_others_counted(self):
        everything, _ = self.distances(distance_limit=0.01, max_pairs=10 ** 6)
        lengths = sorted(pair.distance for pair in everything.distances)
        self.assertGreater(len(lengths), FEW)
        message, status = self.distances(distance_limit=0.01, max_pairs=FEW)
        self.assertEqual(len(message.distances), FEW)
        for pair in message.distances:
            self.assertLessEqual(pair.distance, lengths[FEW - 1] + 1e-4)  # distance_accuracy
        self.assertRegex(status, r"left out of ~distances: %d\b" % (len(lengths) - FEW))


if __name__ == "__main__":
    unittest.main()
