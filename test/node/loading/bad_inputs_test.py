#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Broken, hostile and odd robots: one node loads them all, one after the other."""
import itertools
import math
import unittest
from xml.etree import ElementTree

import rospy
import rostest
from bounds_testing import (NodeLog, Recorder, TfSender, box_link, corners_of, load, names_of,
                            robot, transform)
from patience import PATIENCE
from rosgraph_msgs.msg import Log

import bad_inputs

NODE = "/link_bounds_publisher"
DEADLINE = PATIENCE * (200.0 if bad_inputs.SANITIZED else 60.0)  # wall seconds for one robot
LATIN1 = "latin1_bytes.urdf"  # the parameter server carries Unicode only
GOOD_ROBOT = robot([box_link("base", (1, 2, 3)), box_link("moves", (1, 1, 1))],
                   [("base", "moves")])
GOOD_BOX = [-.5, -1, -1.5, .5, 1, 1.5]


def static_transforms(text):
    """The poses of all joints at zero; none where the text cannot be parsed."""
    try:
        joints = ElementTree.fromstring(text.strip()).findall("joint")
    except ElementTree.ParseError:
        return []
    result = []
    for joint in joints:
        parent, child = (joint.find(end).get("link") for end in ("parent", "child"))
        origin = joint.find("origin")
        xyz = (0, 0, 0) if origin is None else map(float, origin.get("xyz", "0 0 0").split())
        result.append(transform(parent, child, rospy.Time(), xyz))
    return result


class BadInputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("bad_inputs_test")
        rospy.set_param("/robot_description", GOOD_ROBOT)
        cls.boxes = Recorder(NODE + "/boxes")
        cls.log = NodeLog(NODE)
        cls.log.connect()
        cls.tf, cls.tf_static = TfSender(), TfSender(is_static=True)
        cls.tf.wait_for_listener()
        cls.tf_static.wait_for_listener()
        cls.metres = itertools.count(1)

    def test_every_case(self):
        failures, survived = [], 0
        for case in bad_inputs.cases():
            if case.name == LATIN1:
                print("skipped: %s cannot be a parameter" % LATIN1)
                continue
            try:
                self.check(case)
                survived += 1
            except AssertionError as failure:
                failures.append("%s: %s" % (case.name, failure))
        self.assertEqual(failures, [], "\n".join(failures))
        print("faults: %d broken robots in the running node" % survived)

    def check(self, case):
        is_bounded = "boxes" in case.expected
        begin = self.log.settle()
        self.boxes.clear()
        answer = self.reload(case.text.decode())
        if "exit" in case.expected:
            self.check_old_boxes_stay()
        if is_bounded:
            self.assertEqual(answer, "")
            self.check_boxes(case)
        errors = self.log.lines(Log.ERROR, begin, self.log.settle())
        self.assertNotIn("root:x:", "".join(errors))
        if is_bounded:
            self.check_errors(errors, case.expected)
        elif "exit" in case.expected:
            self.assertIn(case.expected["words"], answer)
            self.assertEqual(len(errors), 1, errors)
        for message in self.boxes.messages:
            self.check_rule(message)

    def check_old_boxes_stay(self):
        """The robot that was loaded before still moves."""
        x = next(self.metres)
        self.tf.send(transform("base", "moves", rospy.Time(1000 + x), (x, 0, 0)))
        moved = [x - .5, -.5, -.5, x + .5, .5, .5]

        def is_moved(message):
            return (names_of(message) == ["base", "moves"] and
                    self.is_near(corners_of(message.boxes[1]), moved, 1e-9))
        self.boxes.wait(is_moved, "the old robot at its new pose")
        for message in self.boxes.messages:
            self.assertTrue(self.is_near(corners_of(message.boxes[0]), GOOD_BOX, 1e-9))

    def reload(self, description):
        """The reason of a failure, or "". The description is good again afterwards."""
        try:
            load(NODE, description)
            return ""
        except AssertionError as failure:
            return str(failure)
        finally:
            rospy.set_param("/robot_description", GOOD_ROBOT)

    def check_boxes(self, case):
        transforms = static_transforms(case.text)
        if transforms:
            self.tf_static.send(*transforms)
        expected = {name: (low + high) for name, (low, high) in case.expected["boxes"].items()}
        incomplete = case.expected.get("incomplete", [])
        within = case.expected.get("within", 1e-9)

        def is_as_expected(message):
            return (set(names_of(message)) == set(expected) and message.incomplete == incomplete
                    and all(self.is_near(corners_of(box), expected[box.name], within)
                            for box in message.boxes))
        try:
            self.boxes.wait(is_as_expected, "the right boxes", DEADLINE)
        except AssertionError as failure:
            last = self.boxes.messages[-1]
            found = ["%s %s" % (box.name, corners_of(box)) for box in last.boxes[:5]]
            raise AssertionError("%s\nfound %s, incomplete %s" % (failure, found, last.incomplete))

    @staticmethod
    def is_near(box, expected, within):
        allowed = within + 1e-12 * max(map(abs, expected))
        return all(abs(a - b) <= allowed for a, b in zip(box, expected))

    def check_errors(self, errors, expected):
        """One for each incomplete link, with its name and the reason."""
        incomplete = expected.get("incomplete", [])
        self.assertEqual(len(errors), len(incomplete), errors)
        for name, error in zip(incomplete, errors):
            self.assertIn('link "%s"' % name, error)
            self.assertIn(expected["words"], error)

    def check_rule(self, message):
        for box in message.boxes:
            low, high = corners_of(box)[:3], corners_of(box)[3:]
            self.assertTrue(all(map(math.isfinite, low + high)), box)
            self.assertTrue(all(a <= b for a, b in zip(low, high)), box)


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "bad_inputs", BadInputs)
