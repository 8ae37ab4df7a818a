#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two robots: the boxes of each node are objects of the other, and their number stays the same.
Their frames in tf have prefixes, the names of their boxes do not."""
import collections
import itertools
import time
import unittest
from xml.etree import ElementTree

import rospkg
import rospy
import rostest
import yaml
from bounds_testing import (DEADLINE, Pose, Recorder, TfSender, box_link, corners_of, difference,
                            latched, load, names_of, robot, transform, turn, wait_for)
from link_bounds.msg import BoxOverlapArray
from overlap_testing import agree, expected, joined_links
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

HOLD = 20.0  # wall seconds
MEETING = 60.0  # wall seconds within which the arms of the demo meet and part
TOLERANCE = 1e-9  # m; centre and size of an object are rounded outward, far below a step of an arm
FIRST_WITH_PREFIX = (1, 15, 2)  # of robot_state_publisher
SIDES = {"left": "right", "right": "left"}  # each with its neighbour
LAUNCH = rospkg.RosPack().get_path("link_bounds") + "/launch/"
POINTS_PER_BOX = 24  # of its twelve edges
DEMO_LINKS = ["base", "shoulder", "upper_arm", "elbow", "forearm", "wrist", "flange", "gripper",
              "finger_left", "finger_right"]


def node(side):
    return "/" + side + "/link_bounds_publisher"


def objects_of(side):
    """The names that a robot's boxes have for its neighbour."""
    return sorted(node(side) + "/" + link for link in DEMO_LINKS)


def is_complete(side, message):
    return names_of(message) == DEMO_LINKS + objects_of(SIDES[side]) and not message.incomplete


def state_publisher_knows_prefixes():
    folder = rospkg.RosPack().get_path("robot_state_publisher")
    version = ElementTree.parse(folder + "/package.xml").findtext("version")
    return tuple(int(part) for part in version.split(".")) >= FIRST_WITH_PREFIX


def all_corners(boxes):
    return list(itertools.chain.from_iterable(corners_of(box) for box in boxes))


def corners_of_links(message):
    """Sorted by name, as the neighbour has them."""
    return all_corners(sorted(message.boxes[:len(DEMO_LINKS)], key=lambda box: box.name))


def corners_of_objects(message):
    return all_corners(message.boxes[len(DEMO_LINKS):])


def across(message):
    """Of the overlaps, those of a link and an object."""
    return [pair for pair in message.overlaps
            if pair.first in DEMO_LINKS and pair.second not in DEMO_LINKS]


def has_gap(boxes, places):
    """Whether the node dropped a message near those places, as it does what a busy machine reads
    too late."""
    near = boxes[max(places[0] - 1, 0):places[-1] + 2] if places else []
    numbers = [message.header.seq for message in near]
    return numbers != list(range(numbers[0], numbers[0] + len(numbers))) if numbers else True


def agreements(overlaps, boxes, ignored):
    """For each ~overlaps whether it is that of a ~boxes of its stamp, and not of an older one than
    the ~overlaps before it; None if that ~boxes may have been lost."""
    places = collections.defaultdict(list)
    for i, message in enumerate(boxes):
        places[message.header.stamp].append(i)
    last = 0
    for message in overlaps:
        those = places[message.header.stamp]
        found = next((i for i in those if i >= last and
                      agree(message, expected(boxes[i], 0, ignored))), None)
        last = last if found is None else found
        yield found is not None or (None if has_gap(boxes, those) else False)


