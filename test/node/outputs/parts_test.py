#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~parts: several tight boxes per link that together are the box of the link, in any pose."""
import itertools
import os
import unittest
import xml.etree.ElementTree as ElementTree
from xmlrpc.client import ServerProxy

import rosgraph
import roslib.packages
import rospy
import rostest
from bounds_testing import (Pose, Recorder, TfSender, corners_of, difference, latched, load,
                            names_of, robot, transform, turn, union, visual, wait_for)

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-12  # metres
BLOCK = (0.2, 0.4, 0.6)
PLACES = ((-1.0, 0.0, 0.0), (1.0, 0.5, 0.0))
LOST_MESH = "package://link_bounds/no_such_folder/no_such_mesh.stl"
MESH = "package://link_bounds/launch/demo/meshes/forearm.obj"
BLOCKS = "".join(visual('<box size="%r %r %r"/>' % BLOCK, place) for place in PLACES)


def link(name, content):
    return '<link name="%s">%s</link>' % (name, content)


def mesh(uri):
    return visual('<mesh filename="%s"/>' % uri)


def demo_description():
    path = os.path.join(roslib.packages.get_pkg_dir("link_bounds"), "launch", "demo", "demo.urdf")
    with open(path, encoding="utf-8") as file:
        return file.read()


def volume(message):
    sizes = [[high - low for low, high in zip(corners_of(box)[:3], corners_of(box)[3:])]
             for box in message.boxes]
    return sum(x * y * z for x, y, z in sizes)


def by_name(message):
    """The coordinates of all boxes of each name, names in order."""
    return {name: [corners_of(box) for box in boxes]
            for name, boxes in itertools.groupby(message.boxes, lambda box: box.name)}


class PartsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seconds = itertools.count(1000)
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.boxes = Recorder(NODE + "/boxes")

    def listen(self):
        parts = Recorder(NODE + "/parts")
        self.addCleanup(parts.subscriber.unregister)
        wait_for(lambda: parts.subscriber.get_num_connections() > 0, "connected")
        return parts

    def heard_topics(self):
        """Those that the node publishes to somebody."""
        node = ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode(NODE))
        connections = node.getBusInfo(rospy.get_name())[2]
        return [topic for _, _, direction, _, topic, *_ in connections if direction == "o"]

    def send(self, poses):
        """Poses by link, in the frame "base"; returns ~boxes once it shows them."""
        stamp = rospy.Time(next(self.seconds))
        self.tf.send(*[transform("base", name, stamp, pose.xyz, pose.xyzw)
                       for name, pose in poses.items()])
        return self.boxes.wait(
            lambda m: {box.name for box in m.boxes if box.stamp == stamp} == set(poses), "poses")

    def check_unions(self, boxes, parts, max_parts):
        """Parts have the links, stamps and incomplete of the boxes; their unions are the boxes."""
        self.assertEqual((parts.header.stamp, parts.header.frame_id, parts.incomplete),
                         (boxes.header.stamp, boxes.header.frame_id, boxes.incomplete))
        found = by_name(parts)
        self.assertEqual(list(found), names_of(boxes))
        for box in boxes.boxes:
            self.assertLessEqual(len(found[box.name]), max_parts, box.name)
            self.assertLess(difference(union(found[box.name]), corners_of(box)), TOLERANCE)
        self.assertEqual({(box.name, box.stamp) for box in parts.boxes},
                         {(box.name, box.stamp) for box in boxes.boxes})

    def test_demo_robot_with_turned_links(self):
        description = demo_description()
        names = [link.get("name") for link in ElementTree.fromstring(description).iter("link")]
        load(NODE, description, parts_per_link=8)
        parts = self.listen()
        shown = [name for name in names if name != "base"]
        for degrees in (30, 45):
            stamp = rospy.Time(next(self.seconds))
            self.tf.send(*[transform("base", name, stamp, (i, 0, 0), turn((i, 1, 2), degrees))
                           for i, name in enumerate(shown)])
            boxes = self.boxes.wait(lambda m, s=stamp: m.header.stamp == s and not m.incomplete,
                                    "the demo robot")
            message = parts.wait(lambda m, s=stamp: m.header.stamp == s and not m.incomplete,
                                 "its parts")
            self.check_unions(boxes, message, 8)
            self.assertGreater(len(message.boxes), 2 * len(boxes.boxes))
            self.assertLess(volume(message), 0.95 * volume(boxes))

    def load_blocks(self, **parameters):
        load(NODE, robot([link("base", BLOCKS), link("arm", BLOCKS)], [("base", "arm")]),
             **parameters)

    def test_parts_are_exact_in_turned_poses(self):
        self.load_blocks(parts_per_link=2)
        parts = self.listen()
        for degrees in (30, 45):
            pose = Pose((1, 2, 3), turn((1, 1, 0), degrees))
            stamp = self.send({"arm": pose}).header.stamp
            message = parts.wait(lambda m, s=stamp: m.header.stamp == s, "the pose")
            expected = [(pose * Pose(place)).box_bounds(BLOCK) for place in PLACES]
            found = by_name(message)["arm"]
            self.assertEqual(len(found), 2)
            for exact in expected:
                self.assertLess(min(difference(exact, box) for box in found), TOLERANCE)

    def test_each_part_is_padded(self):
        self.load_blocks(parts_per_link=2, padding=0.5, link_padding={"arm": 0.125})
        pose = Pose((1, 2, 3), turn((0, 1, 1), 30))
        stamp = self.send({"arm": pose}).header.stamp
        message = self.listen().wait(lambda m: m.header.stamp == stamp, "the pose")
        for name, at, padding in (("base", Pose(), 0.5), ("arm", pose, 0.125)):
            for place in PLACES:
                exact = (at * Pose(place)).box_bounds(BLOCK)
                expected = [c - padding for c in exact[:3]] + [c + padding for c in exact[3:]]
                self.assertLess(min(difference(expected, box) for box in by_name(message)[name]),
                                TOLERANCE)

    def test_a_late_subscriber_gets_one_complete_message_at_once(self):
        self.load_blocks(parts_per_link=2)
        boxes = self.send({"arm": Pose((0, 0, 1), turn((1, 0, 0), 45))})
        message = latched(NODE + "/parts")
        self.check_unions(boxes, message, 2)
        self.assertEqual(names_of(message), ["base", "base", "arm", "arm"])

    def test_the_end_of_parts_is_told_once(self):
        """A listener must not take the last parts for those of now."""
        self.load_blocks(parts_per_link=2)
        parts = self.listen()
        stamp = self.send({"arm": Pose((0, 0, 1))}).header.stamp
        parts.wait(lambda m: m.header.stamp == stamp and len(m.boxes) == 4, "parts")
        parts.clear()
        self.load_blocks()
        message = parts.wait(lambda m: not m.boxes and not m.incomplete, "the end")
        self.assertEqual((message.header.stamp, message.header.frame_id), (stamp, "base"))
        self.send({"arm": Pose((0, 0, 2))})
        self.load_blocks(parts_per_link=2)
        parts.wait(lambda m: m.boxes and m is not message, "parts again")
        self.assertEqual([bool(m.boxes) for m in parts.messages][:2], [False, True])

    def test_one_part_per_link_is_silence(self):
        """Also where a listener that has left was shown parts."""
        self.load_blocks(parts_per_link=2)
        latched(NODE + "/parts")
        wait_for(lambda: NODE + "/parts" not in self.heard_topics(), "its connection has ended")
        self.load_blocks()
        parts = self.listen()
        self.send({"arm": Pose((0, 0, 1))})
        self.load_blocks(parts_per_link=2)  # parts that had been sent before would arrive first
        message = parts.wait(lambda m: m.boxes, "parts, after ~reload")
        self.assertEqual(parts.messages[0], message)
        self.assertEqual(len(message.boxes), 4)

    def test_incomplete_is_that_of_the_boxes(self):
        load(NODE, robot([link("base", BLOCKS), link("partly", BLOCKS + mesh(LOST_MESH)),
                          link("nowhere", BLOCKS), link("nothing", mesh(LOST_MESH)),
                          link("sound", mesh(MESH))],
                         [("base", name) for name in ("partly", "nowhere", "nothing", "sound")]),
             parts_per_link=4)
        boxes = self.send({"partly": Pose((0, 1, 0), turn((1, 0, 0), 30)),
                           "sound": Pose((2, 0, 0), turn((0, 1, 2), 45))})
        message = latched(NODE + "/parts")
        self.check_unions(boxes, message, 4)
        self.assertEqual(message.incomplete, ["partly", "nowhere", "nothing"])
        self.assertGreater(len(by_name(message)["sound"]), 1)

    def test_other_numbers_are_refused(self):
        self.load_blocks(parts_per_link=256)
        for number in (0, -1, 257, 1.5):
            expected = "parts_per_link is %s, but must be a whole number" % number
            with self.assertRaisesRegex(AssertionError, expected):
                self.load_blocks(parts_per_link=number)
        with self.assertRaisesRegex(AssertionError, "a whole number of at most 2147483647"):
            self.load_blocks(parts_per_link=3e9)  # which XML-RPC sends as a double
        self.load_blocks(parts_per_link=2)


if __name__ == "__main__":
    rospy.init_node("parts_test")
    rostest.rosrun("link_bounds", "parts", PartsTest)
