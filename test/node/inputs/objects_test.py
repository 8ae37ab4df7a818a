#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects appear, move, deform, are refused and go; groups and markers follow."""
import math
import re
import unittest

import rospy
import rostest
from bounds_testing import (NodeLog, Pose, Recorder, box_of, latched, load, names_of, transform,
                            turn, union, wait_for)
from link_bounds.msg import BoxOverlapArray
from node_testing import (ALL, ARMS, NODE, ArmsTf, Diagnostics, Repeater, arm_bounds, joint_pose,
                          value_of)
from object_testing import ObjectSender, deletion, ellipsoid_bounds, marker, shows_box
from rosgraph_msgs.msg import Log
from visualization_msgs.msg import Marker, MarkerArray

TURNED = Pose((1, 2, 3), turn((1, 2, 3), 30))
SIZE = (0.2, 0.3, 0.4)
POINTS = [(0, 0, 0), (0.5, 0, 0.1), (0, 0.7, -0.2), (0.3, 0.2, 0.9), (0.1, 0.8, 0.4),
          (0.6, 0.5, 0.3)]


def swept(pose, bounds_of):
    """The bounds of a solid at all points, with the rotation of the pose."""
    return union([bounds_of(Pose(pose.moved(p), pose.xyzw)) for p in POINTS])


