#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's scene moves and deforms; what overlaps is drawn in the second colour."""
import unittest

import rospy
import rostest
from bounds_testing import Recorder, box_of, names_of
from link_bounds.msg import BoxOverlapArray
from node_testing import NODE
from visualization_msgs.msg import Marker, MarkerArray

OBJECTS = ["balls/0", "balls/1", "balls/2", "mesh/0", "parcels/0", "parcels/1", "parcels/2",
           "parcels/3", "parcels/4", "sheet/0"]
LINKS = ["base", "shoulder", "upper_arm", "elbow", "forearm", "wrist", "flange", "gripper",
         "finger_left", "finger_right"]
MESSAGES = 500  # ten seconds of the joints
TOUCH = 60.0  # wall seconds within which the arm touches an object
POINTS_PER_BOX = 24  # of its twelve edges


def drawn_boxes(message, state):
    """How many boxes are drawn with edges of a colour."""
    edges = next(m for m in message.markers if m.ns == state and m.type == Marker.LINE_LIST)
    return len(edges.points) / POINTS_PER_BOX


class SceneDemo(unittest.TestCase):
    def test_objects_and_arm(self):
        boxes = Recorder(NODE + "/boxes")
        first = boxes.wait(lambda m: not m.incomplete and names_of(m)[-10:] == OBJECTS, "a scene")
        for name in OBJECTS + ["forearm"]:
            boxes.wait(lambda m, n=name: not m.incomplete and box_of(m, n) and
                       box_of(m, n).max != box_of(first, n).max, name + " moves")
        boxes.subscriber.unregister()

    def test_overlaps_have_the_second_colour(self):
        overlaps = Recorder(NODE + "/overlaps", BoxOverlapArray)
        drawings = Recorder("/overlap_colors/markers", MarkerArray)
        hit = overlaps.wait(lambda m: m.overlaps, "something overlaps")
        names = {name for pair in hit.overlaps for name in (pair.first, pair.second)}
        self.assertGreaterEqual(len(names), 2)
        message = drawings.wait(lambda m: drawn_boxes(m, "overlapping") >= 2, "red boxes")
        self.assertGreater(drawn_boxes(message, "free"), 0)

    def test_the_arm_does_not_overlap_itself(self):
        overlaps = Recorder(NODE + "/overlaps", BoxOverlapArray)
        overlaps.wait(
            lambda m: len(overlaps.messages) > MESSAGES and any(
                pair.first in LINKS for pair in m.overlaps), "the arm touches an object", TOUCH)
        self.assertFalse([(pair.first, pair.second) for message in overlaps.messages
                          for pair in message.overlaps if pair.second in LINKS])

    def test_the_mesh_has_its_own_size(self):
        objects = Recorder(NODE + "/objects", MarkerArray)
        message = objects.wait(lambda m: True, "the objects")
        scales = [m.scale for m in message.markers if m.ns == "mesh"]
        self.assertEqual([(s.x, s.y, s.z) for s in scales], [(1, 1, 1)])


if __name__ == "__main__":
    rospy.init_node("scene_demo_test")
    rostest.rosrun("link_bounds", "scene_demo", SceneDemo)
