#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""One core shared with a busy program: who listens to optional topics makes no boxes late."""
import contextlib
import os
import statistics
import subprocess
import sys
import unittest

from bounds_testing import wait_for
from load_testing import OTHER, LoadTest, touching_cubes
from node_testing import NODE
from patience import PATIENCE

PARAMETERS = {"swept_span": 1.0, "distance_limit": 1.0}
OBJECTS = touching_cubes(100)
HZ, SECONDS, ROUNDS = 200, 2, 3
ATTEMPTS = 3  # what a busy machine does to one of the nodes alone, it does not do thrice
RATIO = 2  # of the p99 of both nodes
BESIDE = 3 * PATIENCE  # ms, a turn of the kernel's scheduler


class Priority(LoadTest):
    """Two nodes share one core with the busy program, and get the same tf at the same time."""

    LINKS = 50

    def setUp(self):
        self.start_node(**PARAMETERS)
        self.add(OBJECTS)
        other, _ = self.start_other(OBJECTS, **PARAMETERS)
        busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
        self.addCleanup(busy.wait)
        self.addCleanup(busy.kill)
        core = min(os.sched_getaffinity(0))
        for pid in (self.node.pid, other.pid, busy.pid):
            for thread in os.listdir("/proc/%d/task" % pid):
                with contextlib.suppress(ProcessLookupError):  # the thread has ended
                    os.sched_setaffinity(int(thread), {core})

    def check(self, topic):
        listener = self.listen(topic)
        wait_for(lambda: listener.count, topic)
        attempts = []
        while len(attempts) < ATTEMPTS:
            heard, alone = self.medians()
            attempts.append((heard, alone))
            print("p99 of ~boxes %.1f ms with a listener of ~%s, %.1f ms without" % (
                heard, topic, alone), flush=True)
            if heard < RATIO * alone + BESIDE:
                return
        self.fail("late in each attempt: %s" % attempts)

    def medians(self):
        """The p99 of both nodes [ms]."""
        rounds = [self.end_drive(self.start_drive(HZ, SECONDS, (NODE, OTHER)))
                  for _ in range(ROUNDS)]
        return [statistics.median(result[node]["p99_ms"] for result in rounds)
                for node in range(2)]

    def test_threads_that_compute_long_interrupt_nobody(self):
        """SCHED_BATCH, beside the niceness."""
        policies = {os.sched_getscheduler(thread) for thread in map(
            int, os.listdir("/proc/%d/task" % self.node.pid))
            if os.getpriority(os.PRIO_PROCESS, thread) > 0}
        self.assertEqual(policies, {os.SCHED_BATCH})

    def test_with_a_listener_of_swept(self):
        self.check("swept")

    def test_with_a_listener_of_distances(self):
        self.check("distances")


if __name__ == "__main__":
    unittest.main()
