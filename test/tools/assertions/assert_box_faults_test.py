#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""assert_box fails where it must: exit status, a report that rostest understands, the last box."""
import os
import signal
import subprocess

import rospy
import rostest
from assertion_testing import EXPIRES, AssertionTest, Talker
from bounds_testing import DEADLINE, Pose, executable, turn
from catkin.test_results import read_junit
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from std_msgs.msg import Header

TOPIC = "/link_bounds_publisher/boxes"  # the default of assert_box
FRAME = 'cell <1> & "2"'
INFINITE = float("inf")


def turned_box(name, xyz, xyzw):
    """The box of a turned beam."""
    corners = Pose(xyz, xyzw).box_bounds((0.4, 0.2, 0.1))
    return AxisAlignedBox(name=name, min=Point(*corners[:3]), max=Point(*corners[3:]))


PALM = turned_box("palm", (1, 0, 0.5), turn((0, 0, 1), 30))
THUMB = turned_box("thumb", (2, 0, 0.5), turn((0, 1, 0), 45))
PALM_MIN = [PALM.min.x, PALM.min.y, PALM.min.z]
PALM_MAX = [PALM.max.x, PALM.max.y, PALM.max.z]
LAST_PALM = "last box: [%.9g, %.9g, %.9g] to [%.9g, %.9g, %.9g]" % (*PALM_MIN, *PALM_MAX)
AROUND_PALM = {"name": "palm", "min": [0, -1, 0], "max": [2, 1, 1]}
EXACT_PALM = {"name": "palm", "min": PALM_MIN, "max": PALM_MAX}


class BoxTalker(Talker):
    """Boxes as a node publishes them."""

    def __init__(self, topic):
        super().__init__(topic, AxisAlignedBoxArray)

    def send(self, *boxes, incomplete=()):
        super().send(AxisAlignedBoxArray(
            header=Header(frame_id=FRAME), boxes=list(boxes), incomplete=list(incomplete)))


MISSING = {"name": "finger", "min": [0, 0, 0], "max": [1, 1, 1]}
PASSING = {  # parameters
    "equal": EXACT_PALM,
    "equal_within": dict(EXACT_PALM, min=[c + 0.009 for c in PALM_MIN], tolerance=0.01),
    "inside": dict(AROUND_PALM, check="inside"),
    "inside_half_space": dict(AROUND_PALM, check="inside", min=[-INFINITE, -INFINITE, 0],
                              max=[INFINITE, INFINITE, INFINITE]),
    "outside": dict(AROUND_PALM, name="thumb", check="outside", max=[1.8, 1, 1]),
    "held": dict(AROUND_PALM, check="inside", hold=0.5)}
FAILING = {  # parameters, and what the failure says
    "not_equal": (dict(EXACT_PALM, max=[c + 0.02 for c in PALM_MAX]),
                  [LAST_PALM, "off by 0.02 m: max x by 0.02 m, max y by", FRAME]),
    "not_inside": (dict(AROUND_PALM, check="inside", max=[2, 1, 0.5]),
                   [LAST_PALM, "off by 0.05 m: max z by 0.05 m", "not inside [0, -1, 0] to [2, 1, 0.5]"]),
    "not_outside": (dict(AROUND_PALM, check="outside"), [LAST_PALM, "off by"]),
    "missing": (MISSING, ["no such box", "not named in incomplete", "palm, thumb"]),
    "incomplete": (dict(EXACT_PALM, name="thumb", check="outside", topic="/half/boxes"),
                   ["thumb", "incomplete"]),
    "no_topic": (dict(AROUND_PALM, topic="/nobody/boxes"), ["no message came", "/nobody/boxes"])}
