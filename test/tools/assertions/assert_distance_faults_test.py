#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""assert_distance fails where it must: exit status, a report that rostest understands, the last
distance."""
import rospy
import rostest
from assertion_testing import EXPIRES, FaultsTest, Talker
from link_bounds.msg import BoxOverlap, Distance, DistanceArray
from std_msgs.msg import Header

FRAME = 'cell <1> & "2"'


def pair(first, second, distance, distance_max):
    return Distance(first=first, second=second, distance=distance, distance_max=distance_max,
                    level=Distance.MESH)


class Node:
    """~distances of a node, and nothing else of it."""

    def __init__(self, space):
        self.topic = space + "/distances"
        self.distances = Talker(self.topic, DistanceArray)
        self._count = 0

    def send(self, complete, *pairs, incomplete=(), not_compared=(), limit=0.1):
        self._count += 1
        header = Header(frame_id=FRAME, stamp=rospy.Time(self._count))
        left_out = [BoxOverlap(first=first, second=second) for first, second in not_compared]
        self.distances.send(DistanceArray(
            header=header, distances=list(pairs), incomplete=list(incomplete), limit=limit,
            complete=complete, not_compared=left_out))


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
                       ['nothing was checked: no pair of "arm" and "base" was compared',
                        "ignore_pairs are never compared", "no such pair"]),
    "unknown": ({"first": "finger", "at_least": 0.01},
                ['"finger" is not in complete', "Complete: arm, base, cup/0, "]),
    "incomplete": ({"first": "lamp", "at_least": 0.01, "topic": "/half/distances"},
                   ['"lamp" is named in incomplete']),
    "incomplete_partner": ({"first": "arm", "at_least": 0.01, "topic": "/half/distances"},
                           ['"lamp" is named in incomplete']),
    "nothing_compared": ({"at_least": 0.01, "topic": "/alone/distances"},
                         ["nothing was checked: no pair of any and any", "compared: no pair."]),
    "no_topic": ({"at_least": 0.01, "topic": "/nobody/distances"}, ["no message came"])}
INVALID = {  # the other ones are in distance_watch_test.py
    "no_check": (ARM_AND_CUP, "~at_least or ~at_most is required"),
    "misspelt": ({"at_least": 0.01, "atmost": 1}, "~atmost is unknown"),
    "beyond_the_limit": ({"at_least": 0.11}, "~at_least is 0.11 m, but /link_bounds_publisher/"
                         "distances has the limit 0.1 m")}


class AssertDistanceFaults(FaultsTest):
    PROGRAM = "assert_distance"
    passing, failing, invalid = PASSING, FAILING, INVALID

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.node = Node("/link_bounds_publisher")
        cls.node.send(NAMES, ARM_CUP, not_compared=[("arm", "base")])
        cls.half = Node("/half")
        cls.half.send(["arm", "cup/0"], incomplete=["lamp"])
        cls.alone = Node("/alone")
        cls.alone.send([], not_compared=[("arm", "base")])

    def test_what_changes_breaks_the_hold(self):
        near = self.start_held("nearing")
        near.node.send(NAMES, pair("table", "arm", 0.01, 0.01))
        gone = self.start_held("going")
        gone.node.send(["arm", "lamp"])
        left_out = self.start_held("left_out")
        left_out.node.send(NAMES, not_compared=[("arm", "table")])
        limited = self.start_held("limited")
        limited.node.send(NAMES, limit=0.02)
        ending = self.start_held("ending")
        ending.node.distances.end()
        self.check_failure(near, "at most for", "0.01 to 0.01 m apart")
        self.check_failure(gone, "at most for", '"table" is not in complete')
        self.check_failure(left_out, "at most for", "nothing was checked")
        self.check_failure(limited, "has the limit 0.02 m")
        self.check_failure(ending, "at most for", "nobody publishes this topic any more")

    def test_silence_breaks_the_hold(self):
        self.silence()
        self.check_failure(self.start_held("silent"), "at most for",
                           "silence is no success (max_age 1 s)", "0.05 to 0.05 m apart")

    def start_held(self, name):
        """Waits for the end of its hold, and listens to a node of its own."""
        node = Node("/" + name)
        node.send(NAMES, pair("arm", "table", 0.05, 0.05))
        run = self.start(name, {"topic": node.topic, "first": "arm", "second": "table",
                                "at_least": 0.03, "hold": EXPIRES / 2})
        run.node = node
        node.distances.wait_for_listener()
        return run


if __name__ == "__main__":
    rospy.init_node("assert_distance_faults_test")
    rostest.rosrun("link_bounds", "assert_distance_faults", AssertDistanceFaults)
