#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stamps of boxes, poses between two samples, and when boxes are published.

Each test has links of its own, which no transform of another test moves.
"""
import math
import unittest

import rospy
import rostest

from bounds_testing import (Pose, Recorder, TfSender, box_link, box_of, corners_of, difference,
                            load, names_of, robot, transform, turn)

NODE = "/link_bounds_publisher"
TOLERANCE = 1e-9  # metres
SIZE = (0.2, 0.5, 1.1)
MANY = 20
TURNED_30 = Pose((1.0, 0.0, 0.0), turn((0, 0, 1), 30))
TURNED_120 = Pose((1.5, -0.5, 2.0), turn((1, 2, 3), 120))
TURNED_45 = Pose((0.0, 0.25, 0.5), turn((1, 0, 0), 45))


def at(milliseconds):
    return rospy.Time(1000, milliseconds * 1000000)


def edge(parent, child, milliseconds, pose=TURNED_30):
    return transform(parent, child, at(milliseconds), pose.xyz, pose.xyzw)


def between(first, second, share):
    """Linear in the translation, slerp in the rotation."""
    dot = sum(a * b for a, b in zip(first.xyzw, second.xyzw))
    sign, angle = math.copysign(1, dot), math.acos(min(1.0, abs(dot)))
    rest = math.sin((1 - share) * angle) / math.sin(angle)
    part = sign * math.sin(share * angle) / math.sin(angle)
    return Pose([a + share * (b - a) for a, b in zip(first.xyz, second.xyz)],
                [rest * a + part * b for a, b in zip(first.xyzw, second.xyzw)])


class StampsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("stamps_test")
        cls.boxes = Recorder(NODE + "/boxes")
        cls.groups = Recorder(NODE + "/groups")
        cls.fast, cls.slow, cls.static = TfSender(), TfSender(), TfSender(is_static=True)
        for sender in (cls.fast, cls.slow, cls.static):
            sender.wait_for_listener()

    def load_chain(self, prefix):
        """base -> a -> b -> c; c does not move on b. Returns the names with the prefix."""
        names = [prefix + name for name in ("base", "a", "b", "c")]
        load(NODE, robot([box_link(name, SIZE) for name in names], zip(names, names[1:])))
        self.static.send(edge(names[2], names[3], 0, TURNED_45))
        return names

    def send_two_rates(self, base, a, b):
        """The fast edge has samples every 100 ms, the slow one at 0 and 240 ms."""
        self.slow.send(edge(a, b, 0, TURNED_45))
        for milliseconds in (0, 100, 200):
            self.fast.send(edge(base, a, milliseconds, TURNED_30))
        self.slow.send(edge(a, b, 240, TURNED_45))
        for milliseconds in (300, 400):
            self.fast.send(edge(base, a, milliseconds, TURNED_120))

    def newest(self, recorder, base, milliseconds):
        return recorder.wait(
            lambda m: m.header.frame_id == base and m.header.stamp == at(milliseconds),
            "stamp %d ms" % milliseconds)

    def wait_for_stamps(self, **expected):
        """The first message with these boxes and stamps; publishers do not wait for each other."""
        return self.boxes.wait(lambda m: {box.name: box.stamp for box in m.boxes} == expected,
                               "stamps %s" % expected)

    def test_stamp_is_the_latest_common_time(self):
        base, a, b, c = self.load_chain("common_")
        self.send_two_rates(base, a, b)
        message = self.wait_for_stamps(
            **{base: rospy.Time(0), a: at(400), b: at(240), c: at(240)})
        self.assertEqual(message.header.stamp, at(400))

    def test_stamp_of_a_group_is_the_oldest(self):
        base, a, b, _ = self.load_chain("group_")
        self.send_two_rates(base, a, b)
        self.fast.send(edge(base, a, 500), edge(a, b, 450, TURNED_45))
        message = self.newest(self.groups, base, 450)
        self.assertEqual([box.stamp for box in message.boxes], [at(450)])
        self.assertEqual(box_of(self.newest(self.boxes, base, 500), a).stamp, at(500))

    def test_pose_between_two_samples(self):
        base, a, b, c = self.load_chain("between_")
        self.send_two_rates(base, a, b)
        message = self.wait_for_stamps(
            **{base: rospy.Time(0), a: at(400), b: at(240), c: at(240)})
        base_from_b = between(TURNED_30, TURNED_120, 0.4) * TURNED_45
        expected = {base: Pose(), a: TURNED_120, b: base_from_b, c: base_from_b * TURNED_45}
        self.assertEqual(names_of(message), list(expected))
        for name, pose in expected.items():
            self.assertLess(difference(corners_of(box_of(message, name)), pose.box_bounds(SIZE)),
                            TOLERANCE, name)

    def published_from_now(self, base, a, send):
        """What the node publishes because of send(); a last message of link a ends it."""
        self.fast.send(edge(base, a, 1000))
        first = self.newest(self.boxes, base, 1000)
        send()
        self.fast.send(edge(base, a, 9000))
        last = self.newest(self.boxes, base, 9000)
        messages = self.boxes.messages
        return messages[messages.index(first) + 1:messages.index(last)]

    def test_no_news_publishes_nothing(self):
        base, a, _, c = self.load_chain("nonews_")

        def send():
            self.fast.send(edge("nonews_other", "nonews_elsewhere", 1100))
            self.fast.send(edge(c, "nonews_without_geometry", 1200))
            self.fast.send(edge(base, a, 1000))  # a repetition
            self.fast.send()
        self.assertEqual(self.published_from_now(base, a, send), [])

    def test_new_stamp_alone_is_news(self):
        base, a, _, _ = self.load_chain("stampnews_")
        times = [1100, 1200, 1300]

        def send():
            for time in times:  # one by one: messages that wait are answered together
                self.fast.send(edge(base, a, time))
                self.newest(self.boxes, base, time)
        found = self.published_from_now(base, a, send)
        self.assertEqual([m.header.stamp for m in found], [at(time) for time in times])

    def test_one_publication_per_message_of_many_links(self):
        names = ["many_base"] + ["many_%d" % i for i in range(MANY)]
        chain = list(zip(names, names[1:]))
        load(NODE, robot([box_link(name, SIZE) for name in names], chain))

        def send():
            for milliseconds in (1000, 1100):
                self.fast.send(*[edge(*pair, milliseconds) for pair in chain])
                self.boxes.wait(lambda m, stamp=at(milliseconds): len(m.boxes) == MANY + 1 and
                                m.header.stamp == stamp, "all boxes")
        found = self.published_from_now("many_base", "many_0", send)
        self.assertEqual([len(m.boxes) for m in found], [MANY + 1, MANY + 1])
        self.assertEqual([m.incomplete for m in found], [[], []])


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "stamps", StampsTest)