class DemoArms(unittest.TestCase):
    """Judges each message of the hold."""

    @classmethod
    def setUpClass(cls):
        if not state_publisher_knows_prefixes():
            print("skipped: two arms of the demo, robot_state_publisher knows no tf_prefix")
            raise unittest.SkipTest("robot_state_publisher knows no tf_prefix")
        for side in SIDES:
            # No link becomes stale on a machine that is busy for two seconds.
            rospy.set_param(node(side) + "/timeout", 0.0)
            rospy.wait_for_service(node(side) + "/reload", DEADLINE)
            rospy.ServiceProxy(node(side) + "/reload", Trigger)()
        cls.boxes = {side: Recorder(node(side) + "/boxes") for side in SIDES}
        known = {side: wait_for(lambda s=side: cls.known_part(s), "both robots on " + side)
                 for side in SIDES}
        cls.overlaps = {side: Recorder(node(side) + "/overlaps", BoxOverlapArray)
                        for side in SIDES}
        cls.addClassCleanup(cls.unsubscribe)
        end = time.monotonic() + HOLD
        wait_for(lambda: time.monotonic() > end, "the end of the hold", HOLD + DEADLINE)
        cls.held = {side: recorder.messages[known[side]] for side, recorder in cls.boxes.items()}
        cls.held_overlaps = {side: recorder.messages for side, recorder in cls.overlaps.items()}
        # The messages that the last ones are compared with may come a little later.
        now = rospy.Time.now()
        for recorder in cls.boxes.values():
            recorder.wait(lambda m: m.header.stamp > now, "news")

    @classmethod
    def unsubscribe(cls):
        for recorder in itertools.chain(cls.boxes.values(), cls.overlaps.values()):
            recorder.subscriber.unregister()

    @classmethod
    def sent_by(cls, side):
        """What was received of a robot's complete link boxes, in order."""
        return [corners_of_links(message) for message in cls.boxes[side].messages
                if names_of(message)[:len(DEMO_LINKS)] == DEMO_LINKS]

    @classmethod
    def known_part(cls, side):
        """The messages from the first one on whose objects are boxes that the neighbour has sent
        since somebody listens."""
        sent = cls.sent_by(SIDES[side])
        return next((slice(i, None) for i, message in enumerate(cls.boxes[side].messages)
                     if is_complete(side, message) and
                     any(difference(corners_of_objects(message), s) < TOLERANCE for s in sent)),
                    None)

    def test_the_number_of_boxes_stays(self):
        for side, messages in self.held.items():
            self.assertGreater(len(messages), 10 * HOLD)
            for message in messages:
                self.assertTrue(is_complete(side, message), (names_of(message), message.incomplete))

    def test_objects_are_the_boxes_of_the_other_robot(self):
        for side, neighbour in SIDES.items():
            sent = iter(self.sent_by(neighbour))
            shown, changes = next(sent), 0
            for message in self.held[side]:
                objects = corners_of_objects(message)
                changes += difference(objects, shown) > TOLERANCE
                while difference(objects, shown) > TOLERANCE:
                    shown = next(sent, None)
                    self.assertIsNotNone(shown, neighbour + " sent no such boxes, or not then")
            self.assertGreater(changes, 5 * HOLD)

    def test_overlaps_are_those_of_the_boxes(self):
        with open(LAUNCH + "demo/demo.urdf", encoding="utf-8") as file:
            joined = joined_links(file.read(), 2)
        for side, neighbour in SIDES.items():
            ignored = joined.union(itertools.product(objects_of(neighbour), repeat=2))
            overlaps = self.held_overlaps[side]
            self.assertGreater(len(overlaps), 10 * HOLD)
            found = list(agreements(overlaps, self.boxes[side].messages, ignored))
            self.assertNotIn(False, found)
            self.assertLess(found.count(None), 0.1 * len(found))

    def test_arms_meet_and_part(self):
        for side, recorder in self.overlaps.items():
            met = recorder.wait(across, "an overlap of both arms", MEETING)
            for pair in across(met):
                self.assertIn(pair.second, objects_of(SIDES[side]))
            recorder.wait(lambda m: not m.overlaps, "no overlap at all", MEETING)
            for message in recorder.messages:
                self.assertEqual(message.overlaps, across(message))

    def test_rviz_shows_each_link_of_both_once(self):
        with open(LAUNCH + "two_robots.rviz", encoding="utf-8") as file:
            displays = yaml.safe_load(file)["Visualization Manager"]["Displays"]
        topics = [d["Marker Topic"] for d in displays if d["Class"] == "rviz/MarkerArray"]
        self.assertEqual(len(topics), len(SIDES))
        for topic in topics:
            message = Recorder(topic, MarkerArray).wait(
                lambda m: any(r.ns == "overlapping" and r.points for r in m.markers),
                "boxes in red", MEETING)
            edges = [len(m.points) for m in message.markers if m.type == m.LINE_LIST]
            self.assertEqual(sum(edges), len(DEMO_LINKS) * POINTS_PER_BOX)

    def test_fixed_frame_is_common(self):
        for messages in self.held.values():
            self.assertEqual({m.header.frame_id for m in messages}, {"world"})


