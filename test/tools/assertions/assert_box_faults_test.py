#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""assert_box fails where it must: exit status, a report that rostest understands, the last box."""
import os
import subprocess

import rospy
import rostest
from assertion_testing import EXPIRES, FaultsTest, Talker
from bounds_testing import DEADLINE, Pose, executable, turn
from catkin.test_results import read_junit
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from std_msgs.msg import Header

TOPIC = "/link_bounds_publisher/boxes"  # the default of assert_box
FRAME = 'cell <1> & "2"'


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
    "held": dict(AROUND_PALM, check="inside", hold=0.5)}
FAILING = {  # parameters, and what the failure says
    "not_equal": (dict(EXACT_PALM, max=[c + 0.02 for c in PALM_MAX]),
                  [LAST_PALM, "off by 0.02 m: max x by 0.02 m, max y by", FRAME]),
    "not_inside": (dict(AROUND_PALM, check="inside", max=[2, 1, 0.5]),
                   [LAST_PALM, "off by 0.05 m: max z by 0.05 m", "not inside [0, -1, 0] to [2, 1, 0.5]"]),
    "missing": (MISSING, ["no such box", "not named in incomplete", "palm, thumb"]),
    "incomplete": (dict(EXACT_PALM, name="thumb", check="outside", topic="/half/boxes"),
                   ["thumb", "incomplete"]),
    "no_topic": (dict(AROUND_PALM, topic="/nobody/boxes"), ["no message came", "/nobody/boxes"])}
INVALID = {  # the other ones are in box_watch_test.py
    "no_name": ({"min": [0, 0, 0], "max": [1, 1, 1]}, "~name is required"),
    "nan": (dict(AROUND_PALM, min=[0, 0, float("nan")]), "NaN], but must hold neither NaN nor .inf"),
    "misspelt": (dict(AROUND_PALM, tolerence=0.1), "~tolerence is unknown")}


class AssertBoxFaults(FaultsTest):
    PROGRAM = "assert_box"
    passing, failing, invalid = PASSING, FAILING, INVALID

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.talker = BoxTalker(TOPIC)
        cls.talker.send(PALM, THUMB)
        cls.half = BoxTalker("/half/boxes")
        cls.half.send(PALM, THUMB, incomplete=["thumb"])

    def test_an_unknown_argument_fails(self):
        self.check_failure(self.start("argument", AROUND_PALM, "--gtest_filter=palm"),
                           "--gtest_filter=palm", "--help")

    def test_what_goes_away_breaks_the_hold(self):
        box = self.start_held("going")  # may end while the next one starts
        box.talker.send(THUMB, incomplete=["palm"])
        publisher = self.start_held("ending")
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

    def test_without_a_master_it_fails_at_once(self):
        path = os.path.join(self.folder, "no_master.xml")
        for uri, text in (("http://localhost:1", "no ROS master"),
                          ("localhost", "it must be http://HOST:PORT")):
            with self.subTest(uri):
                found = subprocess.run(
                    [executable("link_bounds", "assert_box"), "--gtest_output=xml:" + path],
                    env=dict(os.environ, ROS_MASTER_URI=uri), timeout=DEADLINE,
                    stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                self.assertEqual(found.returncode, 1)
                self.assertIn(text, found.stderr.decode())
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
