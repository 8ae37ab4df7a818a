#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~overlaps has the pairs that a check of all published boxes finds, but joined links."""
import itertools
import math
import unittest

import rospkg
import rospy
import rostest
from bounds_testing import (JointSender, Pose, Recorder, TfSender, box_link, load, robot,
                            transform, turn, wait_for)
from demo_testing import POSES
from link_bounds.msg import BoxOverlapArray
from node_testing import NODE
from object_testing import ObjectSender, deletion, marker
from overlap_testing import agree, expected, joined_links, pairs_of, pairs_that_fit
from raw_subscriber import Reader

TOPIC = NODE + "/overlaps"
DEMO = rospkg.RosPack().get_path("link_bounds") + "/launch/demo/demo.urdf"


BODIES = """<robot name="bodies">%s
  <joint name="1" type="fixed"><parent link="base"/><child link="plate"/></joint>
  <joint name="2" type="floating"><parent link="plate"/><child link="bare"/></joint>
  <joint name="3" type="fixed"><parent link="bare"/><child link="arm"/></joint>
  <joint name="4" type="floating"><parent link="arm"/><child link="hand"/></joint>
  <joint name="5" type="floating"><parent link="hand"/><child link="tip"/></joint></robot>"""
BODIES %= "".join(box_link(name, (0.4, 0.3, 0.2)) for name in
                  ("tip", "base", "plate", "arm", "hand")) + '<link name="bare"/>'
# All boxes of BODIES overlap, whatever their turn; these are free to move against each other.
FREE = [("tip", "base"), ("tip", "plate"), ("tip", "arm"), ("base", "hand"), ("plate", "hand")]
BODIES_TOGETHER = {joint: Pose() for joint in (
    ("base", "plate"), ("plate", "bare"), ("bare", "arm"), ("arm", "hand"), ("hand", "tip"))}
TWO = robot([box_link("base", (1, 1, 1)), box_link("mid", (0.1, 0.1, 0.1)),
             box_link("far", (1, 1, 1))], [("base", "mid"), ("mid", "far")])