SIZE, CENTRE = (0.2, 0.5, 1.1), (0.7, 0.0, 0.0)
LINKS = {"left": ["base", "arm", "/table"], "right": ["base", "arm"]}
# A name that begins with a slash can be in one robot only: it is the same frame for all.
FRAMES = {"left": ["left/base", "left/arm", "table"], "right": ["right/base", "right/arm"]}
DEGREES = {"left": 30, "right": 45}


def arm_pose(side):
    return Pose((1, 0, 0), turn((0, 0, 1), DEGREES[side]))


def link_bounds(base_from_link):
    return (base_from_link * Pose(CENTRE)).box_bounds(SIZE)


class Prefixes(unittest.TestCase):
    """tf_prefix is found in the namespaces above the nodes."""

    @classmethod
    def setUpClass(cls):
        boxes = {side: Recorder(node(side) + "/boxes") for side in SIDES}
        rospy.set_param("/right/tf_prefix", "/right")
        for side, links in LINKS.items():
            load(node(side), robot([box_link(link, SIZE, CENTRE) for link in links],
                                   [("base", link) for link in links[1:]]))
        tf, static_tf = TfSender(), TfSender(is_static=True)
        wait_for(lambda: tf.listeners() >= 2 and static_tf.listeners() >= 2, "both nodes listen")
        stamp = rospy.Time.now()
        static_tf.send(transform("left/base", "table", stamp, (1, 0, 0)))
        for side in SIDES:
            pose = arm_pose(side)
            tf.send(transform(side + "/base", side + "/arm", stamp, pose.xyz, pose.xyzw))
        cls.messages = {side: recorder.wait(
            lambda m, s=side: names_of(m)[:len(LINKS[s])] == LINKS[s], "all links")
            for side, recorder in boxes.items()}

    def test_frame_has_the_prefix(self):
        for side, message in self.messages.items():
            self.assertEqual(message.header.frame_id, side + "/base")

    def test_each_robot_moves_by_itself(self):
        for side, message in self.messages.items():
            self.assertLess(difference(corners_of(message.boxes[0]), link_bounds(Pose())),
                            TOLERANCE)
            self.assertLess(difference(corners_of(message.boxes[1]),
                                       link_bounds(arm_pose(side))), TOLERANCE)

    def test_name_with_a_slash_takes_no_prefix(self):
        table = self.messages["left"].boxes[2]
        self.assertEqual(table.name, "/table")
        self.assertLess(difference(corners_of(table), link_bounds(Pose((1, 0, 0)))),
                        TOLERANCE)

    def test_namespaces_of_markers_are_names_in_tf(self):
        for side, frames in FRAMES.items():
            message = latched(node(side) + "/markers", MarkerArray)
            own = [m for m in message.markers if not m.ns.startswith("link_bounds/objects/")]
            self.assertEqual({m.ns for m in own if m.action == m.ADD}, set(frames))
            self.assertEqual({m.header.frame_id for m in own}, {side + "/base"})


if __name__ == "__main__":
    rospy.init_node("two_robots_test")
    rostest.rosrun("link_bounds", "two_robots", "two_robots_test")
