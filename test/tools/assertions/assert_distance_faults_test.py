#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""assert_distance fails where it must: exit status, a report that rostest understands, the last
distance."""
import signal

import rospy
import rostest
from assertion_testing import EXPIRES, AssertionTest, Talker
from bounds_testing import DEADLINE
from geometry_msgs.msg import Point
from link_bounds.msg import (AxisAlignedBox, AxisAlignedBoxArray, BoxOverlap, BoxOverlapArray,
                             Distance, DistanceArray)
from std_msgs.msg import Header
from std_srvs.srv import Trigger

LIMIT = "~distance_limit"
FRAME = 'cell <1> & "2"'


def pair(first, second, distance, distance_max):
    return Distance(first=first, second=second, distance=distance, distance_max=distance_max,
                    level=Distance.MESH)


def cubes(header, names, incomplete=()):
    """All boxes are the same cube."""
    return AxisAlignedBoxArray(header=header, incomplete=list(incomplete), boxes=[
        AxisAlignedBox(name=name, max=Point(1, 1, 1)) for name in names])


class Node:
    """The topics of a node in a namespace."""

    def __init__(self, space):
        self.topic = space + "/distances"
        self.boxes = Talker(space + "/boxes", AxisAlignedBoxArray)
        self._overlaps = Talker(space + "/overlaps", BoxOverlapArray)
        self.distances = Talker(self.topic, DistanceArray)
        self._count = 0

    def send(self, names, *pairs, incomplete=(), overlaps=()):
        self._count += 1
        header = Header(frame_id=FRAME, stamp=rospy.Time(self._count))
        self.boxes.send(cubes(header, names, incomplete))
        self._overlaps.send(BoxOverlapArray(header=header, overlaps=[
            BoxOverlap(first=first, second=second) for first, second in overlaps]))
        self.distances.send(DistanceArray(header=header, distances=list(pairs),
                                          incomplete=list(incomplete)))

    def wait_for_listener(self):
        for talker in (self.boxes, self.distances):
            talker.wait_for_listener()


ARM_CUP = pair("arm", "cup/0", 0.03, 0.0301)
NAMES = ["arm", "cup/0", "table", "lamp", "base"]
ARM_AND_CUP = {"first": "arm", "second": "cup/0"}
PASSING = {  # parameters
    "apart": dict(ARM_AND_CUP, at_least=0.03),
    "in_the_other_order": {"first": "cup/0", "second": "arm", "at_least": 0.03},
    "near": {"first": "arm", "at_most": 0.0301},
    "range": dict(ARM_AND_CUP, at_least=0.03, at_most=0.031, hold=0.5),
    "any": {"at_least": 0.02},
    "farther_than_the_limit": {"first": "table", "second": "lamp", "at_least": 0.1}}
FAILING = {  # parameters, and what the failure says
    "not_apart": (dict(ARM_AND_CUP, at_least=0.0301),
                  ["was not at least 0.0301 m within",
                   'last distance: "arm" and "cup/0" are 0.03 to 0.0301 m apart (MESH)', FRAME]),
    "not_near": (dict(ARM_AND_CUP, at_most=0.03), ["was not at most 0.03 m", "0.0301 m apart"]),
    "never_compared": ({"first": "arm", "second": "base", "at_least": 0.01},
                       ["it is never compared", "no such pair"]),
    "unknown": ({"first": "finger", "at_least": 0.01},
                ['"finger" has no box in /link_bounds_publisher/boxes. Boxes: arm, base, cup/0, ']),
    "incomplete": ({"first": "lamp", "at_least": 0.01, "topic": "/half/distances"},
                   ['"lamp" is named in incomplete']),
    "incomplete_partner": ({"first": "arm", "at_least": 0.01, "topic": "/half/distances"},
                           ['"lamp" is named in incomplete']),
    "nothing_compared": ({"first": "base", "at_least": 0.01},
                         ['no pair of "base" and any', 'compared: 2 pairs, the nearest "']),
    "no_topic": ({"at_least": 0.01, "topic": "/nobody/distances"}, ["no message came"])}
INVALID = {  # the other ones are in distance_watch_test.py
    "no_check": (ARM_AND_CUP, "~at_least or ~at_most is required"),
    "misspelt": ({"at_least": 0.01, "atmost": 1}, "~atmost is unknown"),
    "beyond_the_limit": ({"at_least": 0.11}, "~at_least is 0.11 m, but pairs farther apart than "
                         "0.1 m are not in /link_bounds_publisher/distances; raise")}


class AssertDistanceFaults(AssertionTest):
    PROGRAM = "assert_distance"

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.node = Node("/link_bounds_publisher")
        cls.node.send(NAMES, ARM_CUP, overlaps=[("table", "lamp")])
        cls.half = Node("/half")
        cls.half.send(["arm", "lamp"], incomplete=["lamp"])

    def setUp(self):
        rospy.set_param(LIMIT, 0.1)

    def test_conditions_that_are_true(self):
        self.check_all_pass(PASSING)

    def test_conditions_that_are_not_true(self):
        self.check_all_fail(FAILING)

    def test_parameters_that_mean_nothing_fail_at_once(self):
        self.check_all_fail_at_once(INVALID)

    def test_a_publisher_without_limit_fails_at_once(self):
        rospy.delete_param(LIMIT)
        run = self.start("no_limit", {"at_least": 0.01, "deadline": 1000})
        self.check_failure(run, "~distance_limit of %s is not known" % rospy.get_name(),
                           "set %s/distance_limit" % rospy.get_name())
        self.check_at_once(run.path)

    def test_a_publisher_of_boxes_has_a_default_limit(self):
        rospy.delete_param(LIMIT)
        reload_ = rospy.Service("~reload", Trigger, lambda request: None)
        self.addCleanup(reload_.shutdown)
        self.check_passed(self.start("default_limit", {"at_least": 0.03}))
        run = self.start("beyond_the_default", {"at_least": 0.1001, "deadline": 1000})
        self.check_failure(run, "farther apart than 0.1 m")

    def test_what_changes_breaks_the_hold(self):
        near = self.start_held("nearing")
        near.node.send(NAMES, pair("table", "arm", 0.01, 0.01))
        gone = self.start_held("going")
        gone.node.send(["arm"])
        ending = self.start_held("ending")
        ending.node.distances.end()
        without_boxes = self.start_held("without_boxes")
        without_boxes.node.boxes.end()
        self.check_failure(near, "at most for", "0.01 to 0.01 m apart")
        self.check_failure(gone, "at most for", '"table" has no box')
        self.check_failure(ending, "at most for", "nobody publishes this topic any more")
        self.check_failure(without_boxes, "at most for",
                           "nobody publishes /without_boxes/boxes any more")

    def test_silence_breaks_the_hold(self):
        self.silence()
        self.check_failure(self.start_held("silent"), "at most for",
                           "silence is no success (max_age 1 s)", "0.05 to 0.05 m apart")

    def test_boxes_that_connect_after_the_distances_count(self):
        header = Header(frame_id=FRAME, stamp=rospy.Time(1))
        distances = Talker("/late/distances", DistanceArray)
        distances.send(DistanceArray(header=header, distances=[ARM_CUP]))
        run = self.start("late", dict(ARM_AND_CUP, topic="/late/distances", at_least=0.03,
                                      deadline=DEADLINE))
        distances.wait_for_listener()
        Talker("/late/boxes", AxisAlignedBoxArray).send(cubes(header, NAMES))
        self.check_passed(run)

    def test_a_lower_limit_of_the_publisher_counts(self):
        run = self.start_held("limited")
        rospy.set_param(LIMIT, 0.02)
        run.node.send(NAMES)
        self.check_failure(run, "farther apart than 0.02 m")

    def start_held(self, name):
        """Waits for the end of its hold, and listens to a node of its own."""
        node = Node("/" + name)
        node.send(NAMES, pair("arm", "table", 0.05, 0.05))
        run = self.start(name, {"topic": node.topic, "first": "arm", "second": "table",
                                "at_least": 0.03, "hold": EXPIRES / 2})
        run.node = node
        node.wait_for_listener()
        return run

    def test_who_is_interrupted_fails(self):
        run = self.start_held("interrupted")
        run.process.send_signal(signal.SIGTERM)
        self.check_failure(run, "interrupted")


if __name__ == "__main__":
    rospy.init_node("assert_distance_faults_test")
    rostest.rosrun("link_bounds", "assert_distance_faults", AssertDistanceFaults)
