#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text from outside cannot forge a line of the log, control a terminal, or fill a disk."""
import unittest

import rospy
import rostest
from bounds_testing import NodeLog, load, robot, visual
from node_testing import ARMS, NODE, Diagnostics
from object_testing import ObjectSender, marker
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker

FORGED = "\n[ERROR] forged\u202e"
CLEARED = "\x1b[2J"  # XML-RPC cannot carry it
LONG = 5000 * "x"
MAX_LENGTH = 1000  # characters of a line


class LogLines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load(NODE, ARMS, fixed_frame="base")
        cls.log = NodeLog(NODE)
        cls.log.connect()
        cls.diagnostics = Diagnostics()

    def check(self, text):
        self.assertTrue(text.isprintable(), repr(text[:MAX_LENGTH]))
        self.assertLess(len(text), MAX_LENGTH)

    def check_line_with(self, *words):
        self.check(self.log.wait(lambda m: all(w in m.msg for w in words), " ".join(words)).msg)

    def test_markers(self):
        self.addCleanup(ObjectSender(NODE).clear)
        objects = ObjectSender(NODE)
        load(NODE, fixed_frame="base", timeout=0.5)
        objects.send(
            marker("mesh/1", Marker.MESH_RESOURCE,
                   mesh_resource="file:///one%s%s.stl" % (FORGED, CLEARED)),
            marker("mesh/2", Marker.MESH_RESOURCE, mesh_resource="file:///two" + LONG),
            marker("frame/1", frame="three" + FORGED + CLEARED, stamp=rospy.Time(1)),
            marker("frame/2", frame="four" + LONG, stamp=rospy.Time(1)),
            marker("five%s%s/1" % (FORGED, CLEARED), scale=(-1, 1, 1)))
        for word in ("one", "two", "three", "four", "five"):
            self.check_line_with(word, "is refused")

    def test_description(self):
        mesh = '<mesh filename="file:///%s%s.stl"/>'
        escaped = FORGED.replace("\n", "&#10;")
        load(NODE, robot(['<link name="six%s">%s</link>' % (escaped, visual(mesh % ("a", ""))),
                          '<link name="seven">%s</link>' % visual(mesh % ("b", escaped)),
                          '<link name="eight">%s</link>' % visual(mesh % ("c", LONG))],
                         [("seven", "six" + escaped), ("seven", "eight")]))
        self.addCleanup(load, NODE, ARMS, fixed_frame="base")
        for word in ("six", "seven", "eight"):
            self.check_line_with(word, "/")
        status = self.diagnostics.wait_for_new(
            lambda _, s: any("eight" in pair.key for pair in s.values), "the new robot")
        for pair in status.values:
            self.check(pair.key)
            self.check(pair.value)

    def test_answer_of_reload(self):
        self.addCleanup(load, NODE, ARMS, fixed_frame="base")
        for value in ("nine" + FORGED, "ten" + LONG):
            rospy.set_param(NODE + "/ignore_pairs", [value])
            answer = rospy.ServiceProxy(NODE + "/reload", Trigger)()
            self.assertFalse(answer.success)
            self.check(answer.message)
            self.check_line_with(value[:3], "reload failed")


if __name__ == "__main__":
    rospy.init_node("log_lines_test")
    rostest.rosrun("link_bounds", "log_lines", LogLines)
