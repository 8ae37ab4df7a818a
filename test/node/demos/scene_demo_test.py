#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's scene moves and deforms; what overlaps is drawn in the second colour; lines show
distances."""
import math
import unittest

import rospkg
import rospy
import rostest
import yaml
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
LIMIT = 0.3  # m, distance_limit of scene_demo.launch
SCENE = rospkg.RosPack().get_path("link_bounds") + "/launch/scene_demo.rviz"


def drawn_boxes(message, state):
    """How many boxes are drawn with edges of a colour."""
    edges = next(m for m in message.markers if m.ns == state and m.type == Marker.LINE_LIST)
    return len(edges.points) / POINTS_PER_BOX


def lengths(message):
    """Of the lines between near things."""
    points = message.markers[0].points
    return [math.dist((a.x, a.y, a.z), (b.x, b.y, b.z)) for a, b in zip(points[::2], points[1::2])]


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

    def test_lines_join_what_is_near(self):
        drawings = Recorder(NODE + "/distance_markers", MarkerArray)
        message = drawings.wait(lambda m: m.markers[0].points, "lines", TOUCH)
        self.assertEqual(message.markers[0].type, Marker.LINE_LIST)
        # Far more than the default distance_limit joins.
        drawings.wait(lambda m: any(LIMIT / 2 < length <= LIMIT for length in lengths(m)), "far")

    def test_rviz_shows_topics_that_exist(self):
        published = dict(rospy.get_published_topics())
        with open(SCENE, encoding="utf-8") as file:
            displays = yaml.safe_load(file)["Visualization Manager"]["Displays"]
        topics = {display.get("Marker Topic") for display in displays if display["Enabled"]}
        self.assertIn(NODE + "/distance_markers", topics)
        for topic in topics - {None}:
            self.assertEqual(published[topic], "visualization_msgs/MarkerArray")

    def test_the_mesh_has_its_own_size(self):
        objects = Recorder(NODE + "/objects", MarkerArray)
        message = objects.wait(lambda m: True, "the objects")
        scales = [m.scale for m in message.markers if m.ns == "mesh"]
        self.assertEqual([(s.x, s.y, s.z) for s in scales], [(1, 1, 1)])


if __name__ == "__main__":
    rospy.init_node("scene_demo_test")
    rostest.rosrun("link_bounds", "scene_demo", SceneDemo)
