#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances of hostile meshes, during reloads and clock jumps, and the memory after them. Boxes go
on undisturbed beside a node whose distances nobody wants."""
import math
import pathlib
import shutil
import signal
import tempfile

import rospy
import rostest
from binary_stl import binary_stl
from bounds_testing import (Pose, Recorder, box_link, load, robot, transform, visual, wait_for)
from link_bounds.msg import Distance, DistanceArray
from node_testing import (SANITIZED, Delays, Diagnostics, OwnNodes, Repeater, SimulatedClock,
                          resident_bytes, value_of)
from object_testing import ObjectSender, marker
from patience import PATIENCE
from visualization_msgs.msg import Marker

SLIVERS = 20000 if SANITIZED else 100000
MAX_DELAY = 0.3 * PATIENCE  # wall seconds beyond what the machine takes
MEBIBYTE = 1 << 20
KEPT = 8 * MEBIBYTE
PROMPT = 10.0 * PATIENCE  # s, for the end of a node


def write_slivers(path, count, size=1.0):
    """Needles from a common centre to a sphere: every box of a tree overlaps all others."""
    needles = []
    for i in range(count):
        z = 2 * (i + 0.5) / count - 1
        angle = 2.4 * i
        r = math.sqrt(1 - z * z)
        x, y = r * math.cos(angle), r * math.sin(angle)
        needles.append(((0, 0, 0), (size * x, size * y, size * z),
                        (size * x * 1.0001, size * y, size * z)))
    path.write_bytes(binary_stl(needles))


def mesh_robot(path):
    mesh = '<link name="%s">' + visual('<mesh filename="file://%s"/>' % path) + "</link>"
    return robot([mesh % "base", box_link("mid", (0.1, 0.1, 0.1)), mesh % "far"],
                 [("base", "mid"), ("mid", "far")])


class DistanceFaults(OwnNodes):
    def setUp(self):
        super().setUp()
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def place(self, x, stamp=None):
        stamp = stamp or rospy.Time(next(self.stamps))
        self.tf.send(transform("base", "mid", stamp, (0, 0, 50)),
                     transform("mid", "far", stamp, (x, 0, -50)))
        return stamp

    def listen(self, node):
        recorder = Recorder(node.name + "/distances", DistanceArray)
        self.addCleanup(recorder.subscriber.unregister)
        wait_for(lambda: recorder.subscriber.get_num_connections() > 0, "connected")
        return recorder

    def test_a_mesh_whose_triangles_do_not_fit_counts_as_its_hull(self):
        path = self.folder / "slivers.stl"
        write_slivers(path, SLIVERS)
        size = path.stat().st_size
        node = self.start(mesh_robot(path), distance_limit=1.0, max_mesh_bytes=size + size // 10)
        diagnostics = Diagnostics(node.name)
        distances = self.listen(node)
        self.place(2.5)
        diagnostics.wait_for_new(
            lambda _, s: str(path) in value_of(s, "without triangles") and
            "max_mesh_bytes" in value_of(s, "without triangles"), "a reason")
        found = distances.wait(lambda m: m.distances, "a pair").distances[0]
        self.assertEqual(found.level, Distance.HULL)
        self.assertLessEqual(found.distance, 0.5)
        self.assertGreater(found.distance, 0.45)
        self.assertEqual(node.output.count("max_mesh_bytes"), 1, node.output)

    def test_a_mesh_that_was_replaced_counts_as_its_hull_until_a_reload(self):
        path = self.folder / "slivers.stl"
        write_slivers(path, 1000)
        node = self.start(mesh_robot(path), distance_limit=1.0)
        diagnostics = Diagnostics(node.name)
        write_slivers(path, 1000, size=0.9)
        distances = self.listen(node)
        self.place(2.5)
        diagnostics.wait_for_new(
            lambda _, s: "was replaced" in value_of(s, "without triangles"), "a reason")
        found = distances.wait_newest(lambda m: m.distances, "a pair").distances[0]
        self.assertEqual(found.level, Distance.HULL)
        self.assertAlmostEqual(found.distance, 0.5, delta=0.05)
        load(node.name, distance_limit=1.0)
        diagnostics.wait_for_new(lambda _, s: value_of(s, "without triangles") == "none", "none")
        found = distances.wait_newest(lambda m: m.distances and m.distances[0].distance > 0.65,
                                      "the new mesh").distances[0]
        self.assertLessEqual(found.distance, 0.75)

    def test_boxes_go_on_beside_slivers(self):
        """While their trees are made, and while their distances are computed."""
        path = self.folder / "slivers.stl"
        write_slivers(path, SLIVERS)
        node = self.start(mesh_robot(path), distance_limit=1.0)
        other = self.start(mesh_robot(path), distance_limit=1.0)
        delays = Delays(node.name, other.name)
        self.addCleanup(delays.end)
        for name in (node.name, other.name):
            wait_for(lambda n=name: Recorder(n + "/boxes").messages, name)

        def move():
            stamp = rospy.Time(next(self.stamps))
            delays.record(stamp)
            self.place(2.0 + 0.01 * math.sin(stamp.to_sec()), stamp)

        mover = Repeater(50.0, move)
        self.addCleanup(mover.stop)
        distances = self.listen(node)
        found = distances.wait(lambda m: m.distances and m.distances[0].level == Distance.MESH,
                               "triangles", 120.0 * PATIENCE)
        self.assertLessEqual(found.distances[0].distance, found.distances[0].distance_max)
        seen = len(distances.messages)
        wait_for(lambda: len(distances.messages) > seen + 20, "more of them")
        mover.stop()
        self.assertLess(delays.longest(node.name), delays.longest(other.name) + MAX_DELAY)

    def test_equal_points(self):
        node = self.start(robot([box_link("base", (1, 1, 1))], []), distance_limit=1.0)
        distances = self.listen(node)
        ObjectSender(node.name).send(marker("dot/1", Marker.TRIANGLE_LIST,
                                            points=[(1, 0, 0)] * 30000))
        exact = distances.wait(
            lambda m: m.distances and
            m.distances[0].distance_max - m.distances[0].distance < 1.1e-4, "the dot").distances[0]
        self.assertAlmostEqual(exact.distance, 0.5, delta=1.1e-4)

    def test_reload_while_distances_are_computed(self):
        """No message mixes two robots: names and distances belong together."""
        first = robot([box_link(name, (1, 1, 1)) for name in ("base", "mid", "far")],
                      [("base", "mid"), ("mid", "far")])
        second = first.replace("far", "other").replace('size="1 1 1"', 'size="0.8 0.8 0.8"')
        node = self.start(first, distance_limit=1.0)
        distances = self.listen(node)
        mover = Repeater(200.0, lambda: self.tf.send(
            *(transform(parent, child, stamp, xyz) for stamp in [rospy.Time(next(self.stamps))]
              for parent, child, xyz in (("base", "mid", (0, 0, 50)), ("mid", "far", (1.5, 0, -50)),
                                         ("mid", "other", (1.5, 0, -50))))))
        self.addCleanup(mover.stop)
        for description, name in ((second, "other"), (first, "far")) * 4:
            distances.clear()
            load(node.name, description, distance_limit=1.0)
            distances.wait(lambda m, n=name: m.distances and m.distances[0].second == n, name)
        mover.stop()
        expected = {"far": 0.5, "other": 0.7}
        for message in distances.messages:
            for found in message.distances:
                self.assertAlmostEqual(found.distance, expected[found.second], delta=1e-3)

    def test_a_clock_jump(self):
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.delete_param, "/use_sim_time")
        node = self.start(robot([box_link(name, (1, 1, 1)) for name in ("base", "mid", "far")],
                                [("base", "mid"), ("mid", "far")]), distance_limit=1.0)
        clock = SimulatedClock(Diagnostics(node.name))
        distances = self.listen(node)
        clock.set(1000)
        self.place(1.5, rospy.Time(1000))
        distances.wait(lambda m: m.distances, "before")
        clock.set(10)
        distances.wait_newest(lambda m: m.incomplete == ["mid", "far"] and not m.distances,
                              "nothing after the jump")
        self.place(1.4, rospy.Time(10))
        found = distances.wait_newest(lambda m: m.distances, "after").distances[0]
        self.assertEqual(found.stamp, rospy.Time(10))
        self.assertAlmostEqual(found.distance, 0.4, delta=1e-3)

    def test_memory_after_subscribers_and_objects(self):
        node = self.start(robot([box_link("base", (1, 1, 1))], []), distance_limit=0.5)
        objects = ObjectSender(node.name)
        before = None
        for i in range(30):
            distances = Recorder(node.name + "/distances", DistanceArray)
            objects.send(*(marker("o/%d" % k, Marker.SPHERE_LIST, (0.1, 0.1, 0.1),
                                  Pose((0.7 + 0.001 * k, 0, 0)), points=[(0, 0, 0), (0, 0, 1)] * 20)
                           for k in range(100)))
            distances.wait(lambda m: len(m.distances) > 100, "all")
            objects.clear()
            distances.wait_newest(lambda m: not m.distances, "none")
            distances.subscriber.unregister()
            if i == 9:
                before = resident_bytes(node.pid)
        if SANITIZED:
            print("skipped: a sanitizer keeps the memory of objects that are gone")
            return
        wait_for(lambda: resident_bytes(node.pid) < before + KEPT, "no more than before")

    def test_end_while_distances_are_computed(self):
        path = self.folder / "slivers.stl"
        write_slivers(path, SLIVERS)
        node = self.start(mesh_robot(path), distance_limit=1.0)
        distances = self.listen(node)
        mover = Repeater(100.0, lambda: self.place(0.5))
        self.addCleanup(mover.stop)
        distances.wait(lambda m: m.distances, "computing")
        node.interrupt(signal.SIGINT)
        self.assertEqual(node.wait(PROMPT), 0, node.output)


if __name__ == "__main__":
    rospy.init_node("distance_faults_test")
    rostest.rosrun("link_bounds", "distance_faults", DistanceFaults)