class Overlaps(unittest.TestCase):
    stamps = itertools.count(1000)

    @classmethod
    def setUpClass(cls):
        cls.demo = open(DEMO, encoding="utf-8").read()
        cls.joints = JointSender()
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.objects = ObjectSender(NODE)
        cls.boxes = Recorder(NODE + "/boxes")
        cls.overlaps = Recorder(TOPIC, BoxOverlapArray)
        wait_for(lambda: cls.overlaps.subscriber.get_num_connections() > 0, "connected")

    def tearDown(self):
        self.objects.clear()

    def check(self, boxes, margin=0.0, ignored=()):
        """The overlaps of these boxes, or of the next ones at the same places: where ~boxes comes
        faster than overlaps are computed, those in between are skipped. A stamp may come twice, the
        first time with fewer boxes."""
        wanted = expected(boxes, margin, ignored)
        return self.overlaps.wait(
            lambda m: m.header.stamp >= boxes.header.stamp and
            m.header.stamp in {b.header.stamp for b in self.boxes.messages} and
            m.header.frame_id == boxes.header.frame_id and agree(m, wanted), wanted)

    def place(self, poses):
        """The boxes of links at these poses in their parents, with a stamp of their own."""
        stamp = rospy.Time(next(self.stamps))
        self.tf.send(*(transform(parent, child, stamp, pose.xyz, pose.xyzw)
                       for (parent, child), pose in poses.items()))
        return self.boxes.wait(lambda m: m.header.stamp == stamp and not m.incomplete,
                               "boxes of stamp %s" % stamp)

    def place_two(self, x, degrees=0.0):
        """Links base and far, with a small one between them."""
        return self.place({("base", "mid"): Pose((0, 0, 5)),
                           ("mid", "far"): Pose((x, 0, -5), turn((0, 0, 1), degrees))})

    def test_the_demo_robot_in_all_poses(self):
        ignored = joined_links(self.demo)
        for geometry, margin in (("visual", 0.0), ("both", 0.05), ("visual", 10.0)):
            load(NODE, self.demo, geometry=geometry, overlap_margin=margin)
            seen = set()
            for pose in POSES:
                seen.update(pairs_of(self.check(self.joints.move(pose, self.boxes), margin,
                                                ignored)))
            self.assertGreater(len(seen), 0)

    def test_a_healthy_demo_robot_has_none_across_two_joints(self):
        load(NODE, self.demo, adjacent_joints=2)
        for pose in POSES:
            overlaps = self.check(self.joints.move(pose, self.boxes),
                                  ignored=joined_links(self.demo, 2))
            self.assertEqual(overlaps.overlaps, [], pose)

    def test_adjacent_joints(self):
        for joints, count in ((0, 9), (1, len(FREE)), (2, 2), (3, 0), (1000, 0)):
            load(NODE, BODIES, adjacent_joints=joints)
            boxes = self.place(BODIES_TOGETHER)
            overlaps = self.check(boxes, ignored=joined_links(BODIES, min(joints, 4)))
            self.assertEqual(len(overlaps.overlaps), count, joints)
        with self.assertRaisesRegex(AssertionError, "adjacent_joints"):
            load(NODE, adjacent_joints=-1)

    def test_wildcards(self):
        """Two links and four objects, all of which overlap; mid is elsewhere."""
        objects = ["right/arm/0", "right/hand/0", "held/1", "held/deep/1"]
        names = ["base", "far"] + objects
        for entries, count in (
                ([], 15), (["right/*/* right/*/*"], 14), (["* held/*"], 13), (["* *"], 14),
                (["f* b*"], 14), (["*/*/* */*/*"], 12), (["base held/*", "far held/*/*"], 13)):
            load(NODE, TWO, ignore_pairs=entries)
            self.place_two(0.5)
            self.boxes.clear()
            self.objects.send(*(marker(name, scale=(0.5, 0.5, 0.5)) for name in objects))
            boxes = self.boxes.wait(lambda m: len(m.boxes) == 7, "links and objects")
            overlaps = self.check(boxes, ignored=joined_links(TWO).union(
                *(pairs_that_fit(names, *entry.split()) for entry in entries)))
            self.assertEqual(len(overlaps.overlaps), count, entries)
            self.objects.clear()

    def test_bodies_of_fixed_joints_and_their_neighbours(self):
        load(NODE, BODIES)
        for degrees in (0, 30, 45):
            pose = Pose((0, 0, 0), turn((1, 2, 3), degrees))
            boxes = self.place({("plate", "bare"): pose, ("arm", "hand"): pose,
                                ("hand", "tip"): pose, ("base", "plate"): Pose(),
                                ("bare", "arm"): Pose()})
            overlaps = self.check(boxes, ignored=joined_links(BODIES))
            self.assertEqual(pairs_of(overlaps), FREE)

    def test_ignored_pairs(self):
        load(NODE, BODIES, ignore_pairs=["tip base", "hand plate", "tip no_such_link"])
        boxes = self.place(BODIES_TOGETHER)
        named = {("tip", "base"), ("plate", "hand")}
        overlaps = self.check(boxes, ignored=joined_links(BODIES) | named)
        self.assertEqual(pairs_of(overlaps), [pair for pair in FREE if pair not in named])

    def test_names_with_spaces(self):
        spaced = TWO.replace('"far"', '"far end"')
        load(NODE, spaced, ignore_pairs=["base far end"])
        boxes = self.place({("base", "mid"): Pose((0, 0, 5)),
                            ("mid", "far end"): Pose((0.5, 0, -5))})
        self.check(boxes, ignored=[("base", "far end")])

    def test_what_is_no_pair_is_refused(self):
        load(NODE, TWO)
        for entry in ("base", "", "base mid far"):
            with self.assertRaisesRegex(AssertionError, "ignore_pairs"):
                load(NODE, ignore_pairs=["base mid", entry])
        with self.assertRaisesRegex(AssertionError, "overlap_margin"):
            load(NODE, overlap_margin=-0.1)

    def test_distance_of_turned_boxes(self):
        load(NODE, TWO, overlap_margin=0.5)
        for degrees in (0, 30, 45):
            half = 0.5 * (math.cos(math.radians(degrees)) + math.sin(math.radians(degrees)))
            for gap in (-0.25, 0.25):
                overlaps = self.check(self.place_two(0.5 + half + gap, degrees), 0.5)
                self.assertEqual(len(overlaps.overlaps), 1)
                self.assertAlmostEqual(overlaps.overlaps[0].distance, gap, delta=1e-9)

    def test_an_empty_array_says_that_there_is_none(self):
        load(NODE, TWO)
        self.assertEqual(self.check(self.place_two(3)).overlaps, [])
        self.assertEqual(len(self.check(self.place_two(0.9)).overlaps), 1)
        self.assertEqual(self.check(self.place_two(3)).overlaps, [])

    def test_the_margin_changes_with_reload(self):
        load(NODE, TWO)
        self.assertEqual(self.check(self.place_two(1.25)).overlaps, [])
        self.overlaps.clear()
        load(NODE, overlap_margin=0.25 + 1e-9)
        self.overlaps.wait(lambda m: len(m.overlaps) == 1, "one within the new margin")

    def test_a_late_subscriber_gets_one_at_once(self):
        load(NODE, TWO)
        boxes = self.place_two(0.75)
        self.overlaps.subscriber.unregister()
        try:
            message = rospy.wait_for_message(TOPIC, BoxOverlapArray, 20)
            self.assertEqual(pairs_of(message), [("base", "far")])
            self.assertEqual(message.header.stamp, boxes.header.stamp)
        finally:
            type(self).overlaps = Recorder(TOPIC, BoxOverlapArray)

    def test_a_new_subscriber_alone_gets_a_message(self):
        load(NODE, TWO, parts_per_link=2, timeout=0.0)
        self.place_two(0.5)
        for topic in ("overlaps", "parts", "markers", "footprint"):
            readers = []
            for _ in range(3):
                readers.append(Reader(NODE, NODE + "/" + topic))
                self.addCleanup(readers[-1].end)
                wait_for(lambda: readers[-1].count, "a message on ~" + topic)
            self.assertEqual([reader.count for reader in readers], [1, 1, 1], topic)

    def test_objects_against_links_and_each_other(self):
        load(NODE, TWO, ignore_pairs=["crate/3 base", "crate/1 crate/4"])
        self.place_two(3)
        size = (0.5, 0.5, 0.5)
        poses = {"crate/1": Pose((0.7, 0, 0), turn((0, 0, 1), 45)),
                 "crate/2": Pose((3, 0, 0.7), turn((1, 0, 0), 30)),
                 "crate/3": Pose((0.2, 0, 0)), "crate/4": Pose((1, 0, 0))}
        self.objects.send(*(marker(name, scale=size, pose=pose) for name, pose in poses.items()))
        self.overlaps.wait(
            lambda m: pairs_of(m) == [("base", "crate/1"), ("far", "crate/2"),
                                      ("crate/1", "crate/3")], "three pairs")
        boxes = self.boxes.wait(lambda m: len(m.boxes) == 7, "links and objects")
        self.check(boxes, ignored=[("base", "crate/3"), ("crate/1", "crate/4")])
        self.overlaps.clear()
        self.objects.send(deletion("crate/3"))
        self.overlaps.wait(lambda m: pairs_of(m) == [("base", "crate/1"), ("far", "crate/2")],
                           "two pairs after one went")


if __name__ == "__main__":
    rospy.init_node("overlaps_test")
    rostest.rosrun("link_bounds", "overlaps", Overlaps)
