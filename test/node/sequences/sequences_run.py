# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does steps with a node that is started for them; looks for fewer steps that still fail."""
import os
import re

import rospy
from node_testing import Diagnostics, NodeProcess
from rosgraph_msgs.msg import Clock
from sequences_driver import FENCE_MESH, Driver
from sequences_model import Meshes, Model, description
from sequences_oracle import Oracle
from sequences_steps import START, Steps
from sequences_tf import to_time
from sequences_text import describe

NODE = "link_bounds_publisher"
FENCE_POINTS = [[0, 0, 0], [0.01, 0, 0], [0, 0.01, 0.01]]
SHOWN = 8  # last steps that a failure prints


class Failure(Exception):
    """A fault, and the steps that led to it."""

    def __init__(self, what, steps):
        super().__init__(what)
        self.what, self.steps = what, steps

    def kind(self):
        return re.sub(r"[^A-Za-z ]+.*", "", self.what)[:60]

    def __str__(self):
        first = max(len(self.steps) - SHOWN, 0)
        lines = ["step %d: %s" % (i + 1, describe(*step))
                 for i, step in enumerate(self.steps) if i >= first]
        return "\n".join(["step %d: %s" % (len(self.steps), self.what)] + lines)


def started_on_one_processor():
    """A node that reads one small mesh after the other, so that the answer to the last one tells that
    all were answered."""
    usable = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(usable)})
    try:
        return NodeProcess(NODE)
    finally:
        os.sched_setaffinity(0, usable)


class Runner:
    def __init__(self, folder):
        self._folder = folder
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10, latch=True)

    def steps(self, seed):
        return Steps(seed, self._folder)

    def _publish_time(self, now):
        self._clock.publish(Clock(to_time(now)))

    def run(self, seed, steps):
        """Does steps with the robot of a seed; returns their number. Raises Failure."""
        begin = self.steps(seed)
        meshes = Meshes(self._folder)
        for name, points in dict(begin.files, **{FENCE_MESH: FENCE_POINTS}).items():
            meshes.write(name, points)
        self._publish_time(START)
        rospy.set_param("/robot_description", description(begin.links, self._folder))
        diagnostics = Diagnostics("/" + NODE)
        node = started_on_one_processor()
        try:
            diagnostics.wait_for_new(lambda stamp, _: stamp == to_time(START), "time")
            oracle = Oracle(Model(begin.links, {}, meshes), START)
            return self._drive(Driver("/" + NODE, oracle, meshes, diagnostics, self._publish_time),
                               steps)
        finally:
            node.end()

    @staticmethod
    def _drive(driver, steps):
        done = []
        try:
            driver.connect()
            for step in steps:
                done.append(step)
                driver.do(*step)
        except (AssertionError, rospy.ServiceException, rospy.ROSException) as fault:
            raise Failure(str(fault), done) from fault
        finally:
            driver.close()
        return len(done)

    def shortened(self, seed, failure):
        """A failure of the same kind after fewer steps: leaves out what does not prevent it."""
        size = len(failure.steps) // 2
        while size > 0:
            place = 0
            while place < len(failure.steps):
                fewer = failure.steps[:place] + failure.steps[place + size:]
                found = self._failure(seed, fewer)
                if found and found.kind() == failure.kind():
                    failure = found
                else:
                    place += size
            size //= 2
        return failure

    def _failure(self, seed, steps):
        try:
            self.run(seed, steps)
        except Failure as failure:
            return failure
        return None
