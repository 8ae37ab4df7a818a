#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which links have boxes, their padding and groups, and the warnings."""
import math
import tempfile
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Log

from bounds_testing import (NodeLog, Pose, TfSender, box_link, box_of, corners_of, difference,
                            latched, load, names_of, robot, transform, turn, union, visual,
                            wait_for)

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-9  # metres
SIZES = {"base": (1.0, 2.0, 3.0), "arm": (0.2, 0.3, 0.4), "hand": (0.1, 0.1, 0.5)}
POSES = {"base": Pose(), "arm": Pose((0, 0, 2), turn((0, 0, 1), 30)),
         "hand": Pose((1, 0, 0), turn((1, 0, 0), 45)), "bare": Pose(),
         "shapes": Pose((0, 3, 0), turn((0, 1, 0), 45))}
EXACT = {name: POSES[name].box_bounds(size) for name, size in SIZES.items()}

BOX_SIZE, BOX_FROM_LINK = (0.2, 0.4, 0.6), Pose((0.5, 0, 0), turn((0, 0, 1), 30))
BALL_RADIUS, BALL_CENTRE = 0.1, (0.0, 0.0, 1.5)
MESH_POSE, MIRROR = Pose((0, 0.25, 0), turn((1, 0, 0), 45)), (1.0, -1.0, 0.5)
MESH_POINTS = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
TRIANGLES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def ascii_stl():
    facets = "".join("facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join(
        "vertex %g %g %g\n" % MESH_POINTS[i] for i in triangle) for triangle in TRIANGLES)
    return "solid corner\n%sendsolid corner\n" % facets


def shapes_link(mesh_file):
    """A box and a ball of different origins and a mirrored mesh."""
    return '<link name="shapes">%s%s%s</link>' % (
        visual('<box size="%r %r %r"/>' % BOX_SIZE, BOX_FROM_LINK.xyz, (0, 0, math.radians(30))),
        visual('<sphere radius="%r"/>' % BALL_RADIUS, BALL_CENTRE),
        visual('<mesh filename="file://%s" scale="%r %r %r"/>' % (mesh_file, *MIRROR),
               MESH_POSE.xyz, (math.radians(45), 0, 0)))


def shapes_box():
    link = POSES["shapes"]
    centre = link.moved(BALL_CENTRE)
    ball = [c - BALL_RADIUS for c in centre] + [c + BALL_RADIUS for c in centre]
    mirrored = [[a * b for a, b in zip(p, MIRROR)] for p in MESH_POINTS]
    return union([(link * BOX_FROM_LINK).box_bounds(BOX_SIZE), ball,
                  (link * MESH_POSE).bounds(mirrored)])


def padded(box, padding):
    return [c - padding for c in box[:3]] + [c + padding for c in box[3:]]


class SelectionTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("selection_test")
        cls.mesh = tempfile.NamedTemporaryFile("w", suffix=".stl")
        cls.mesh.write(ascii_stl())
        cls.mesh.flush()
        links = [box_link(name, size) for name, size in SIZES.items()]
        load(NODE, robot(links + ['<link name="bare"/>', shapes_link(cls.mesh.name)],
                         [("base", child) for child in POSES if child != "base"]))
        tf = TfSender(is_static=True)
        tf.wait_for_listener()
        tf.send(*[transform("base", name, rospy.Time(), pose.xyz, pose.xyzw)
                  for name, pose in POSES.items() if name != "base"])
        wait_for(lambda: len(latched(NODE + "/boxes").boxes) == 4, "tf has arrived")
        cls.log = NodeLog(NODE)
        cls.log.connect()

    @classmethod
    def tearDownClass(cls):
        cls.mesh.close()

    def reload(self, **parameters):
        """~boxes and ~groups after a reload."""
        load(NODE, **parameters)
        return latched(NODE + "/boxes"), latched(NODE + "/groups")

    def check_box(self, box, expected):
        self.assertLess(difference(corners_of(box), expected), TOLERANCE, box.name)

    def test_all_links_with_geometry(self):
        boxes, _ = self.reload()
        self.assertEqual((names_of(boxes), boxes.incomplete),
                         (["base", "arm", "hand", "shapes"], []))

    def test_only_links(self):
        boxes, groups = self.reload(links=["hand", "base"])
        self.assertEqual((names_of(boxes), boxes.incomplete), (["base", "hand"], []))
        self.check_box(groups.boxes[0], union([EXACT["base"], EXACT["hand"]]))

    def test_ignored_links(self):
        boxes, groups = self.reload(ignore_links=["base", "shapes"])
        self.assertEqual((names_of(boxes), boxes.incomplete), (["arm", "hand"], []))
        self.check_box(groups.boxes[0], union([EXACT["arm"], EXACT["hand"]]))

    def test_links_and_ignored_links(self):
        boxes, _ = self.reload(links=["arm", "hand"], ignore_links=["hand"])
        self.assertEqual(names_of(boxes), ["arm"])

    def test_padding(self):
        boxes, groups = self.reload(links=list(SIZES), padding=0.05)
        for box in boxes.boxes:
            self.check_box(box, padded(EXACT[box.name], 0.05))
        self.check_box(groups.boxes[0], padded(union(list(EXACT.values())), 0.05))

    def test_padding_of_one_link_replaces_the_other(self):
        boxes, _ = self.reload(padding=0.05, link_padding={"arm": 0.2, "hand": 0.0})
        for name, padding in (("base", 0.05), ("arm", 0.2), ("hand", 0.0)):
            self.check_box(box_of(boxes, name), padded(EXACT[name], padding))

    def test_link_of_several_shapes(self):
        boxes, _ = self.reload()
        self.check_box(box_of(boxes, "shapes"), shapes_box())

    def test_groups_in_alphabetical_order(self):
        boxes, groups = self.reload(groups={"zeta": ["arm"], "alpha": ["arm", "hand"],
                                            "middle": ["base"]})
        self.assertEqual(len(boxes.boxes), 4)
        self.assertEqual((names_of(groups), groups.incomplete),
                         (["robot", "alpha", "middle", "zeta"], []))
        self.check_box(box_of(groups, "alpha"), union([EXACT["arm"], EXACT["hand"]]))
        self.check_box(box_of(groups, "zeta"), EXACT["arm"])

    def test_group_with_a_missing_member_is_incomplete(self):
        _, groups = self.reload(groups={"partly": ["arm", "no_such_link"],
                                        "never": ["no_such_link"], "whole": ["arm"]})
        self.assertEqual(names_of(groups), ["robot", "partly", "whole"])
        self.assertEqual(groups.incomplete, ["never", "partly"])
        self.check_box(box_of(groups, "partly"), EXACT["arm"])

    def test_group_with_an_ignored_member_is_incomplete(self):
        _, groups = self.reload(ignore_links=["hand"], groups={"both": ["arm", "hand"]})
        self.assertEqual(groups.incomplete, ["both"])

    def test_pattern_without_objects_is_complete(self):
        _, groups = self.reload(groups={"things": ["table/*"], "arm_and_things": ["arm", "shop/*"]})
        self.assertEqual((names_of(groups), groups.incomplete), (["robot", "arm_and_things"], []))

    def warnings_of(self, **parameters):
        """The warnings of a reload."""
        begin = self.log.settle() + 1
        load(NODE, **parameters)
        return self.log.lines(Log.WARN, begin, self.log.settle())

    def test_unknown_links_are_warned_about_once(self):
        warnings = self.warnings_of(
            links=["base", "arm", "wrong_a"], ignore_links=["wrong_b", "wrong_a"],
            link_padding={"wrong_c": 0.1, "wrong_a": 0.2}, groups={"one": ["wrong_d", "wrong_b"]})
        for name in ("wrong_a", "wrong_b", "wrong_c", "wrong_d"):
            self.assertEqual(len([line for line in warnings if name in line]), 1, warnings)
        self.assertEqual(len(warnings), 4, warnings)

    def test_node_goes_on_with_unknown_links(self):
        boxes, _ = self.reload(links=["arm", "no_such_link"])
        self.assertEqual((names_of(boxes), boxes.incomplete), (["arm"], []))

    def test_unknown_parameter_is_warned_about(self):
        warnings = self.warnings_of(paddings=0.1, diagnostic_period=2.0)
        self.assertEqual(len(warnings), 2, warnings)
        for name in "paddings", "diagnostic_period":  # the latter has no effect either
            self.assertTrue(any(name in warning for warning in warnings), warnings)


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "selection", SelectionTest)
