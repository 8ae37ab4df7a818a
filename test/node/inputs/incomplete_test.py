#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Links without an exact box are named in the log once, in incomplete always; others are exact."""
import math
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Log

from bounds_testing import (NodeLog, Pose, Recorder, TfSender, box_link, box_of, corners_of,
                            difference, latched, load, names_of, robot, transform, turn, union,
                            visual, wait_for)

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-9  # metres
SIZE, PART, CENTRE = (0.2, 0.5, 1.1), (0.3, 0.6, 0.9), (0.7, 0.0, 0.0)
POSES = {"base": Pose(), "good": Pose((1, 0, 0), turn((0, 0, 1), 30)),
         "partly": Pose((0, 2, 0), turn((0, 1, 0), 45)), "bad": Pose()}
EXACT = {"base": Pose().box_bounds(SIZE), "good": (POSES["good"] * Pose(CENTRE)).box_bounds(SIZE),
         "partly": POSES["partly"].box_bounds(PART)}
BAD_MESH = "package://link_bounds/no_such_folder/no_such_mesh.stl"
PARTLY_MESH = "file:///no_such_folder/no_such_part.dae"
DESCRIPTION = robot(
    [box_link("base", SIZE),
     '<link name="bad">%s</link>' % visual('<mesh filename="%s"/>' % BAD_MESH),
     box_link("good", SIZE, CENTRE),
     '<link name="partly">%s%s</link>' % (visual('<box size="%r %r %r"/>' % PART),
                                          visual('<mesh filename="%s"/>' % PARTLY_MESH)),
     box_link("lost", SIZE)],
    [("base", child) for child in ("bad", "good", "partly", "lost")])
NAN, INF = math.nan, math.inf


def at(seconds):
    return rospy.Time(1000 + seconds)


class IncompleteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("incomplete_test")
        cls.tf = TfSender()
        static_tf = TfSender(is_static=True)
        for sender in (cls.tf, static_tf):
            sender.wait_for_listener()
        static_tf.send(*[transform("base", name, rospy.Time(), pose.xyz, pose.xyzw)
                         for name, pose in POSES.items() if name != "base"])
        load(NODE, DESCRIPTION)
        wait_for(lambda: len(latched(NODE + "/boxes").boxes) == 3, "tf has arrived")
        cls.log = NodeLog(NODE)
        cls.log.connect()

    def setUp(self):
        load(NODE, DESCRIPTION)
        self.message = latched(NODE + "/boxes")

    def check_box(self, box, expected):
        self.assertTrue(all(map(math.isfinite, corners_of(box))), box)
        self.assertLess(difference(corners_of(box), expected), TOLERANCE, box.name)

    def test_missing_mesh(self):
        self.assertIsNone(box_of(self.message, "bad"))
        self.assertIn("bad", self.message.incomplete)

    def test_box_of_a_part_is_incomplete(self):
        self.check_box(box_of(self.message, "partly"), EXACT["partly"])
        self.assertIn("partly", self.message.incomplete)

    def test_frame_without_transform(self):
        self.assertIsNone(box_of(self.message, "lost"))
        self.assertIn("lost", self.message.incomplete)

    def test_all_others_are_exact(self):
        self.assertEqual(names_of(self.message), ["base", "good", "partly"])
        self.assertEqual(self.message.incomplete, ["bad", "partly", "lost"])
        for box in self.message.boxes:
            self.check_box(box, EXACT[box.name])

    def test_group_follows(self):
        groups = latched(NODE + "/groups")
        self.assertEqual((names_of(groups), groups.incomplete), (["robot"], ["robot"]))
        self.check_box(groups.boxes[0], union(list(EXACT.values())))

    def errors_of_one_load(self):
        begin = self.log.settle()
        return self.log.lines(Log.ERROR, begin, self.log.settle())

    def test_each_mesh_is_an_error_once_per_load(self):
        for _ in range(2):
            errors = self.errors_of_one_load()
            self.assertEqual(len(errors), 2, errors)
            self.assertEqual(len([line for line in errors if '"bad"' in line]), 1, errors)
            self.assertEqual(len([line for line in errors if '"partly"' in line]), 1, errors)

    def test_error_names_link_element_file_and_remedy(self):
        bad, partly = self.errors_of_one_load()
        for line, words in ((bad, ('"bad"', "visual 1", BAD_MESH)),
                            (partly, ('"partly"', "visual 2", PARTLY_MESH))):
            for word in words:
                self.assertIn(word, line)
            self.assertRegex(line, "; (correct|install|repair|replace) ")

    def mover_and_rider(self, prefix):
        """A robot whose mover is turned by 30 degrees; returns its names and a cleared Recorder."""
        names = [prefix + name for name in ("base", "aside", "mover", "rider")]
        base, aside, mover, rider = names
        load(NODE, robot([box_link(name, SIZE) for name in names],
                         [(base, aside), (base, mover), (mover, rider)]))
        boxes = Recorder(NODE + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        self.tf.send(transform(base, aside, at(0)), transform(mover, rider, at(0)),
                     transform(mover, rider, at(9), (0, 0, 1)),
                     transform(base, mover, at(0), xyzw=turn((0, 0, 1), 30)))
        boxes.wait(lambda m: names_of(m) == names and not m.incomplete, "all boxes")
        boxes.clear()
        return names, boxes

    def check_numbers(self, boxes):
        for message in boxes.messages:
            for box in message.boxes:
                values = corners_of(box)
                self.assertTrue(all(map(math.isfinite, values)), message)
                self.assertTrue(all(a <= b for a, b in zip(values[:3], values[3:])), message)

    def test_infinite_transform_takes_the_boxes_away(self):
        for i, place in enumerate([(INF, 0, 0), (0, -INF, 0), (INF, -INF, INF)]):
            (base, aside, mover, rider), boxes = self.mover_and_rider("inf%d_" % i)
            self.tf.send(transform(base, mover, at(1), place))
            message = boxes.wait(lambda m: mover in m.incomplete, "the loss")
            self.assertEqual((names_of(message), message.incomplete),
                             ([base, aside], [mover, rider]))
            self.tf.send(transform(base, mover, at(2), (3, 0, 0)))
            message = boxes.wait(lambda m: m.header.stamp == at(2), "the return")
            self.assertEqual(message.incomplete, [])
            self.check_box(box_of(message, mover), Pose((3, 0, 0)).box_bounds(SIZE))
            self.check_numbers(boxes)

    def test_nan_transform_changes_nothing(self):
        for i, place in enumerate([dict(xyz=(NAN, 0, 0)), dict(xyzw=(0, 0, NAN, 1)),
                                   dict(xyzw=(0, 0, 0, 0)), dict(xyzw=(0, 0, 0, INF))]):
            (base, aside, mover, _), boxes = self.mover_and_rider("nan%d_" % i)
            self.tf.send(transform(base, mover, at(1), **place))
            self.tf.send(transform(base, aside, at(2)))
            message = boxes.wait(lambda m: m.header.stamp == at(2), "the next news")
            self.assertEqual(len(boxes.messages), 1)
            self.assertEqual((message.incomplete, box_of(message, mover).stamp), ([], at(0)))
            self.check_box(box_of(message, mover),
                           Pose(xyzw=turn((0, 0, 1), 30)).box_bounds(SIZE))
            self.check_numbers(boxes)

    def test_only_nan_is_no_transform(self):
        load(NODE, robot([box_link("only_base", SIZE), box_link("only_nan", SIZE)],
                         [("only_base", "only_nan")]))
        self.tf.send(transform("only_base", "only_nan", at(1), (NAN, NAN, NAN)))
        self.tf.send(transform("only_elsewhere", "only_base", at(2)))  # comes after the NaN
        wait_for(lambda: latched(NODE + "/boxes").header.stamp == at(2), "the next news")
        message = latched(NODE + "/boxes")
        self.assertEqual((names_of(message), message.incomplete), (["only_base"], ["only_nan"]))


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "incomplete", IncompleteTest)