class Objects(unittest.TestCase):
    newest = rospy.Time(1000)

    @classmethod
    def setUpClass(cls):
        cls.tf = ArmsTf()
        cls.objects = ObjectSender(NODE)
        cls.boxes = Recorder(NODE + "/boxes")

    def setUp(self):
        load(NODE, ARMS, fixed_frame="base")
        self.move(0)
        self.boxes.clear()

    def tearDown(self):
        self.objects.clear()
        self.boxes.wait_newest(lambda m: not [n for n in names_of(m) + m.incomplete if "/" in n],
                               "no object")

    def move(self, degrees, seconds=1):
        Objects.newest += rospy.Duration(seconds)
        self.tf.send(self.newest, degrees)
        return self.newest

    def expect(self, name, bounds):
        return self.boxes.wait(lambda m: shows_box(m, name, bounds), "box of " + name)

    def expect_incomplete(self, name):
        return self.boxes.wait(
            lambda m: name in m.incomplete and not box_of(m, name), name + " without a box")

    def test_each_kind_is_bounded_as_it_is_drawn(self):
        cube = lambda pose: pose.box_bounds(SIZE)  # noqa: E731
        ball = lambda d: lambda pose: ellipsoid_bounds(pose, (d, d, d))  # noqa: E731
        scaled = [[c * s for c, s in zip(p, SIZE)] for p in POINTS]
        arrow_tip = TURNED.moved((SIZE[0], 0, 0))
        cases = [
            (Marker.CUBE, (), cube(TURNED)),
            (Marker.SPHERE, (), ellipsoid_bounds(TURNED, SIZE)),
            (Marker.CUBE_LIST, POINTS, swept(TURNED, cube)),
            (Marker.SPHERE_LIST, POINTS, swept(TURNED, lambda p: ellipsoid_bounds(p, SIZE))),
            (Marker.LINE_STRIP, POINTS, swept(TURNED, ball(SIZE[0]))),
            (Marker.LINE_LIST, POINTS, swept(TURNED, ball(SIZE[0]))),
            (Marker.POINTS, POINTS, swept(TURNED, ball(math.hypot(SIZE[0], SIZE[1])))),
            (Marker.TRIANGLE_LIST, POINTS, TURNED.bounds(scaled)),
        ]
        self.objects.send(*(marker("kind/%d" % kind, kind, SIZE, TURNED, points=points)
                            for kind, points, _ in cases))
        for kind, _, bounds in cases:
            self.expect("kind/%d" % kind, bounds)
        self.objects.send_alone(marker("kind/0", Marker.ARROW, SIZE, TURNED))
        message = self.boxes.wait(lambda m: box_of(m, "kind/0"), "the arrow")
        box = box_of(message, "kind/0")
        for tip, low, high in zip(arrow_tip, (box.min.x, box.min.y, box.min.z),
                                  (box.max.x, box.max.y, box.max.z)):
            self.assertTrue(low <= tip <= high)

    def test_links_first_then_objects_by_namespace_and_number(self):
        self.objects.send(*(marker(name) for name in ("b/2", "b/10", "a/3", "/7", "b/-1")))
        self.boxes.wait(
            lambda m: names_of(m) == ALL + ["/7", "a/3", "b/-1", "b/2", "b/10"], "the order")

    def test_groups_and_markers_follow(self):
        load(NODE, ARMS, fixed_frame="base",
             groups={"held": ["right", "scene/1"], "scene": ["scene/*"], "void": ["void/*"]})
        groups = Recorder(NODE + "/groups")
        markers = Recorder(NODE + "/markers", MarkerArray)
        groups.wait(lambda m: m.incomplete == ["held"] and not box_of(m, "scene"), "no object yet")
        self.objects.send(marker("scene/1", scale=SIZE, pose=TURNED),
                          marker("scene/2", scale=SIZE, pose=Pose((-1, 0, 0))))
        first, second = TURNED.box_bounds(SIZE), Pose((-1, 0, 0)).box_bounds(SIZE)
        groups.wait(lambda m: not m.incomplete and shows_box(m, "scene", union([first, second])) and
                    shows_box(m, "held", union([first, arm_bounds("right", 0)])), "both groups")
        self.assertIsNone(box_of(latched(NODE + "/groups"), "void"))
        markers.wait(lambda m: {n.ns for n in m.markers if n.action == Marker.ADD} >= {
            "link_bounds/objects/scene/1", "link_bounds/objects/scene/2"}, "objects drawn")
        self.objects.send_alone(deletion("scene/1"))
        groups.wait(lambda m: m.incomplete == ["held"] and shows_box(m, "scene", second),
                    "one left")
        markers.wait(lambda m: [n for n in m.markers if n.action == Marker.DELETE and
                                n.ns == "link_bounds/objects/scene/1"], "the drawing deleted")
        groups.subscriber.unregister()
        markers.subscriber.unregister()

    def test_replaced_deleted_and_ignored(self):
        other = ObjectSender(NODE)
        self.objects.send(marker("a/1", scale=SIZE), marker("b/1", scale=SIZE))
        self.expect("b/1", Pose().box_bounds(SIZE))
        other.send(marker("a/1", Marker.SPHERE, SIZE, TURNED),
                   marker("link_bounds/objects/a/1", scale=SIZE), marker("link_bounds/x/1"))
        self.expect("a/1", ellipsoid_bounds(TURNED, SIZE))
        other.send(deletion("a/1"), deletion("a/2"))
        message = self.boxes.wait(lambda m: not box_of(m, "a/1") and box_of(m, "b/1"), "a/1 gone")
        self.assertEqual(names_of(message), ALL + ["b/1"])
        other.send_alone(marker("b/1", Marker.TEXT_VIEW_FACING, text="now a text"))
        self.boxes.wait_newest(lambda m: names_of(m) == ALL, "no box for a text")
        self.objects.send(marker("a/1"), marker("c/1"))
        self.boxes.wait(lambda m: names_of(m) == ALL + ["a/1", "c/1"], "back")
        other.clear()
        self.boxes.wait_newest(lambda m: names_of(m) == ALL and not m.incomplete, "all deleted")

    def test_a_sheet_deforms(self):
        for step in range(20):
            wave = [(x / 4, y / 4, 0.1 * math.sin(x + 0.3 * step + 0.1)) for x in range(4)
                    for y in range(3)]
            self.objects.send_alone(marker("sheet/1", Marker.TRIANGLE_LIST, (1, 1, 1), TURNED,
                                           points=wave))
            self.expect("sheet/1", TURNED.bounds(wave))
        flat = [(0, 0, 0.25), (1, 0, 0.25), (0, 1, 0.25)]
        self.objects.send_alone(marker("sheet/1", Marker.TRIANGLE_LIST, points=flat))
        message = self.expect("sheet/1", Pose().bounds(flat))
        box = box_of(message, "sheet/1")
        self.assertLess(box.max.z - box.min.z, 1e-12)

    def test_refused_with_a_reason_and_named(self):
        log = NodeLog(NODE)
        log.connect()
        self.objects.send(marker("bad/1", scale=SIZE), marker("bad/2", scale=SIZE))
        self.expect("bad/2", Pose().box_bounds(SIZE))
        begin = log.settle()
        self.objects.send(
            marker("bad/1", scale=(math.nan, 1, 1)), marker("bad/3", frame=""),
            marker("bad/4", scale=(1, -1, 1)),
            marker("bad/5", Marker.TRIANGLE_LIST, points=POINTS[:2]),
            marker("bad/6", Marker.POINTS), marker("bad/7", Marker.MESH_RESOURCE),
            marker("bad/8", kind=77), marker("bad/9", pose=Pose((math.inf, 0, 0))))
        bad = ["bad/%d" % i for i in (1, 3, 4, 5, 6, 7, 8, 9)]
        self.boxes.wait(lambda m: m.incomplete == bad and names_of(m) == ALL + ["bad/2"],
                        "each of the bad ones named")
        errors = log.lines(Log.ERROR, begin, log.settle())
        for name in bad:
            about = [line for line in errors if '"%s"' % name in line]
            self.assertEqual(len(about), 1, errors)
            self.assertIn(rospy.get_name(), about[0])
        self.assertEqual(len(errors), len(bad), errors)
        self.objects.send(marker("bad/1", scale=SIZE), deletion("bad/3"))
        self.boxes.wait(lambda m: m.incomplete == bad[2:] and box_of(m, "bad/1"), "mended")

    def test_follows_its_frame_or_stays_where_it_was(self):
        hand = Pose((0, 0, 0.1), turn((1, 1, 0), 45))
        start = self.move(30)
        self.objects.send(marker("held/1", scale=SIZE, pose=hand, frame="right"),
                          marker("held/2", scale=SIZE, pose=hand, frame="/right", stamp=start,
                                 frame_locked=True),
                          marker("left/3", scale=SIZE, pose=hand, frame="right", stamp=start))
        at_30 = (joint_pose("right", 30) * hand).box_bounds(SIZE)
        at_45 = (joint_pose("right", 45) * hand).box_bounds(SIZE)
        for name in ("held/1", "held/2", "left/3"):
            self.expect(name, at_30)
        self.boxes.clear()
        stamp = self.move(45)
        message = self.expect("held/1", at_45)
        self.assertTrue(shows_box(message, "held/2", at_45))
        self.assertTrue(shows_box(message, "left/3", at_30))
        self.assertEqual(box_of(message, "held/1").stamp, stamp)
        self.assertEqual(box_of(message, "left/3").stamp, start)

    def test_a_new_fixed_frame_carries_over_what_was_placed_once(self):
        start = self.move(0)
        cube = dict(scale=(1, 1, 1), pose=Pose((2, 0, 0)))
        self.objects.send(marker("scene/1", stamp=start, **cube), marker("scene/2", **cube))
        in_base = Pose((2, 0, 0)).box_bounds((1, 1, 1))
        in_odom = Pose((102, 0, 0)).box_bounds((1, 1, 1))
        self.expect("scene/1", in_base)
        for _ in range(12):  # longer than tf remembers
            stamp = self.move(0)
            self.tf.send_transforms(transform("odom", "base", stamp, (100, 0, 0)))
        groups = Recorder(NODE + "/groups")
        markers = Recorder(NODE + "/markers", MarkerArray)
        overlaps = Recorder(NODE + "/overlaps", BoxOverlapArray)
        self.boxes.wait(lambda m: box_of(m, "left") and box_of(m, "left").stamp == stamp, "tf")
        load(NODE, fixed_frame="odom", groups={"scene": ["scene/*"]})
        self.boxes.wait(
            lambda m: m.header.frame_id == "odom" and shows_box(m, "scene/1", in_odom) and
            shows_box(m, "scene/2", in_odom), "both in odom")
        groups.wait(lambda m: shows_box(m, "scene", in_odom), "the group")
        overlaps.wait(lambda m: m.header.frame_id == "odom" and
                      ("scene/1", "scene/2") in [(o.first, o.second) for o in m.overlaps], "a pair")
        markers.wait(lambda m: [n for n in m.markers if n.ns == "link_bounds/objects/scene/1" and
                                n.header.frame_id == "odom" and n.pose.position.x == 102], "a cube")
        for message in self.boxes.messages:
            if message.header.frame_id == "odom" and box_of(message, "scene/1"):
                self.assertTrue(shows_box(message, "scene/1", in_odom), "numbers of base")
        for recorder in (groups, markers, overlaps):
            recorder.subscriber.unregister()
        self.boxes.clear()
        load(NODE, fixed_frame="base")
        self.expect("scene/1", in_base)

    def test_without_a_transform_to_the_new_fixed_frame_there_is_no_box(self):
        diagnostics = Diagnostics()
        start = self.move(0)
        self.objects.send(marker("scene/1", stamp=start, scale=SIZE))
        self.expect("scene/1", Pose().box_bounds(SIZE))
        self.boxes.clear()
        load(NODE, fixed_frame="island", timeout=0.5)
        self.expect_incomplete("scene/1")
        status = diagnostics.wait_for_new(
            lambda _, s: value_of(s, "incomplete: scene/1"), "the reason")
        self.assertIn('"base"', value_of(status, "incomplete: scene/1"))
        self.tf.send_transforms(transform("island", "base", self.move(0), (7, 0, 0)))
        self.expect("scene/1", Pose((7, 0, 0)).box_bounds(SIZE))
        in_island = [m for m in self.boxes.messages if m.header.frame_id == "island"]
        self.assertTrue(all(shows_box(m, "scene/1", Pose((7, 0, 0)).box_bounds(SIZE))
                            for m in in_island if box_of(m, "scene/1")))

    def test_waits_for_the_transform_at_its_stamp(self):
        start = self.move(30)
        self.objects.send(marker("seen/1", scale=SIZE, frame="right",
                                 stamp=start + rospy.Duration(0.5)))
        self.expect_incomplete("seen/1")
        self.move(30)
        self.expect("seen/1", joint_pose("right", 30).box_bounds(SIZE))

    def test_a_transform_that_never_comes_is_given_up(self):
        log = NodeLog(NODE)
        log.connect()
        load(NODE, ARMS, fixed_frame="base", timeout=0.5)
        self.objects.send(marker("lost/1", frame="nowhere", stamp=rospy.Time(1)))
        self.expect_incomplete("lost/1")
        log.wait(lambda m: "lost/1" in m.msg and "nowhere" in m.msg and m.level == Log.WARN,
                 "a warning")
        self.assertIn("lost/1", latched(NODE + "/boxes").incomplete)
        self.assertEqual(len([m for m in log.messages[:log.settle()] if "lost/1" in m.msg]), 1)

    def test_stamps_that_stay_ahead_of_tf_are_warned_of(self):
        log = NodeLog(NODE)
        log.connect()
        load(NODE, ARMS, fixed_frame="base", timeout=0.5)

        sender = Repeater(20, lambda: self.objects.send(marker(
            "early/1", frame="right", stamp=self.move(30, 0.01) + rospy.Duration(5))))
        try:
            # A marker may be looked at before or after many of the transforms beside it.
            warning = re.compile(r'[3-6](\.\d+)? s ahead of the newest transform from "right"')
            log.wait(lambda m: "early/1" in m.msg and m.level == Log.WARN and
                     warning.search(m.msg) and all(
                         text in m.msg for text in (rospy.get_name(), "clocks", "stamp 0")),
                     "a warning")
        finally:
            sender.stop()
        self.expect_incomplete("early/1")
        self.objects.clear()
        self.assertEqual(len([m for m in log.messages[:log.settle()] if "early/1" in m.msg]), 1)

    def test_lifetime(self):
        self.objects.send(marker("brief/1", lifetime=rospy.Duration(0.3)), marker("stays/1"))
        self.boxes.wait(lambda m: box_of(m, "brief/1") and box_of(m, "stays/1"), "both")
        self.boxes.wait(lambda m: not box_of(m, "brief/1") and box_of(m, "stays/1") and
                        "brief/1" not in m.incomplete, "one gone")

    def test_an_unknown_action_is_refused(self):
        log = NodeLog(NODE)
        log.connect()
        self.objects.send(marker("odd/1"))
        self.boxes.wait(lambda m: box_of(m, "odd/1"), "its box")
        unknown_action = marker("odd/1")
        unknown_action.action = 77
        self.objects.send(unknown_action)
        self.expect_incomplete("odd/1")
        log.wait(lambda m: '"odd/1"' in m.msg and "action 77" in m.msg, "the reason")
        self.boxes.clear()
        self.objects.send(marker("odd/1"))
        self.boxes.wait(lambda m: box_of(m, "odd/1") and not m.incomplete, "mended")

    def test_a_refused_marker_has_its_lifetime(self):
        self.objects.send(marker("brief/1", scale=(math.nan, 1, 1), lifetime=rospy.Duration(0.3)))
        self.expect_incomplete("brief/1")
        wait_for(lambda: "brief/1" not in self.boxes.messages[-1].incomplete, "no name left")

    def test_diagnostics_count_objects(self):
        diagnostics = Diagnostics()
        self.objects.send(marker("a/1"), marker("a/2", frame="nowhere"))
        self.expect_incomplete("a/2")
        status = diagnostics.wait_for_new(
            lambda _, s: "1 objects incomplete" in s.message, "one object incomplete")
        values = {pair.key: pair.value for pair in status.values}
        self.assertEqual(values["objects"], "2")
        self.assertIn("nowhere", values["incomplete: a/2"])


if __name__ == "__main__":
    rospy.init_node("objects_test")
    rostest.rosrun("link_bounds", "objects", Objects)
