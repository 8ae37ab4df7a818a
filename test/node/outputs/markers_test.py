#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~markers: what rviz draws."""
import itertools
import math
import time
import unittest

import rospkg
import rospy
import rostest
from bounds_testing import Recorder, box_link, box_of, corners_of, difference, load, robot
from node_testing import ALL, ARMS, DYNAMIC, NODE, STATIC, ArmsTf
from page_testing import rows_below
from visualization_msgs.msg import Marker, MarkerArray

PAGE = rospkg.RosPack().get_path("link_bounds") + "/doc/scene.md"
TOLERANCE = 1e-9  # m
MIN_THICKNESS = 1e-4  # m
FACES, EDGES, LABEL = 0, 1, 2
CHARACTER = 0.5  # width of a character of rviz's font on average, relative to its height
CONTRAST = 3  # what WCAG 2 asks of large text
WHITE, DARK, BLACK = (1, 1, 1), (48 / 255,) * 3, (0, 0, 0)  # DARK is rviz's default
MARKER_RATE = 1.0  # Hz
SENDING = 3.0  # wall seconds


def added(array):
    return {(m.ns, m.id): m for m in array.markers if m.action == Marker.ADD}


def luminance(red, green, blue):
    """Of a color of sRGB, relative to that of white."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
              for c in (red, green, blue)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(color, background):
    """By the definition of WCAG 2, from 1 to 21."""
    low, high = sorted((luminance(color.r, color.g, color.b), luminance(*background)))
    return (high + 0.05) / (low + 0.05)


def deleted(array):
    return [(m.ns, m.id) for m in array.markers if m.action == Marker.DELETE]


def edges_of(box):
    """The twelve edges of six coordinates as a set of pairs of corners."""
    corners = [tuple(box[axis + 3 * (i >> axis & 1)] for axis in range(3)) for i in range(8)]
    return {frozenset((corners[i], corners[i | 1 << axis]))
            for i in range(8) for axis in range(3) if not i >> axis & 1}


class Markers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.tf = ArmsTf()
        cls.now = 1000

    def record(self):
        """A new subscriber. rospy would share the connection of one that still exists."""
        markers = Recorder(NODE + "/markers", MarkerArray)
        self.addCleanup(markers.subscriber.unregister)
        return markers

    def start(self, **parameters):
        """Loads the arms, sends one pose; returns a new recorder of markers and its first array."""
        load(NODE, ARMS, **parameters)
        self.send_next()
        markers = self.record()
        return markers, markers.wait(lambda m: True, "a first array")

    def send_next(self):
        Markers.now += 1
        stamp = rospy.Time(self.now)
        self.tf.send(stamp)
        self.message = self.boxes.wait(
            lambda m: m.header.stamp == stamp and len(m.boxes) == len(ALL), "all boxes")

    def test_first_array_of_a_late_subscriber_has_exactly_the_boxes(self):
        _, first = self.start(marker_labels=True)
        self.assertEqual(set(added(first)),
                         {(name, i) for name in ALL for i in (FACES, EDGES, LABEL)})

    def test_each_marker_is_as_promised(self):
        _, first = self.start(marker_labels=True, marker_color=[1.0, 0.5, 0.25, 0.125])
        for (ns, i), marker in added(first).items():
            self.assertEqual(marker.header.frame_id, "base")
            self.assertEqual(marker.header.stamp, self.message.header.stamp)
            self.assertTrue(marker.frame_locked)
            self.assertEqual(marker.lifetime, rospy.Duration(0))
            self.assertEqual(marker.pose.orientation.w, 1)
            self.assertEqual(marker.type, {FACES: Marker.CUBE, EDGES: Marker.LINE_LIST,
                                           LABEL: Marker.TEXT_VIEW_FACING}[i])
            if i == LABEL:
                self.assertEqual(marker.text, ns)
                for background in (WHITE, DARK, BLACK):
                    self.assertGreaterEqual(contrast(marker.color, background), CONTRAST)
            else:
                color = marker.color
                self.assertEqual((color.r, color.g, color.b, color.a),
                                 (1.0, 0.5, 0.25, 0.125 if i == FACES else 1.0))

    def test_labels_stand_above_their_boxes_and_apart(self):
        _, first = self.start(marker_labels=True)
        labels = [marker for marker in first.markers if marker.id == LABEL]
        for label in labels:
            box = box_of(self.message, label.text)
            self.assertGreater(label.pose.position.z - label.scale.z / 2, box.max.z)
        for a, b in itertools.combinations(labels, 2):
            p, q = a.pose.position, b.pose.position
            gaps = [abs(p.z - q.z) / (a.scale.z + b.scale.z)]
            widths = CHARACTER * (len(a.text) * a.scale.z + len(b.text) * b.scale.z)
            gaps += [abs(p.x - q.x) / widths, abs(p.y - q.y) / widths]
            self.assertGreater(max(gaps), 0.5 - TOLERANCE, a.text + " and " + b.text)

    def test_ids_are_those_of_the_page(self):
        _, first = self.start(marker_labels=True)
        with open(PAGE, encoding="utf-8") as page:
            rows = rows_below(page.read(), ["id", "type", "what", "when"])
        self.assertEqual({(marker.id, marker.type) for marker in first.markers},
                         {(int(row[0]), getattr(Marker, row[1])) for row in rows})

    def test_cubes_contain_their_boxes_and_edges_follow_them(self):
        _, first = self.start()
        for name in ALL:
            box = corners_of(box_of(self.message, name))
            cube, lines = added(first)[name, FACES], added(first)[name, EDGES]
            p, s = cube.pose.position, cube.scale
            low = [p.x - s.x / 2, p.y - s.y / 2, p.z - s.z / 2]
            high = [p.x + s.x / 2, p.y + s.y / 2, p.z + s.z / 2]
            self.assertTrue(all(a <= b for a, b in zip(low, box[:3])), name)
            self.assertTrue(all(a >= b for a, b in zip(high, box[3:])), name)
            self.assertLess(difference(low + high, box), TOLERANCE)
            q = lines.pose.position
            points = [(q.x + c.x, q.y + c.y, q.z + c.z) for c in lines.points]
            self.assertEqual(len(points), 24)
            rounded = [tuple(round(c, 6) for c in point) for point in points]
            self.assertEqual({frozenset(pair) for pair in zip(rounded[::2], rounded[1::2])},
                             edges_of([round(c, 6) for c in box]))

    def test_style_chooses_and_a_reload_deletes_the_other(self):
        markers, first = self.start(marker_style="edges")
        self.assertEqual(set(added(first)), {(name, EDGES) for name in ALL})
        markers.clear()
        load(NODE, marker_style="faces")
        other = markers.wait(lambda m: ("base", FACES) in added(m), "the other style")
        self.assertEqual(set(added(other)), {(name, FACES) for name in ALL})
        self.assertEqual(set(deleted(other)), {(name, EDGES) for name in ALL})

    def test_a_vanished_box_is_deleted_once(self):
        markers, _ = self.start()
        load(NODE, timeout=1e-3)
        gone = markers.wait(lambda m: deleted(m), "stale links")
        self.assertEqual(set(deleted(gone)),
                         {(name, i) for name in DYNAMIC for i in (FACES, EDGES)})
        self.assertEqual({ns for ns, _ in added(gone)}, set(STATIC))
        load(NODE)
        self.send_next()
        last = rospy.Time(self.now)
        markers.wait(lambda m: len(added(m)) == 2 * len(ALL) and
                     added(m)["left", FACES].header.stamp == last, "all again")
        self.assertEqual(sum(len(deleted(m)) for m in markers.messages), 2 * len(DYNAMIC))

    def test_flat_boxes_get_some_thickness(self):
        load(NODE, robot([box_link("base", (1.0, 0.0, 0.5))], []))
        markers = self.record()
        first = markers.wait(lambda m: len(added(m)) == 2, "the flat box")
        self.assertAlmostEqual(added(first)["base", FACES].scale.y, MIN_THICKNESS, delta=TOLERANCE)
        self.assertTrue(all(math.isfinite(c) for m in first.markers
                            for point in m.points for c in (point.x, point.y, point.z)))

    def test_marker_rate_is_lower_than_the_rate_of_boxes(self):
        markers, _ = self.start(marker_rate=MARKER_RATE)
        markers.clear()
        start, count = time.monotonic(), 0
        while time.monotonic() < start + SENDING:
            self.send_next()
            count += 1
        last = rospy.Time(self.now)
        markers.wait(lambda m: m.markers[0].header.stamp == last, "the newest state")
        # One more at the beginning of the time, and one that was on its way.
        limit = MARKER_RATE * (time.monotonic() - start) + 2
        self.assertGreater(count, 5 * limit)
        self.assertLessEqual(len(markers.messages), limit)

    def test_a_raised_marker_rate_takes_effect_at_once(self):
        markers, _ = self.start(marker_rate=0.02)
        self.send_next()
        load(NODE, marker_rate=30.0)
        last = rospy.Time(self.now)
        markers.wait(lambda m: m.markers[0].header.stamp == last, "the newest state")


if __name__ == "__main__":
    rospy.init_node("markers_test")
    rostest.rosrun("link_bounds", "markers", Markers)
