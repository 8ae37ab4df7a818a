#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~check_path: trajectories beside the robot itself, objects, carried ones and neighbours; joints
that rest where tf has them; what it refuses; and many points beside ~boxes."""
import math
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from binary_stl import binary_stl
from bounds_testing import (DEADLINE, Pose, Recorder, TfSender, box_link, load, names_of,
                            transform, turn)
from dying_client import DyingClient
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray, PathSegment
from link_bounds.srv import CheckPath, CheckPathRequest
from node_testing import NODE, SANITIZED, Repeater
from object_testing import ObjectSender, deletion, marker
from page_testing import code_block
from patience import PATIENCE
from std_msgs.msg import Header
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from visualization_msgs.msg import Marker

# Seen from above: a bar of 1 m turns about the origin, and slides out along itself by `push`; a
# second bar of 1 m turns about (2.5, 0). A pointer follows the first one at half the angle, higher.
HEAD = '<limit lower="-3" upper="3" effort="1" velocity="1"/>'


def joint(name, kind, parent, child, x, extra=""):
    return ('<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>'
            '<origin xyz="%g 0 0"/>%s%s</joint>' % (name, kind, parent, child, x, HEAD, extra))


BARS = '<robot name="bars">%s%s</robot>' % (
    "".join(box_link(name, (0.2, 0.2, 0.2)) for name in ("base", "rest")) +
    "".join(box_link(name, (0.7, 0.1, 0.1), (0.65, 0, 0)) for name in ("bar", "other")) +
    box_link("pointer", (0.7, 0.1, 0.1), (0.65, 0, 1)) + '<link name="hub"/>',
    joint("turn", "revolute", "base", "hub", 0, '<axis xyz="0 0 1"/>') +
    joint("push", "prismatic", "hub", "bar", 0, '<axis xyz="1 0 0"/>') +
    joint("half", "revolute", "base", "pointer", 0,
          '<axis xyz="0 0 1"/><mimic joint="turn" multiplier="0.5"/>') +
    joint("lean", "revolute", "base", "other", 2.5, '<axis xyz="0 0 1"/>') +
    '<joint name="aside" type="floating"><parent link="base"/><child link="rest"/></joint>')
SAFE, COLLIDES, UNDECIDED = PathSegment.SAFE, PathSegment.COLLIDES, PathSegment.UNDECIDED
POST = (0.05, 0.05, 0.5)
LONG = 20000  # points, the most that are allowed
SLOW = PATIENCE * (5 if SANITIZED else 1)


def post(name, degrees, radius=0.8, **fields):
    angle = math.radians(degrees)
    return marker(name, scale=POST, pose=Pose((radius * math.cos(angle), radius * math.sin(angle),
                                               0)), **fields)


def trajectory(names, *points, velocities=()):
    message = JointTrajectory(joint_names=list(names))
    for i, positions in enumerate(points):
        point = JointTrajectoryPoint(positions=list(positions))
        point.time_from_start = rospy.Duration(i)
        if velocities:
            point.velocities = list(velocities[i])
        message.points.append(point)
    return message


def turned(*degrees):
    return trajectory(["turn"], *([math.radians(angle)] for angle in degrees))


class CheckPathTest(unittest.TestCase):
    now = 1000

    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.objects = ObjectSender(NODE)
        rospy.wait_for_service(NODE + "/check_path", DEADLINE)
        cls.call = rospy.ServiceProxy(NODE + "/check_path", CheckPath, persistent=True)

    def setUp(self):
        load(NODE, BARS)
        self.clear_objects()
        self.send_robot()

    def clear_objects(self):
        self.objects.clear()
        self.boxes.wait_newest(lambda m: not any("/" in name for name in names_of(m)), "none")

    def send_robot(self, angle=0, push=0, lean=0, aside=0, without=()):
        """Returns once ~boxes shows it."""
        type(self).now += 1
        stamp = rospy.Time(self.now)
        links = [transform("base", "hub", stamp, (aside, 0, 0), turn((0, 0, 1), angle)),
                 transform("hub", "bar", stamp, (push, 0, 0)),
                 transform("base", "pointer", stamp, (0, 0, 0), turn((0, 0, 1), angle / 2)),
                 transform("base", "other", stamp, (2.5, 0, 0), turn((0, 0, 1), lean)),
                 transform("base", "rest", stamp, (-3, 0, 0))]
        self.tf.send(*(link for link in links if link.child_frame_id not in without))
        self.boxes.wait_newest(lambda m: m.header.stamp == stamp, "the robot")

    def send_objects(self, *markers):
        self.objects.send(*markers)
        names = {"%s/%d" % (m.ns, m.id) for m in markers}
        self.boxes.wait_newest(
            lambda m: names <= set(names_of(m)) | set(m.incomplete), "the objects")

    def check(self, path, clearance=0.0):
        answer = self.call(CheckPathRequest(trajectory=path, clearance=clearance))
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(len(answer.segments), len(path.points) - 1)
        for i, segment in enumerate(answer.segments):
            self.assertEqual(segment.start, i)
            self.assertLessEqual(segment.clearance, segment.nearest)
        undecided = [s for s in answer.segments if s.verdict == UNDECIDED]
        self.assertEqual(answer.message == "", not undecided, answer.message)
        return answer

    def verdict(self, path, clearance=0.0):
        segment, = self.check(path, clearance).segments
        return segment.verdict

    def check_contact(self, path, first, second):
        segment, = self.check(path).segments
        self.assertEqual((segment.verdict, segment.first, segment.second),
                         (COLLIDES, first, second))
        return segment

    def test_an_object_between_two_points(self):
        self.send_objects(post("post/1", 45))
        answer = self.check(turned(0, 90, 180))
        self.assertEqual([s.verdict for s in answer.segments], [COLLIDES, SAFE])
        self.assertEqual((answer.joint_names, answer.incomplete), (["turn"], []))
        hit, safe = answer.segments
        self.assertEqual((hit.first, hit.second), ("bar", "post/1"))
        self.assertAlmostEqual(hit.at, 0.5, delta=0.06)
        self.assertAlmostEqual(hit.pose[0], math.radians(90 * hit.at), delta=1e-12)
        # From the bar to a corner of the base.
        expected = 0.3 - math.hypot(0.1, 0.1)
        self.assertAlmostEqual(safe.nearest, expected, delta=0.001)
        self.assertAlmostEqual(safe.clearance, expected, delta=0.011)
        self.assertEqual(self.verdict(turned(90, 180), clearance=1.5), COLLIDES)
        self.clear_objects()
        self.send_objects(post("post/2", 45, 1.2))
        answer = self.check(turned(0, 90))
        self.assertEqual(answer.segments[0].verdict, SAFE)
        # The end of the bar is at 1 m, the post begins at 1.2 m less half its width.
        self.assertAlmostEqual(answer.segments[0].nearest, 0.17, delta=0.02)

    def test_joints_that_are_not_in_it_rest_where_tf_has_them(self):
        self.send_objects(post("post/1", 45, 1.2))
        self.assertEqual(self.verdict(turned(0, 90)), SAFE)
        self.send_robot(push=0.4)
        self.check_contact(turned(0, 90), "bar", "post/1")
        self.clear_objects()
        self.send_robot(push=0.8)
        self.assertEqual(self.verdict(turned(-60, 60)), SAFE)
        self.send_robot(push=0.8, lean=180)
        self.check_contact(turned(-60, 60), "bar", "other")

    def test_joints_that_follow(self):
        """Half the angle, one metre higher."""
        high = post("post/1", 45)
        high.pose.position.z = 1
        self.send_objects(high)
        self.assertEqual(self.verdict(turned(0, 60)), SAFE)
        self.check_contact(turned(60, 120), "pointer", "post/1")
        both = trajectory(["half", "turn"], [9, math.radians(60)], [9, math.radians(120)])
        self.assertEqual(self.check(both).joint_names, ["turn"])
        self.check_contact(both, "pointer", "post/1")

    def test_what_a_link_carries_moves_with_it(self):
        self.send_objects(post("post/1", 45, 1.2),
                          marker("tool/1", scale=(0.3, 0.1, 0.1), pose=Pose((1.2, 0, 0)),
                                 frame="bar"))
        self.check_contact(turned(0, 90), "post/1", "tool/1")

    def test_what_was_placed_once_rests_unless_it_is_attached(self):
        tool = marker("tool/1", scale=(0.3, 0.1, 0.1), pose=Pose((1.1, 0, 0)), frame="base",
                      stamp=rospy.Time(self.now))
        self.send_objects(post("post/1", 45, 1.2), tool)
        self.check_contact(turned(0, 90), "bar", "tool/1")
        load(NODE, attached={"bar": ["tool/*"]})
        self.send_robot()
        self.send_objects(tool)
        self.send_robot()
        self.check_contact(turned(0, 90), "post/1", "tool/1")
        # Where it was on the link when it was placed counts, as long as tf knows that.
        self.send_robot(angle=40)
        self.check_contact(turned(30, 60), "post/1", "tool/1")
        for _ in range(12):
            self.send_robot(angle=40)
        answer = self.check(turned(30, 60))
        self.assertEqual((answer.segments[0].verdict, answer.incomplete), (UNDECIDED, ["tool/1"]))
        self.assertIn("let it follow a frame of that link", answer.message)

    def test_what_is_attached_to_one_link_and_follows_another(self):
        load(NODE, attached={"bar": ["tool/*"]})
        self.send_robot()
        self.send_objects(marker("tool/1", scale=(0.3, 0.1, 0.1), pose=Pose((-1, 2, 0)),
                                 frame="other"))
        answer = self.check(turned(0, 90))
        self.assertEqual((answer.segments[0].verdict, answer.incomplete), (UNDECIDED, ["tool/1"]))

    def test_fixed_joints_are_where_tf_has_them(self):
        load(NODE, BARS.replace('name="push" type="prismatic"', 'name="push" type="fixed"'))
        self.send_robot(push=0.4)
        self.send_objects(post("post/1", 45, 1.2))
        self.check_contact(turned(0, 90), "bar", "post/1")

    def test_a_transform_that_does_not_fit_a_joint(self):
        self.send_robot(aside=0.3)
        self.refuse('a transform does not fit joint "turn".*300', turned(0, 90))

    def test_a_joint_that_follows_one_at_rest(self):
        path = trajectory(["lean", "half"], [0, 0], [1, 1])
        self.assertEqual(self.check(path).joint_names, ["lean"])

    def test_boxes_of_a_neighbour(self):
        sender = rospy.Publisher(NODE + "/neighbours", AxisAlignedBoxArray, queue_size=1)
        message = AxisAlignedBoxArray(header=Header(frame_id="base"),
                                      boxes=[AxisAlignedBox(name="cart")])
        box = message.boxes[0]
        (box.min.x, box.min.y, box.min.z) = (0.5, 0.5, -0.1)
        (box.max.x, box.max.y, box.max.z) = (0.6, 0.6, 0.1)
        name = rospy.get_name() + "/cart"
        ticker = Repeater(20.0, lambda: sender.publish(message))
        try:
            self.boxes.wait_newest(lambda m: name in names_of(m), name)
            self.check_contact(turned(0, 90), "bar", name)
            message.boxes = []
            self.boxes.wait_newest(lambda m: name not in names_of(m), "none")
        finally:
            ticker.stop()

    def test_the_motion_is_that_of_the_controller(self):
        """With a speed the bar goes beyond both way points: by 4/27 of 3 rad, 25 degrees."""
        self.send_objects(post("post/1", 20))
        self.assertEqual(self.verdict(turned(0, 0)), SAFE)
        rest = trajectory(["turn"], [0], [0], velocities=([0], [0]))
        self.assertEqual(self.verdict(rest), SAFE)
        swing = trajectory(["turn"], [0], [0], velocities=([3], [0]))
        self.check_contact(swing, "bar", "post/1")

    def test_triangles_decide(self):
        """The bar passes between the two halves of one mesh."""
        with tempfile.NamedTemporaryFile(suffix=".stl") as file:
            file.write(binary_stl([((0.6, 0, 0.4), (0.8, 0, 0.4), (0.6, 0, 0.7)),
                                   ((0.6, 0, -0.4), (0.8, 0, -0.4), (0.6, 0, -0.7))]))
            file.flush()
            gate = marker("gate/1", Marker.MESH_RESOURCE, mesh_resource="file://" + file.name)
            self.send_objects(gate)
            self.boxes.wait_newest(lambda m: "gate/1" in names_of(m), "the gate")
            self.assertEqual(self.verdict(turned(-60, 60)), SAFE)
            gate.pose.position.z = -0.4
            self.send_objects(gate)
            self.boxes.wait_newest(
                lambda m: any(b.name == "gate/1" and b.max.z < 0.4 for b in m.boxes), "it moves")
            self.check_contact(turned(-60, 60), "bar", "gate/1")

    def test_the_example(self):
        example = {}
        exec(code_block("doc/scene.md", "## Paths", "python"), example)
        self.assertTrue(example["is_free"](turned(0, 90), 0.1))
        self.send_objects(post("post/1", 45))
        self.assertFalse(example["is_free"](turned(0, 90), 0))
        with self.assertRaisesRegex(ValueError, "two or more"):
            example["is_free"](turned(0), 0)

    def test_of_a_body_without_a_place_nothing_is_proven(self):
        self.send_objects(marker("lost/1", frame="nowhere"))
        answer = self.check(turned(0, 90))
        self.assertEqual((answer.segments[0].verdict, answer.incomplete), (UNDECIDED, ["lost/1"]))
        self.assertIn("lost/1: ", answer.message)
        self.send_objects(post("post/1", 45))
        self.check_contact(turned(0, 90), "bar", "post/1")

    def test_pairs_are_those_of_the_node(self):
        self.send_objects(post("post/1", 45))
        load(NODE, ignore_pairs=["bar post/*"])
        self.send_robot()
        self.assertEqual(self.verdict(turned(0, 90)), SAFE)
        self.clear_objects()
        load(NODE, links=["base", "rest"])
        segment, = self.check(turned(0, 90)).segments
        self.assertEqual((segment.verdict, list(segment.pose)), (UNDECIDED, []))

    def refuse(self, words, path, clearance=0.0):
        answer = self.call(CheckPathRequest(trajectory=path, clearance=clearance))
        self.assertFalse(answer.success)
        self.assertEqual((answer.segments, answer.incomplete), ([], []))
        self.assertRegex(answer.message, words)

    def test_what_is_no_path_is_refused(self):
        good = turned(0, 90)
        for words, path in (
                ("joint_names is empty", JointTrajectory()),
                ('"nobody" is no movable joint.*: aside.x .* lean turn push',
                 trajectory(["nobody"], [0], [1])),
                ('has "turn" twice', trajectory(["turn", "turn"], [0, 0], [1, 1])),
                ("all of .* follow other joints", trajectory(["half"], [0], [1])),
                (r'joint "aside" has more than one value; give aside.x, aside.y, .*aside.roll$',
                 trajectory(["aside"], [0], [1])),
                (r'values of joint "aside", but not all 6',
                 trajectory(["aside.x"], [0], [1])),
                (r"points has 1; a path needs two", turned(0)),
                (r"points has 0", trajectory(["turn"])),
                (r"points\[1\] has 2 positions, .* has 1 joint_names",
                 trajectory(["turn"], [0], [1, 2])),
                (r'positions of points\[1\]: that of joint "turn" is nan',
                 trajectory(["turn"], [0], [math.nan])),
                (r'velocities of points\[0\]: that of joint "turn" is -?inf',
                 trajectory(["turn"], [0], [1], velocities=([-math.inf], [0]))),
                ("more than 20000; send it in pieces",
                 turned(*[0] * (LONG + 1)))):
            self.refuse(words, path)
        for clearance in (-1e-9, math.nan, math.inf):
            self.refuse("clearance is .* must be a finite number, 0 or more", good, clearance)
        late = trajectory(["turn"], [0], [1], velocities=([0], [0]))
        late.points[1].time_from_start = rospy.Duration()
        self.refuse(r"time_from_start of points\[1\] is not after that of points\[0\]", late)
        self.refuse(r"the motion to points\[1\] is not finite",
                    trajectory(["turn"], [0], [1], velocities=([0], [1e308])))
        self.assertEqual(self.verdict(good), SAFE)

    def test_a_million_points_are_refused(self):
        path = turned(0)
        path.points = path.points * 10**6
        self.refuse("points, more than 20000|bytes, more than", path)

    def test_a_request_of_too_many_bytes_is_refused(self):
        self.refuse("the request has .* bytes, more than 33554432; send the trajectory in pieces",
                    trajectory(["x" * (33 << 20)], [0], [1]))

    def test_too_many_pairs_are_refused(self):
        """Two links move among more than 5,000 posts."""
        self.send_objects(*(post("far/%d" % i, 0.07 * i, 2) for i in range(5001)))
        self.refuse("moves more than 10000 pairs of bodies; leave some out", turned(0, 1))

    def test_a_joint_that_tf_does_not_know(self):
        robot = BARS.replace('"lean"', '"lean2"').replace('"other"', '"other2"')
        load(NODE, robot)
        self.send_robot()
        self.refuse('joint "lean2" is not in the trajectory.*"other2".*add the joint', turned(0, 1))
        self.assertEqual(self.verdict(trajectory(["turn", "lean2"], [0, 0], [1, 0])), SAFE)

    def test_many_points_beside_boxes(self):
        """What is not proven within the 10 s of a request is undecided. Meanwhile short requests
        get their turns, and boxes go on."""
        self.send_objects(*(post("ring/%d" % i, 1.8 * i, 1.2) for i in range(200)))
        path = turned(*(90 * (i % 2) + 0.001 * i for i in range(LONG)))
        DyingClient(NODE + "/check_path", CheckPathRequest(trajectory=path), CheckPath)
        answers = []

        def ask():
            begin = time.monotonic()
            answers.append((self.call(CheckPathRequest(trajectory=path)), time.monotonic() - begin))

        thread = threading.Thread(target=ask, daemon=True)
        thread.start()
        brief = rospy.ServiceProxy(NODE + "/check_path", CheckPath)
        waits, longest = [], 0.0
        while not answers and len(waits) < 1000:
            begin = time.monotonic()
            answer = brief(CheckPathRequest(trajectory=turned(0, 90)))
            waits.append(time.monotonic() - begin)
            self.assertEqual([s.verdict for s in answer.segments], [SAFE], answer.message)
            begin = time.monotonic()
            self.send_robot()
            longest = max(longest, time.monotonic() - begin)
        thread.join(DEADLINE)
        answer, took = answers[0]
        self.assertTrue(answer.success, answer.message)
        verdicts = [segment.verdict for segment in answer.segments]
        self.assertEqual(len(verdicts), LONG - 1)
        decided = verdicts.index(UNDECIDED)
        print("%d of %d segments in %.1f s; %d short requests, the longest took %.2f s; boxes "
              "%.2f s" % (decided, len(verdicts), took, len(waits), max(waits), longest))
        self.assertEqual(set(verdicts[:decided]), {SAFE})
        self.assertEqual(set(verdicts[decided:]), {UNDECIDED})
        self.assertIn("the 10 s of a request were over", answer.message)
        self.assertLess(took, 14 * SLOW)
        self.assertLess(max(waits), 5 * SLOW)
        self.assertLess(longest, SLOW)

    def test_what_was_wrong_is_told_to_the_request_that_met_it(self):
        """Others come in between, whose triangles are all there."""
        with tempfile.NamedTemporaryFile(suffix=".stl") as file:
            file.write(binary_stl([((9, 0, 0), (9, 1, 0), (9, 0, 1))]))
            file.flush()
            self.send_objects(*(post("ring/%d" % i, 1.8 * i, 1.2) for i in range(200)), marker(
                "lost/1", Marker.MESH_RESOURCE, mesh_resource="file://" + file.name))
            self.boxes.wait_newest(lambda m: "lost/1" in names_of(m), "the mesh")
        path = turned(*(90 * (i % 2) + 0.001 * i for i in range(LONG)))
        answers = []
        thread = threading.Thread(
            target=lambda: answers.append(self.call(CheckPathRequest(trajectory=path))),
            daemon=True)
        thread.start()
        brief = rospy.ServiceProxy(NODE + "/check_path", CheckPath)
        for _ in range(4):  # the long one, which takes 10 s, gets turns in between
            brief(CheckPathRequest(trajectory=turned(0, 90)))
        self.objects.send(deletion("lost/1"))
        self.boxes.wait_newest(lambda m: "lost/1" not in names_of(m), "none")
        self.assertEqual(brief(CheckPathRequest(trajectory=turned(0, 90))).message, "")
        self.assertEqual(answers, [])
        thread.join(DEADLINE)
        self.assertIn("the 10 s of a request were over", answers[0].message)
        self.assertIn(file.name, answers[0].message)


if __name__ == "__main__":
    rospy.init_node("check_path_test")
    rostest.rosrun("link_bounds", "check_path", CheckPathTest)
