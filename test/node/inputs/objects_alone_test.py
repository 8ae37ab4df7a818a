#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects without robot and tf; neighbours; meshes; 10,000 objects, and the memory after them."""
import pathlib
import shutil
import tempfile
import unittest

import rospy
import rostest
from bad_inputs import bad_robots
from binary_stl import binary_stl
from bounds_testing import (Pose, Recorder, box_link, box_of, corners_of, difference, names_of,
                            robot, turn, wait_for)
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray, BoxOverlapArray
from node_testing import ARMS, SANITIZED, Diagnostics, NodeProcess, resident_bytes
from object_testing import TOLERANCE, ObjectSender, ellipsoid_bounds, marker, shows_box
from std_msgs.msg import Header
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker

TURNED = Pose((1, 2, 3), turn((3, 2, 1), 45))
MANY = 10000
ROUNDS = 3
BROKEN = [*(bad_robots.UNUSABLE[name] for name in (
    "empty", "no_xml", "loop_beside_the_tree", "two_parents", "two_roots")), (5, "not a string")]
REFUSED = "waiting for another robot_description"
MEBIBYTE = 1 << 20
KEPT = 3 * MEBIBYTE  # that the C library and buffers may keep of the memory of many objects


def write_tetrahedron(path, size):
    """A binary STL; returns its corners."""
    corners = [(0, 0, 0), (size, 0, 0), (0, size, 0), (0, 0, size)]
    faces = [[corners[i] for i in range(4) if i != left_out] for left_out in range(4)]
    path.write_bytes(binary_stl(faces))
    return corners


