#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~distances, ~nearest and ~distance_markers of bodies whose distances are known."""
import itertools
import math
import unittest

import rospy
import rostest
from bounds_testing import (Pose, Recorder, TfSender, box_link, load, robot, transform, turn,
                            wait_for)
from diagnostic_msgs.msg import DiagnosticStatus
from link_bounds.msg import Distance, DistanceArray
from node_testing import NODE, Diagnostics, value_of
from object_testing import ObjectSender, deletion, marker
from visualization_msgs.msg import Marker, MarkerArray

ACCURACY = 1e-4  # m, the default
# Neighbours by one joint are no pair: base and mid, mid and far.
THREE = robot([box_link("base", (1, 1, 1)), box_link("mid", (0.1, 0.1, 0.1)),
               box_link("far", (1, 1, 1))], [("base", "mid"), ("mid", "far")])
MANY = 300


def names_of(message):
    return [(d.first, d.second) for d in message.distances]


def left_out_of(message):
    return [(o.first, o.second) for o in message.not_compared]


def length(a, b):
    return math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2 + (a.z - b.z) ** 2)


class Distances(unittest.TestCase):
    stamps = itertools.count(1000)

    @classmethod
    def setUpClass(cls):
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.objects = ObjectSender(NODE)
        cls.boxes = Recorder(NODE + "/boxes")
        cls.distances = Recorder(NODE + "/distances", DistanceArray)
        cls.nearest = Recorder(NODE + "/nearest", Distance)
        cls.diagnostics = Diagnostics()
        for recorder in (cls.distances, cls.nearest):
            wait_for(lambda r=recorder: r.subscriber.get_num_connections() > 0, "connected")

    def setUp(self):
        self.objects.clear()
        load(NODE, THREE, distance_limit=0.5)
        self.distances_at(self.place(50), lambda m: not m.distances)
        self.distances.clear()
        self.nearest.clear()

    def place(self, x, degrees=0.0, y=0.0):
        """Link far at x; returns the stamp."""
        stamp = rospy.Time(next(self.stamps))
        self.tf.send(transform("base", "mid", stamp, (0, 0, 50)),
                     transform("mid", "far", stamp, (x, y, -50), turn((0, 0, 1), degrees)))
        return stamp

    def distances_at(self, stamp, condition=lambda m: True):
        return self.distances.wait(lambda m: m.header.stamp == stamp and condition(m),
                                   "distances of stamp %s" % stamp)

    def expect(self, distance, expected):
        self.assertLessEqual(distance.distance, expected + 1e-9)
        self.assertGreaterEqual(distance.distance_max, expected - 1e-9)
        self.assertLessEqual(distance.distance_max - distance.distance, ACCURACY)
        self.assertAlmostEqual(length(distance.on_first, distance.on_second),
                               distance.distance_max, delta=1e-9)

    def test_two_boxes(self):
        for x, degrees, y, expected in ((1.3, 0, 0, 0.3), (1.25, 45, 0, 0.75 - 0.5 ** 0.5),
                                        (1.3, 0, 1.4, 0.5), (1.0, 0, 0, 0), (0.2, 10, 0, 0)):
            stamp = self.place(x, degrees, y)
            message = self.distances_at(stamp)
            self.assertEqual(message.header.frame_id, "base")
            self.assertEqual(names_of(message), [("base", "far")], (x, degrees))
            found = message.distances[0]
            if expected > 0:
                self.expect(found, expected)
                self.assertAlmostEqual(length(found.normal, Marker().pose.position), 1, delta=1e-9)
                self.assertGreater(found.normal.x, 0)
            self.assertLessEqual(found.distance, expected + 1e-9)
            self.assertEqual(found.stamp, stamp)
            self.assertEqual(found.level, Distance.HULL)
            nearest = self.nearest.wait(lambda m, s=stamp: m.stamp == s, "nearest")
            self.assertEqual(nearest, found)

    def test_no_pair_within_the_limit(self):
        stamp = self.place(1.6)
        self.assertEqual(self.distances_at(stamp).distances, [])
        nearest = self.nearest.wait_newest(lambda m: m.first == "", "no names")
        self.assertEqual((nearest.second, nearest.level, nearest.distance, nearest.distance_max),
                         ("", Distance.BOX, 0.5, 0.5))

    def test_a_message_says_what_its_silence_means(self):
        load(NODE, THREE, distance_limit=0.5, distance_accuracy=1e-3)
        message = self.distances_at(self.place(50))
        self.assertEqual((message.limit, message.accuracy), (0.5, 1e-3))
        self.assertEqual(message.complete, ["base", "far"], "mid is joined to both")
        self.assertEqual((message.distances, message.not_compared), ([], []))
        load(NODE, THREE, distance_limit=100, ignore_pairs=["base far"])
        self.objects.send(marker("a/1"), marker("b/1"))
        message = self.distances_at(self.place(1.3), lambda m: len(m.distances) == 7)
        self.assertEqual(message.limit, 100)
        self.assertEqual(message.complete, ["base", "mid", "far", "a/1", "b/1"])
        self.assertEqual(left_out_of(message), [("base", "mid"), ("base", "far"), ("mid", "far")])
        self.assertAlmostEqual(message.not_compared[1].distance, 0.3, delta=1e-9)

    def test_where_no_pair_is_compared_no_name_is_complete(self):
        for parameters in ({"adjacent_joints": 2}, {"ignore_pairs": ["* *"]}):
            for x in (1.3, 50):
                load(NODE, THREE, distance_limit=0.5, **parameters)
                message = self.distances_at(self.place(x))
                self.assertEqual(message.complete, [], (parameters, x))
                self.assertEqual(left_out_of(message), [("base", "far")] if x < 2 else [])

    def test_padding_is_no_part_of_a_distance(self):
        load(NODE, THREE, distance_limit=0.5, padding=0.2)
        self.expect(self.distances_at(self.place(1.3)).distances[0], 0.3)

    def test_pairs_are_those_of_overlaps(self):
        load(NODE, THREE, distance_limit=100, adjacent_joints=0)
        self.assertEqual(names_of(self.distances_at(self.place(1.3))),
                         [("base", "mid"), ("base", "far"), ("mid", "far")])
        load(NODE, THREE, distance_limit=100, ignore_pairs=["base a/*"])
        stamp = self.place(1.3)
        self.objects.send(marker("a/1"), marker("b/1"))
        message = self.distances_at(stamp, lambda m: len(m.distances) > 1)
        self.assertEqual(names_of(message), [
            ("base", "far"), ("base", "b/1"), ("mid", "a/1"), ("mid", "b/1"), ("far", "a/1"),
            ("far", "b/1"), ("a/1", "b/1")])

    def test_an_attached_object_is_part_of_the_link(self):
        """It stays a pair with what the link is a pair with."""
        load(NODE, THREE, distance_limit=100, attached={"far": ["a/*"], "base": ["b/1"]})
        stamp = self.place(1.3)
        self.objects.send(marker("a/1"), marker("a/2"), marker("b/1"), marker("c/1"))
        message = self.distances_at(stamp, lambda m: any("c/1" in pair for pair in names_of(m)))
        self.assertEqual(names_of(message), [
            ("base", "far"), ("base", "a/1"), ("base", "a/2"), ("base", "c/1"), ("mid", "c/1"),
            ("far", "b/1"), ("far", "c/1"), ("a/1", "b/1"), ("a/1", "c/1"), ("a/2", "b/1"),
            ("a/2", "c/1"), ("b/1", "c/1")])
        self.assertIn(("far", "a/1"), left_out_of(message))

    def test_objects_come_change_and_go(self):
        ball = Pose((0, 0, 1))
        self.objects.send(marker("ball/1", Marker.SPHERE, (0.4, 0.4, 0.4), ball))
        found = self.distances.wait(lambda m: m.distances, "the ball").distances[0]
        self.assertEqual((found.first, found.second), ("base", "ball/1"))
        self.expect(found, 0.3)
        self.objects.send(marker("ball/1", Marker.SPHERE, (0.6, 0.6, 0.6), ball))
        found = self.distances.wait(lambda m: m.distances and m.distances[0].distance < 0.25,
                                    "a larger ball").distances[0]
        self.expect(found, 0.2)
        self.distances.clear()
        self.objects.send(deletion("ball/1"))
        self.distances.wait(lambda m: not m.distances, "no ball")

    def test_a_list_gets_its_triangles(self):
        """Two tetrahedra left and right of the robot; their hull goes through it."""
        corners = [(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)]
        faces = [p for skipped in range(4) for i, p in enumerate(corners) if i != skipped]
        points = [(x + dx, y, z) for dx in (-0.8, 0.7) for x, y, z in faces]
        self.objects.send(marker("list/1", Marker.TRIANGLE_LIST, points=points))
        hull = self.distances.wait(lambda m: m.distances, "the list").distances[0]
        self.assertEqual((hull.distance, hull.level), (0, Distance.HULL))
        exact = self.distances.wait(lambda m: m.distances and m.distances[0].level == Distance.MESH,
                                    "its triangles").distances[0]
        self.expect(exact, 0.2)

    def test_incomplete_is_that_of_boxes(self):
        load(NODE, robot([box_link("base", (1, 1, 1)), box_link("lost", (1, 1, 1))],
                         [("base", "lost")]), distance_limit=0.5)
        message = self.distances.wait_newest(lambda m: m.incomplete == ["lost"], "incomplete")
        self.assertEqual(message.complete, [])
        self.objects.send(marker("a/1", frame="nowhere"))
        self.distances.wait_newest(lambda m: m.incomplete == ["lost", "a/1"], "both")

    def subscribe_again(self):
        """rospy connects a topic of one process only once."""
        for recorder in (self.distances, self.nearest):
            recorder.subscriber.unregister()
        type(self).distances = Recorder(NODE + "/distances", DistanceArray)
        type(self).nearest = Recorder(NODE + "/nearest", Distance)

    def test_a_new_subscriber_gets_all_at_once(self):
        stamp = self.place(1.3)
        self.distances_at(stamp)
        self.subscribe_again()
        self.expect(self.distances_at(stamp).distances[0], 0.3)
        self.nearest.wait(lambda m: m.stamp == stamp, "the welcome")
        markers = Recorder(NODE + "/distance_markers", MarkerArray)
        self.addCleanup(markers.subscriber.unregister)
        markers.wait(lambda m: m.markers[0].header.stamp == stamp, "the welcome")

    def test_nobody_listens(self):
        self.distances.subscriber.unregister()
        self.nearest.subscriber.unregister()
        self.diagnostics.wait_for_new(
            lambda _, s: value_of(s, "distances") == "silent: nobody subscribes" and
            value_of(s, "nearest") == "none", "silence")
        self.subscribe_again()
        self.expect(self.distances_at(self.place(1.3)).distances[0], 0.3)

    def test_markers(self):
        markers = Recorder(NODE + "/distance_markers", MarkerArray)
        self.addCleanup(markers.subscriber.unregister)
        stamp = self.place(1.3)
        message = markers.wait(lambda m: m.markers[0].header.stamp == stamp, "a line")
        lines, text, nearest = message.markers
        found = self.distances_at(stamp).distances[0]
        for line in (lines, nearest):
            self.assertEqual((line.type, line.action), (Marker.LINE_LIST, Marker.ADD))
            self.assertEqual(line.points, [found.on_first, found.on_second])
            self.assertEqual(len(line.colors), 2)
        self.assertEqual(text.action, Marker.ADD)
        self.assertIn("0.30", text.text)
        stamp = self.place(3)
        message = markers.wait(lambda m: m.markers[0].header.stamp == stamp, "no line")
        self.assertEqual([m.action for m in message.markers], [Marker.DELETE] * 3)
        self.assertEqual([(m.ns, m.id) for m in message.markers],
                         [(m.ns, m.id) for m in (lines, text, nearest)])

    def test_diagnostics_and_warning(self):
        load(NODE, THREE, distance_limit=0.5, distance_warning=0.35)
        self.place(1.3)
        status = self.diagnostics.wait_for_new(
            lambda _, s: "base and far may be only 0.2999" in s.message or
            "base and far may be only 0.3000" in s.message, "a warning")
        self.assertEqual(status.level, DiagnosticStatus.WARN)
        self.assertEqual(value_of(status, "distance pairs"), "1")
        self.assertEqual(value_of(status, "distance pairs decided by hulls"), "1")
        self.assertEqual(value_of(status, "without triangles"), "none")
        self.place(1.4)
        self.diagnostics.wait_for_new(
            lambda _, s: s.level == DiagnosticStatus.OK and
            "base and far may be only 0.4" in value_of(s, "nearest"), "no warning")

    def test_invalid_parameters(self):
        for name, value in (("distance_limit", -1.0), ("distance_accuracy", 0.0),
                            ("distance_warning", -0.1), ("distance_limit", float("inf"))):
            with self.assertRaisesRegex(AssertionError, name):
                load(NODE, THREE, **{name: value})

    def test_many_objects(self):
        """A row of cubes: each is near to the one before and the one after it."""
        load(NODE, THREE, distance_limit=0.1, ignore_pairs=["base row/*"])
        for turned in (0, 90):
            self.distances.clear()
            self.objects.send(*(
                marker("row/%d" % i,
                       scale=(0.45, 0.45, 0.45),
                       pose=Pose((0.5 * i, 5, 0), turn((0, 0, 1), turned)))
                for i in range(MANY)))
            message = self.distances.wait(lambda m: len(m.distances) == MANY - 1, "all")
            for i, found in enumerate(message.distances):
                self.assertEqual((found.first, found.second), ("row/%d" % i, "row/%d" % (i + 1)))
                self.expect(found, 0.05)


if __name__ == "__main__":
    rospy.init_node("distances_test")
    rostest.rosrun("link_bounds", "distances", Distances)