INVALID = {
    "no_name": ({"min": [0, 0, 0], "max": [1, 1, 1]}, "~name is required"),
    "no_min": ({"name": "palm", "max": [1, 1, 1]}, "~min is required"),
    "no_max": ({"name": "palm", "min": [1, 1, 1]}, "~max is required"),
    "two_numbers": (dict(AROUND_PALM, min=[0, 0]),
                    "~min is [0, 0], but must be a list of 3 numbers"),
    "text": (dict(AROUND_PALM, max="[1, 1, 1]"),
             '~max is "[1, 1, 1]", but must be a list of 3 numbers'),
    "min_above_max": (dict(AROUND_PALM, min=[0, 1.5, 0]), "~min must not be greater than ~max"),
    "nan": (dict(AROUND_PALM, min=[0, 0, float("nan")]), "NaN], but must hold neither NaN nor .inf"),
    "min_without_end": (dict(AROUND_PALM, min=[INFINITE, 0, 0], max=[INFINITE, 1, 1],
                             check="outside"), "but must hold neither NaN nor .inf"),
    "max_without_end": (dict(AROUND_PALM, min=[-INFINITE, 0, 0], max=[-INFINITE, 1, 1],
                             check="outside"), "but must hold neither NaN nor -.inf"),
    "no_topic_name": (dict(AROUND_PALM, topic=""), "~topic is \"\", but must not be empty"),
    "infinite": (dict(AROUND_PALM, max=[INFINITE, 1, 1]), "finite"),
    "check": (dict(AROUND_PALM, check="in"),
              '~check is "in", but must be equal, inside or outside'),
    "tolerance": (dict(AROUND_PALM, tolerance=-1e-3), "~tolerance is -0.001, but must be"),
    "deadline": (dict(AROUND_PALM, deadline=0), "~deadline is 0, but must be"),
    "hold": (dict(AROUND_PALM, hold=9.0, deadline=9.0), "~hold must be less than ~deadline"),
    "misspelt": (dict(AROUND_PALM, tolerence=0.1), "~tolerence is unknown")}


class AssertBoxFaults(AssertionTest):
    PROGRAM = "assert_box"

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.talker = BoxTalker(TOPIC)
        cls.talker.send(PALM, THUMB)
        cls.half = BoxTalker("/half/boxes")
        cls.half.send(PALM, THUMB, incomplete=["thumb"])

    def test_conditions_that_are_true(self):
        self.check_all_pass(PASSING)

    def test_conditions_that_are_not_true(self):
        self.check_all_fail(FAILING)

    def test_parameters_that_mean_nothing_fail_at_once(self):
        self.check_all_fail_at_once(INVALID)

    def test_an_unknown_argument_fails(self):
        self.check_failure(self.start("argument", AROUND_PALM, "--gtest_filter=palm"),
                           "--gtest_filter=palm", "--help")

    def test_what_goes_away_breaks_the_hold(self):
        box = self.start_held("going")
        publisher = self.start_held("ending")
        box.talker.send(THUMB, incomplete=["palm"])
        publisher.talker.send(PALM)
        publisher.talker.end()
        self.check_failure(box, "at most for", "named in incomplete", LAST_PALM)
        self.check_failure(publisher, "at most for", "nobody publishes", LAST_PALM)

    def test_silence_breaks_the_hold(self):
        self.silence()
        run = self.start_held("silent")
        self.check_failure(run, "at most for", "no status of %s in /diagnostics" % rospy.get_name(),
                           "silence is no success (max_age 1 s)", LAST_PALM)

    def start_held(self, name):
        """Waits for the end of its hold, and listens to a talker of its own."""
        topic = "/%s/boxes" % name
        talker = BoxTalker(topic)
        talker.send(PALM)
        run = self.start(name, dict(AROUND_PALM, topic=topic, check="inside", hold=EXPIRES / 2))
        run.talker = talker
        talker.wait_for_listener()
        return run

    def test_who_is_interrupted_fails(self):
        run = self.start_held("interrupted")
        run.process.send_signal(signal.SIGTERM)
        self.check_failure(run, "interrupted")

    def test_without_a_master_it_fails_at_once(self):
        path = os.path.join(self.folder, "no_master.xml")
        found = subprocess.run(
            [executable("link_bounds", "assert_box"), "--gtest_output=xml:" + path],
            env=dict(os.environ, ROS_MASTER_URI="http://localhost:1"), timeout=DEADLINE,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.assertEqual(found.returncode, 1)
        self.assertIn("no ROS master", found.stderr.decode())
        self.assertEqual(read_junit(path), (1, 0, 1))
        self.check_at_once(path)

    def test_a_report_that_cannot_be_written_is_a_failure(self):
        run = self.start("unwritable", dict(AROUND_PALM, check="inside"),
                         "--gtest_output=xml:/proc/no/such/report.xml")
        status, output = run.finish()
        self.assertEqual(status, 1)
        self.assertIn("cannot write /proc/no/such/report.xml", output)


if __name__ == "__main__":
    rospy.init_node("assert_box_faults_test")
    rostest.rosrun("link_bounds", "assert_box_faults", AssertBoxFaults)
