#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""assert_box and assert_distance beside a real node that is stopped, stands still, whose clock
stands, or that compares nothing."""
import signal

import rosgraph
import rospy
import rostest
from assertion_testing import AssertionTest
from bounds_testing import (DEADLINE, Recorder, TfSender, box_link, names_of, robot, transform,
                            wait_for)
from node_testing import NODE, Diagnostics, NodeProcess, Repeater, SimulatedClock
from patience import PATIENCE

HOLD = 6.0  # s; longer than a status counts
STOPPED_HOLD = 14.0 * PATIENCE  # s; the second program may start so much later, but for 4 s
RATE = 50  # Hz, of tf
FENCE, INSIDE = 1.05, 0.5  # m; the arm is at 0
DESCRIPTION = robot([box_link(name, (1, 1, 1)) for name in ("arm", "base", "fence")],
                    [("base", "arm"), ("base", "fence")])
BOX = {"name": "arm", "check": "inside", "min": [-0.6, -1, -1], "max": [0.6, 1, 1]}
DISTANCE = {"first": "arm", "second": "fence", "at_least": 0.01}


class Silence(AssertionTest):
    def setUp(self):
        self.silence()  # the node has statuses of its own
        self.tf, self.fixed = TfSender(), TfSender(is_static=True)
        self.addCleanup(self.tf.end)
        self.addCleanup(self.fixed.end)
        self.statuses_of_node = Diagnostics()
        self.arm = 0.0

    def start_node(self, description=DESCRIPTION, **parameters):
        rospy.set_param("/robot_description", description)
        self.node = NodeProcess(NODE[1:], fixed_frame="base", **parameters)
        self.addCleanup(self.node.end)

    def start_both(self, name, hold, deadline):
        """Returns when both hold, and have heard of the node's life."""
        runs = []
        for self.PROGRAM, topic, parameters in (("assert_box", "/boxes", BOX),
                                                ("assert_distance", "/distances", DISTANCE)):
            runs.append(self.start("%s_%s" % (self.PROGRAM, name),
                                   dict(parameters, hold=hold, deadline=deadline)))
            wait_for(lambda: "/" + runs[-1].name in self.listeners(NODE + topic), "it listens")
        for _ in range(2):
            self.statuses_of_node.wait_for_new(lambda *_: True, "a status")
        return runs

    @staticmethod
    def listeners(topic):
        _, subscribers, _ = rosgraph.Master("/test").getSystemState()
        return set(dict(subscribers).get(topic, ()))

    def stand(self):
        self.fixed.send(transform("base", "fence", rospy.Time(), (FENCE, 0, 0)),
                        transform("base", "arm", rospy.Time()))

    def move(self):
        self.fixed.send(transform("base", "fence", rospy.Time(), (FENCE, 0, 0)))
        sender = Repeater(RATE, lambda: self.tf.send(
            transform("base", "arm", rospy.Time.now(), (self.arm, 0, 0))))
        self.addCleanup(sender.stop)

    def wait_for_boxes(self):
        Recorder(NODE + "/boxes").wait(
            lambda m: sorted(names_of(m)) == ["arm", "base", "fence"], "all boxes")

    def check_stopped(self, name):
        self.start_node()
        self.wait_for_boxes()
        runs = self.start_both(name, STOPPED_HOLD, DEADLINE)
        self.node.interrupt(signal.SIGSTOP)
        self.arm = INSIDE
        for run in runs:
            self.check_failure(run, "at most for", "silence is no success (max_age 1 s)")

    def test_a_node_that_is_stopped_while_the_arm_moves_fails(self):
        self.move()
        self.check_stopped("moving")

    def test_a_node_that_is_stopped_while_the_arm_stands_fails(self):
        self.stand()
        self.check_stopped("standing")

    def check_held(self, name):
        for run in self.start_both(name, HOLD, HOLD + DEADLINE):
            self.check_passed(run)

    def test_a_robot_that_stands_still_passes(self):
        self.stand()
        self.start_node()
        self.wait_for_boxes()
        self.check_held("still")

    def test_a_clock_that_stands_passes(self):
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.delete_param, "/use_sim_time")
        self.stand()
        self.start_node()
        SimulatedClock(self.statuses_of_node).set(100)
        self.wait_for_boxes()
        self.check_held("clock")

    def test_where_nothing_is_compared_any_pair_fails(self):
        """Whether the bodies are near each other or not."""
        self.PROGRAM = "assert_distance"
        self.stand()
        for name, description, parameters in (
                ("rigid", DESCRIPTION.replace("floating", "fixed"), {}),
                ("ignored", DESCRIPTION, {"ignore_pairs": ["* *"]}),
                ("far_apart", DESCRIPTION, {"ignore_pairs": ["* *"], "distance_limit": 0.02}),
                ("of_no_geometry", DESCRIPTION, {"geometry": "collision"})):
            with self.subTest(name):
                self.start_node(description, **parameters)
                Recorder(NODE + "/boxes").wait(lambda _: True, "~boxes")
                run = self.start(name, {"at_least": 0.01, "deadline": DEADLINE / 2})
                self.check_failure(run, "nothing was checked: no pair of any and any",
                                   "compared: no pair.")
                self.node.end()


if __name__ == "__main__":
    rospy.init_node("silence_test")
    rostest.rosrun("link_bounds", "silence", Silence)
