#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random steps of tf, objects, time and reloads; a slow oracle computes each expected message.

LINK_BOUNDS_SEQUENCE_STEPS is the number of steps for each seed, LINK_BOUNDS_SEQUENCE_SEEDS names
the seeds: "7", or "1 2 3". A failure names seed and step, which repeat it, and the last steps.
With LINK_BOUNDS_SEQUENCE_SHORTEN=1 it looks for fewer steps that fail in the same way."""
import itertools
import os
import shutil
import sys
import tempfile
import time
import unittest

import rospy
import rostest
from sequences_run import Failure, Runner

STEPS = int(os.environ.get("LINK_BOUNDS_SEQUENCE_STEPS", 400))
SEEDS = list(map(int, os.environ.get("LINK_BOUNDS_SEQUENCE_SEEDS", "1 2 3").split()))
SHORTENS = "LINK_BOUNDS_SEQUENCE_SHORTEN" in os.environ
LIMIT = 60  # wall s for each seed of the default run; a slow machine does fewer steps
MIN_STEPS = 30  # are done in any case


class SequencesTest(unittest.TestCase):
    def test_sequences(self):
        folder = tempfile.mkdtemp(prefix="link_bounds_sequences_")
        try:
            self.runner = Runner(folder)
            failures = list(filter(None, map(self.failure_of, SEEDS)))
        finally:
            shutil.rmtree(folder)
        self.assertFalse(failures, "\n\n" + "\n\n".join(failures))

    def failure_of(self, seed):
        """The failure as text; None if there is none."""
        try:
            start = time.monotonic()
            count = self.runner.run(seed, self.steps_of(seed))
            print("seed %d: %d steps in %.1f s" % (seed, count, time.monotonic() - start))
            return None
        except Failure as failure:
            if SHORTENS:
                failure = self.runner.shortened(seed, failure)
            print("seed %d: failed at step %d" % (seed, len(failure.steps)))
            return "seed %d, %s" % (seed, failure)

    def steps_of(self, seed):
        steps = self.runner.steps(seed)
        start = time.monotonic()
        is_limited = "LINK_BOUNDS_SEQUENCE_STEPS" not in os.environ
        everything = itertools.chain(steps.begin(), iter(steps.next, None))
        for count, step in enumerate(itertools.islice(everything, STEPS)):
            if is_limited and count >= MIN_STEPS and time.monotonic() - start > LIMIT:
                return
            yield step


if __name__ == "__main__":
    rospy.init_node("sequences_test")
    rostest.rosrun("link_bounds", "sequences", SequencesTest, sys.argv)
