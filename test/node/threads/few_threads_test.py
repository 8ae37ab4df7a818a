#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A thread that cannot be started, as under a pids limit, ends the start with a clear reason."""
import os
import sys
import unittest

import rospy
from bounds_testing import Recorder, wait_for
from node_testing import ARMS, SANITIZED, NodeProcess
from own_master import OwnMasterTest

FEW_THREADS = sys.argv.pop(1)  # the library to preload
MAX_THREADS = 50  # a node needs fewer
OURS = ("loader", "master watch")


class FewThreads(OwnMasterTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rospy.set_param("/robot_description", ARMS)

    def reason(self, threads):
        """Why a node does not start with so many threads; None if it does."""
        environment = dict(os.environ, LD_PRELOAD=FEW_THREADS, FEW_THREADS=str(threads))
        with NodeProcess("with_%d_threads" % threads, environment=environment) as node:
            boxes = Recorder(node.name + "/boxes")
            self.addCleanup(boxes.subscriber.unregister)
            try:
                wait_for(lambda: boxes.messages or not node.is_running, "boxes or an end")
            except AssertionError as error:
                raise AssertionError("%s: %s" % (error, node.output)) from error
            if node.is_running:
                return None
            self.assertEqual(node.wait(), 1, node.output)
            lines = [line for line in node.output.splitlines() if "FATAL" in line]
            self.assertEqual(len(lines), 1, node.output)
            return lines[0]

    def test_each_thread_of_the_start(self):
        if SANITIZED:
            print("skipped: a sanitizer has to be loaded first")
            return
        reasons = []
        for threads in range(MAX_THREADS):
            with self.subTest(threads=threads):
                reasons.append(self.reason(threads))
            if reasons and reasons[-1] is None:
                break
        self.assertIsNone(reasons[-1], "the node starts with enough threads")
        for name in OURS:
            self.assertTrue(any("cannot start the %s thread" % name in reason
                                for reason in reasons[:-1]), reasons)


if __name__ == "__main__":
    unittest.main()