class ObjectsAlone(unittest.TestCase):
    def setUp(self):
        self.node = NodeProcess("objects_" + self._testMethodName, fixed_frame="map")
        self.addCleanup(self.node.end)
        self.boxes = Recorder(self.node.name + "/boxes")
        self.addCleanup(self.boxes.subscriber.unregister)
        self.objects = ObjectSender(self.node.name)
        self.boxes.wait(lambda m: m.header.frame_id == "map" and not m.boxes, "an empty array")

    def expect(self, name, bounds):
        return self.boxes.wait(lambda m: shows_box(m, name, bounds), "box of " + name)

    def reload(self):
        return rospy.ServiceProxy(self.node.name + "/reload", Trigger)()

    def test_without_robot_and_tf(self):
        diagnostics = Diagnostics(self.node.name)
        self.objects.send(marker("a/1", Marker.SPHERE, (1, 2, 3), TURNED, "map"),
                          marker("a/2", frame="elsewhere"))
        message = self.expect("a/1", ellipsoid_bounds(TURNED, (1, 2, 3)))
        self.assertEqual(message.incomplete, ["a/2"])
        status = diagnostics.wait_for_new(lambda _, s: "1 objects" in s.message, "a status")
        self.assertEqual(status.level, DiagnosticStatus.WARN)
        self.assertIn("waiting for robot_description", status.message)
        rospy.set_param("/robot_description", ARMS)
        self.addCleanup(rospy.delete_param, "/robot_description")
        self.boxes.wait(lambda m: "base" in m.incomplete and names_of(m) == ["a/1"],
                        "the robot's links are known")

    def test_neighbours(self):
        topic = self.node.name + "/neighbours"
        sender = rospy.Publisher(topic, AxisAlignedBoxArray, queue_size=10, latch=True)
        overlaps = Recorder(self.node.name + "/overlaps", BoxOverlapArray)
        self.addCleanup(overlaps.subscriber.unregister)
        box = AxisAlignedBox("arm", rospy.Time(), Point(-1, -2, -3), Point(1, 2, 3))
        sender.publish(AxisAlignedBoxArray(Header(frame_id="map"), [box], ["hand"]))
        name = rospy.get_name() + "/arm"
        message = self.expect(name, [-1, -2, -3, 1, 2, 3])
        self.assertEqual(message.incomplete, [rospy.get_name() + "/hand"])
        self.objects.send(marker("a/1", frame="map"))
        overlaps.wait(lambda m: [(pair.first, pair.second) for pair in m.overlaps] ==
                      [(name, "a/1")], "the neighbour's box and the marker overlap")

    def test_own_boxes_are_no_neighbours(self):
        node = NodeProcess("echo", ["~neighbours:=~boxes"], fixed_frame="map")
        self.addCleanup(node.end)
        wait_for(lambda: "~neighbours also carries the boxes of this node itself" in node.output,
                 "a warning")
        boxes = Recorder(node.name + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        ObjectSender(node.name).send(marker("a/1", frame="map"))
        ObjectSender(node.name).send(marker("a/2", frame="map"))
        message = boxes.wait(lambda m: box_of(m, "a/2"), "a box")
        self.assertEqual(names_of(message), ["a/1", "a/2"])

    def test_broken_descriptions_are_named_once_and_objects_stay(self):
        unit = Pose().box_bounds((1, 1, 1))
        diagnostics = Diagnostics(self.node.name)
        self.addCleanup(rospy.delete_param, "/robot_description")
        for i, (broken, reason) in enumerate(BROKEN):
            rospy.set_param("/robot_description", broken)
            wait_for(lambda n=i + 1: self.node.output.count(REFUSED) == n, reason)
            for _ in range(2):  # statuses: in a second the node looks at the description five times
                status = diagnostics.wait_for_new(lambda *_: True, "a status")
            self.assertEqual(self.node.output.count(REFUSED), i + 1, self.node.output)
            self.assertIn(reason, self.node.output)
            self.assertIn("waiting for robot_description", status.message)
            self.objects.send(marker("a/%d" % i, frame="map"))
            self.expect("a/%d" % i, unit)
            answer = self.reload()
            self.assertFalse(answer.success)
            self.assertIn(reason, answer.message)
        rospy.set_param("/robot_description", robot([box_link("map", (1, 1, 1))], []))
        message = self.expect("map", unit)
        self.assertEqual(names_of(message), ["map"] + ["a/%d" % i for i in range(len(BROKEN))])

    def test_a_failed_reload_keeps_the_old_parameters(self):
        rospy.set_param(self.node.name + "/fixed_frame", "")
        rospy.set_param(self.node.name + "/padding", 0.5)
        self.assertIn("robot_description", self.reload().message)
        rospy.set_param("/robot_description", robot([box_link("map", (1, 1, 1))], []))
        self.addCleanup(rospy.delete_param, "/robot_description")
        message = self.boxes.wait(lambda m: box_of(m, "map"), "the robot")
        self.assertLess(difference(corners_of(box_of(message, "map")),
                                   Pose().box_bounds((1, 1, 1))), TOLERANCE)

    def test_a_failed_reload_refuses_no_description(self):
        """The old parameters stay, and with these the robot can be loaded."""
        rospy.set_param(self.node.name + "/ignore_pairs", ["one two three"])
        rospy.set_param("/robot_description", robot([box_link("map", (1, 1, 1))], []))
        self.addCleanup(rospy.delete_param, "/robot_description")
        self.assertIn("ignore_pairs", self.reload().message)
        self.boxes.wait(lambda m: box_of(m, "map"), "the robot")

    def test_meshes(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        path = folder / "body.stl"
        corners = write_tetrahedron(path, 0.5)
        body = dict(kind=Marker.MESH_RESOURCE, frame="map", mesh_resource="file://%s" % path)
        first = marker("body/1", pose=TURNED, scale=(1, 2, 3), **body)
        bounds = TURNED.bounds([(x, 2 * y, 3 * z) for x, y, z in corners])
        self.objects.send(first)
        self.expect("body/1", bounds)
        path.unlink()
        self.boxes.clear()
        self.objects.send(first, marker("body/2", **body), marker("end/1", frame="map"))
        message = self.expect("body/2", Pose().bounds(corners))
        self.assertTrue(shows_box(message, "body/1", bounds), "nothing is read again")
        self.assertFalse(message.incomplete)
        missing, broken = folder / "missing.stl", folder / "broken.stl"
        broken.write_text("no mesh")
        self.objects.send(*(marker(name, Marker.MESH_RESOURCE, frame="map",
                                   mesh_resource="file://%s" % file)
                            for name, file in (("body/2", missing), ("body/3", broken))))
        self.boxes.wait(lambda m: m.incomplete == ["body/2", "body/3"] and
                        names_of(m) == ["body/1", "end/1"], "both named")
        wait_for(lambda: all(str(file) in self.node.output for file in (missing, broken)),
                 "errors with the names of the files")
        repaired = Pose().bounds(write_tetrahedron(missing, 0.25))
        write_tetrahedron(broken, 0.25)
        write_tetrahedron(path, 0.5)
        self.assertTrue(self.reload().success)
        self.expect("body/2", repaired)
        self.expect("body/3", repaired)
        for file in (missing, broken):
            lines = [line for line in self.node.output.splitlines() if str(file) in line]
            self.assertEqual(len([line for line in lines if "ERROR" in line]), 1, lines)
        self.boxes.wait_newest(lambda m: not m.incomplete and shows_box(m, "body/1", bounds),
                               "no fault")
        self.boxes.clear()
        corners = write_tetrahedron(path, 0.75)
        self.assertTrue(self.reload().success)
        changed = TURNED.bounds([(x, 2 * y, 3 * z) for x, y, z in corners])
        message = self.boxes.wait(lambda m: "body/1" in m.incomplete, "the file is another one")
        self.assertLess(difference(corners_of(box_of(message, "body/1")), bounds), TOLERANCE)
        self.expect("body/1", changed)
        self.assertFalse([name for m in self.boxes.messages for name in m.incomplete
                          if name != "body/1"], "the others are as they were")

    def test_very_many_and_the_memory_after(self):
        before = resident_bytes(self.node.pid)
        for step in range(ROUNDS):
            poses = [Pose((i * 0.1, step, 0), turn((1, 1, 1), 30)) for i in range(MANY)]
            markers = [marker("many/%d" % i, scale=(0.1, 0.2, 0.3), pose=pose, frame="map")
                       for i, pose in enumerate(poses)]
            for begin in range(0, MANY, MANY // 10):
                self.objects.send(*markers[begin:begin + MANY // 10])
            message = self.boxes.wait(lambda m: len(m.boxes) == MANY and not m.incomplete, "all")
            for i in (0, 1, MANY // 2, MANY - 1):
                self.assertTrue(shows_box(message, "many/%d" % i,
                                          poses[i].box_bounds((0.1, 0.2, 0.3))))
            full = resident_bytes(self.node.pid)
            self.assertGreater(full, before + KEPT)
            self.boxes.clear()
            self.objects.clear()
            self.boxes.wait(lambda m: not m.boxes, "none left")
            if SANITIZED:
                print("skipped: a sanitizer keeps the memory of objects that are gone")
                continue
            wait_for(lambda: resident_bytes(self.node.pid) < before + KEPT, "the memory is back")
            print("memory [MiB]: %.1f before, %.1f with %d objects, %.1f after" % (
                before / MEBIBYTE, full / MEBIBYTE, MANY,
                resident_bytes(self.node.pid) / MEBIBYTE))


if __name__ == "__main__":
    rospy.init_node("objects_alone_test")
    rostest.rosrun("link_bounds", "objects_alone", ObjectsAlone)
