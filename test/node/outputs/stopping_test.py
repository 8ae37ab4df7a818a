#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~stopping, its markers and its overlaps: a slide that moves, and an object in its way."""
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, box_link, load, names_of, transform, wait_for
from diagnostic_msgs.msg import DiagnosticArray
from link_bounds.msg import BoxOverlapArray
from node_testing import NODE
from visualization_msgs.msg import Marker, MarkerArray

SLIDE = ('<robot name="slide">' + box_link("rail", (0.2, 0.2, 0.2)) +
         box_link("cart", (0.2, 0.2, 0.2)) +
         '<joint name="slide" type="prismatic"><parent link="rail"/><child link="cart"/>'
         '<axis xyz="1 0 0"/><limit lower="-5" upper="5" effort="1" velocity="2"/></joint></robot>')
SPEED, DECELERATION, REACTION = 0.5, 2.0, 0.2
WAY = SPEED * REACTION + SPEED ** 2 / (2 * DECELERATION)  # m until the cart stands
START = 1.0  # m, where the cart is at the newest stamp
RATE = 100  # Hz
NEAR = 1e-6  # m


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

    def test_overlaps_with_what_is_in_the_way(self):
        overlaps = self.listen("/stopping_overlaps", BoxOverlapArray)
        box = Marker(ns="in_the_way", id=1, type=Marker.CUBE)
        box.header.frame_id = "rail"
        box.pose.position.x = START + 0.1 + WAY + 0.04
        box.pose.orientation.w = 1
        box.scale.x = box.scale.y = box.scale.z = 0.1
        self.objects.publish(box)
        self.addCleanup(lambda: self.objects.publish(
            Marker(ns="in_the_way", id=1, action=Marker.DELETE)))
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
