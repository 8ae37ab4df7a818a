#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~stopping, its markers and its overlaps, and ~earliest: a slide that moves, an object in its way,
and two robots that hear each other."""
import random
import time
import unittest

import rospy
import rostest
from bounds_testing import (Recorder, TfSender, box_link, load, names_of, transform, wait_for)
from diagnostic_msgs.msg import DiagnosticArray
from link_bounds.msg import BoxOverlapArray, EarliestContactArray
from node_testing import NODE, NodeProcess
from patience import PATIENCE
from sensor_msgs.msg import JointState
from visualization_msgs.msg import Marker, MarkerArray


def slide(rail, cart):
    return ('<robot name="slide">' + box_link(rail, (0.2, 0.2, 0.2)) +
            box_link(cart, (0.2, 0.2, 0.2)) +
            '<joint name="slide" type="prismatic"><parent link="%s"/><child link="%s"/><axis '
            'xyz="1 0 0"/><limit lower="-5" upper="5" effort="1" velocity="2"/></joint></robot>'
            % (rail, cart))


SLIDE = slide("rail", "cart")
MAX_SPEED = 2.0
SPEED, DECELERATION, REACTION = 0.5, 2.0, 0.2
WAY = SPEED * REACTION + SPEED ** 2 / (2 * DECELERATION)  # m until the cart stands
START = 1.0  # m, where the cart is at the newest stamp
RATE = 100  # Hz
NEAR = 1e-6  # m


def slide_joint(name, parent, child):
    return ('<joint name="%s" type="prismatic"><parent link="%s"/><child link="%s"/><axis '
            'xyz="1 0 0"/><limit lower="-9" upper="9" effort="1" velocity="%g"/></joint>'
            % (name, parent, child, MAX_SPEED))


TWO_SLIDES = ('<robot name="slides"><link name="rail"/><link name="lower"/>' +
              box_link("cart", (0.2, 0.2, 0.2)) + slide_joint("first", "rail", "lower") +
              slide_joint("second", "lower", "cart") + '</robot>')
BURST = 8  # messages


def two_slides(dice, begin, wall):
    """The transforms of a motion in the order in which they come, and when the cart is at `wall`."""
    step, dash = 0.01, 1.0  # s
    values, now, contact, sent = [0.0, 0.0], begin, None, []
    while contact is None or now < contact + 0.1:
        for (parent, child), value in zip((("rail", "lower"), ("lower", "cart")), values):
            if dice.random() < 0.7:
                message = transform(parent, child, rospy.Time(now), (value, 0, 0))
                sent.append((now + dice.uniform(0, 0.1), len(sent), message))
        signs = [1 if now - begin > dash else -1 if value > 0.4 else 1 if value < -0.4
                 else dice.choice((1, -1)) for value in values]
        before = sum(values)
        values = [value + sign * MAX_SPEED * step for value, sign in zip(values, signs)]
        if contact is None and sum(values) >= wall:
            contact = now + step * (wall - before) / (sum(values) - before)
        now += step
    return [message for _, _, message in sorted(sent, key=lambda entry: entry[:2])], contact


class StoppingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.objects = rospy.Publisher(NODE + "/object", Marker, queue_size=1, latch=True)
        cls.now = 1000.0

    def setUp(self):
        load(NODE, SLIDE, deceleration={"slide": DECELERATION}, reaction_time=REACTION)

    def listen(self, topic, message_type=None):
        arguments = (message_type,) if message_type else ()
        recorder = Recorder(NODE + topic, *arguments)
        self.addCleanup(recorder.subscriber.unregister)
        wait_for(lambda: recorder.subscriber.get_num_connections() > 0, "connected")
        return recorder

    def move(self, speed=SPEED):
        """For 0.2 s, until the cart is at START."""
        for i in range(20, -1, -1):
            type(self).now += 1.0 / RATE
            self.tf.send(transform("rail", "cart", rospy.Time(self.now),
                                   (START - speed * i / RATE, 0, 0), (0, 0, 0, 1)))
        return rospy.Time(self.now)

    def boxes_of(self, recorder, stamp):
        message = recorder.wait(lambda m: m.header.stamp == stamp and not m.incomplete, "boxes")
        return {box.name: box for box in message.boxes}

    def test_the_box_reaches_to_where_the_cart_stands(self):
        stopping = self.listen("/stopping")
        boxes = self.boxes_of(stopping, self.move())
        self.assertAlmostEqual(boxes["cart"].max.x, START + 0.1 + WAY, delta=NEAR)
        self.assertAlmostEqual(boxes["cart"].min.x, START - 0.1, delta=NEAR)
        self.assertAlmostEqual(boxes["rail"].max.x, 0.1, delta=NEAR)
        boxes = self.boxes_of(stopping, self.move(-SPEED))
        self.assertAlmostEqual(boxes["cart"].max.x, START + 0.1, delta=NEAR)
        self.assertAlmostEqual(boxes["cart"].min.x, START - 0.1 - WAY, delta=NEAR)

    def test_a_new_subscriber_gets_one_while_nothing_comes(self):
        stamp = self.move()
        self.assertIn("cart", self.boxes_of(self.listen("/stopping"), stamp))

    def test_during_reaction_limit(self):
        load(NODE, SLIDE, deceleration={"slide": DECELERATION}, reaction_time=REACTION,
             during_reaction="limit")
        boxes = self.boxes_of(self.listen("/stopping"), self.move(0))
        way = 2.0 * REACTION + 2.0 ** 2 / (2 * DECELERATION)
        self.assertAlmostEqual(boxes["cart"].max.x, START + 0.1 + way, delta=NEAR)
        self.assertAlmostEqual(boxes["cart"].min.x, START - 0.1 - way, delta=NEAR)

    def test_without_deceleration_it_is_incomplete_and_diagnostics_say_why(self):
        load(NODE, SLIDE)
        stopping = self.listen("/stopping")
        status = Recorder("/diagnostics", DiagnosticArray)
        self.addCleanup(status.subscriber.unregister)
        stamp = self.move()
        message = stopping.wait(lambda m: m.incomplete == ["cart"], "incomplete")
        self.assertEqual(names_of(message), ["rail"])
        self.assertLessEqual(message.header.stamp, stamp)
        status.wait(lambda m: any(
            value.key == "stopping" and 'joint "slide" has no ~deceleration' in value.value
            for s in m.status for value in s.values), "the reason in /diagnostics")

    def put_box(self, gap):
        """So far in front of the cart."""
        box = Marker(ns="in_the_way", id=1, type=Marker.CUBE)
        box.header.frame_id = "rail"
        box.pose.position.x = START + 0.1 + gap + 0.05
        box.pose.orientation.w = 1
        box.scale.x = box.scale.y = box.scale.z = 0.1
        self.objects.publish(box)
        self.addCleanup(lambda: self.objects.publish(
            Marker(ns="in_the_way", id=1, action=Marker.DELETE)))

    def test_earliest(self):
        """At the limit of the URDF, however fast the cart is now."""
        load(NODE, SLIDE, distance_limit=1.0)
        earliest = self.listen("/earliest", EarliestContactArray)
        self.put_box(0.6)
        stamp = self.move()
        message = earliest.wait(
            lambda m: m.header.stamp == stamp and len(m.contacts) == 1, "a contact")
        contact = message.contacts[0]
        self.assertEqual((contact.first, contact.second), ("cart", "in_the_way/1"))
        self.assertAlmostEqual((contact.earliest - stamp).to_sec(), 0.6 / MAX_SPEED, delta=1e-4)
        self.assertEqual(message.valid_until, contact.earliest)
        self.assertEqual(message.incomplete, [])
        self.assertAlmostEqual(contact.distance, 0.6, delta=1e-4)

    def test_earliest_is_never_late_while_tf_is(self):
        """A slide on a slide: both go to and fro as fast as they may, then to the wall. Their
        transforms are delayed, lost and out of order, and come in bursts."""
        load(NODE, TWO_SLIDES, distance_limit=5.0)
        earliest = self.listen("/earliest", EarliestContactArray)
        gap = 0.9
        self.put_box(gap)
        dice = random.Random(4)
        type(self).now += 1
        begin, wall = self.now, START + gap
        messages, contact = two_slides(dice, begin, wall)
        for first in range(0, len(messages), BURST):
            seen = len(earliest.messages)
            for message in messages[first:first + BURST]:
                self.tf.send(message)
            wait_for(lambda seen=seen: len(earliest.messages) > seen, "contacts after a burst")
        type(self).now += 10
        checked = [m for m in earliest.messages
                   if not m.incomplete and begin < m.header.stamp.to_sec() < contact]
        self.assertGreater(len(checked), 10)
        latest = max(m.valid_until.to_sec() for m in checked)
        self.assertLessEqual(latest, contact + NEAR)
        self.assertGreater(latest, contact - 0.2)

    def test_joint_states(self):
        """tf is too slow for ~velocity_window; /joint_states is not."""
        load(NODE, SLIDE, deceleration={"slide": DECELERATION}, reaction_time=REACTION,
             joint_states=True)
        joints = rospy.Publisher("joint_states", JointState, queue_size=10)
        self.addCleanup(joints.unregister)
        stopping = self.listen("/stopping")
        type(self).now += 1
        wait_for(lambda: self.send_slow_tf() and joints.get_num_connections() > 0, "a subscription")
        state = JointState(name=["slide"], position=[START], velocity=[SPEED])
        type(self).now += 1
        wrong = JointState(name=["slide"], position=[0], velocity=[0])
        wrong.header.stamp = rospy.Time.now() + rospy.Duration(3600)  # of a clock an hour ahead
        state.header.stamp = rospy.Time(self.now)
        for message in wrong, state, wrong:
            joints.publish(message)

        def cart_of(message):
            return next((box for box in message.boxes if box.name == "cart"), None)

        def is_there():
            self.send_slow_tf()
            return any(cart_of(m) and abs(cart_of(m).max.x - START - 0.1 - WAY) < NEAR
                       for m in stopping.messages)
        wait_for(is_there, "a box")

    def send_slow_tf(self):
        """One transform, again and again."""
        self.tf.send(transform("rail", "cart", rospy.Time(self.now), (START, 0, 0), (0, 0, 0, 1)))
        return True

    def test_two_robots_hear_where_the_other_one_can_stop(self):
        """They meet in the middle only if both brake as late and as softly as they may."""
        robots = {"left": 1, "right": -1}
        for name, other in (("left", "right"), ("right", "left")):
            rospy.set_param("/%s_description" % name, slide(name + "_rail", name + "_cart"))
            node = NodeProcess(name, ["~neighbours:=/%s/stopping" % other,
                                      "robot_description:=/%s_description" % name],
                               fixed_frame="map", deceleration={"slide": DECELERATION},
                               reaction_time=REACTION)
            self.addCleanup(node.end)
        recorders = {name: Recorder("/%s/stopping_overlaps" % name, BoxOverlapArray)
                     for name in robots}

        def send(gap):
            """Both carts move for 0.2 s, until they are so far apart."""
            for i in range(20, -1, -1):
                type(self).now += 1.0 / RATE
                for name, sign in robots.items():
                    rail = -sign * 3.0  # m, so that the rails are apart
                    cart = -sign * (0.1 + gap / 2 + SPEED * i / RATE) - rail
                    stamp = rospy.Time(self.now)
                    self.tf.send(
                        transform("map", name + "_rail", stamp, (rail, 0, 0), (0, 0, 0, 1)),
                        transform(name + "_rail", name + "_cart", stamp, (cart, 0, 0),
                                  (0, 0, 0, 1)))
            return rospy.Time(self.now)

        def is_told(pairs):
            """Of the end of a motion, soon: the first ones come before the nodes have connected."""
            stamp, end = send(gap), time.monotonic() + PATIENCE

            def is_newest(recorder, hits):
                newest = recorder.messages[-1] if recorder.messages else None
                return (newest and newest.header.stamp == stamp and
                        [(o.first, o.second) for o in newest.overlaps] == hits)
            while time.monotonic() < end:
                if all(is_newest(recorders[name], pairs[name]) for name in robots):
                    return True
                time.sleep(0.01)  # polls a condition
            return False
        met = {"left": [("left_cart", "/right/right_cart")],
               "right": [("right_cart", "/left/left_cart")]}
        for gap, pairs in ((2 * WAY - 0.01, met), (2 * WAY + 0.01, {"left": [], "right": []})):
            wait_for(lambda pairs=pairs: is_told(pairs), "pairs at a gap of %g m" % gap)

    def test_overlaps_with_what_is_in_the_way(self):
        overlaps = self.listen("/stopping_overlaps", BoxOverlapArray)
        self.put_box(WAY - 0.01)
        stamp = self.move()

        def names(message):
            return [(o.first, o.second) for o in message.overlaps]
        hit = [("cart", "in_the_way/1")]
        overlaps.wait(lambda m: m.header.stamp == stamp and names(m) == hit, "an overlap")
        stamp = self.move(0.9 * SPEED)
        overlaps.wait(lambda m: m.header.stamp == stamp and names(m) == [], "no overlap")

    def test_markers(self):
        markers = self.listen("/stopping_markers", MarkerArray)
        stamp = self.move()
        message = markers.wait(lambda m: m.markers[0].header.stamp == stamp, "markers")
        self.assertEqual({m.ns for m in message.markers}, {"link_bounds/stopping"})
        highest = max(point.x for m in message.markers for point in m.points)
        self.assertAlmostEqual(highest, START + 0.1 + WAY, delta=NEAR)


if __name__ == "__main__":
    rospy.init_node("stopping_test")
    rostest.rosrun("link_bounds", "stopping", StoppingTest)
