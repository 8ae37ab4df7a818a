#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A CUBE on ~object is a zone; ~overlaps and zone_events.py report at once which link enters it."""
import itertools
import os
import sys
import time
import unittest

import roslib.packages
import rospy
import rostest
from bounds_testing import (NodeLog, Pose, Recorder, TfSender, box_link, load, names_of, robot,
                            transform, turn, wait_for)
from link_bounds.msg import (AxisAlignedBox, AxisAlignedBoxArray, BoxOverlap,
                             BoxOverlapArray)
from node_testing import NODE, SANITIZED
from object_testing import ObjectSender, deletion, marker
from std_msgs.msg import Header, String

sys.path.append(os.path.join(roslib.packages.get_pkg_dir("link_bounds"), "launch", "demo"))
from zone_events import Watch  # noqa: E402

TOLERANCE = 1e-9  # m
ENTRIES = 50 if SANITIZED else 300
STALE_AFTER = 0.5  # ROS seconds
ZONE, OTHER_ZONE, PARCEL = "zones/1", "zones/2", "parcels/1"
ZONE_MIN_X = 1.5  # m
ROBOT = robot([box_link("base", (0.2, 0.2, 0.2)), box_link("hand", (0.4, 0.2, 0.1))],
              [("base", "hand")])
HAND_HALF_LENGTH = 0.2 * 3 ** 0.5 / 2 + 0.1 / 2  # m along x, turned by 30 degrees
TOUCHING = ZONE_MIN_X - HAND_HALF_LENGTH
OUTSIDE, INSIDE = (TOUCHING - 0.01, 0, 0), (TOUCHING + 0.01, 0, 0)


def zone(name=ZONE, x=2.0):
    """One metre wide."""
    return marker(name, scale=(1, 1, 1), pose=Pose((x, 0, 0)))


class TimedOverlaps:
    """Wall time of receipt of the first message of each stamp, and whether the zone is entered."""

    def __init__(self):
        self._received = {}
        self.subscriber = rospy.Subscriber(NODE + "/overlaps", BoxOverlapArray, self._add,
                                           tcp_nodelay=True)
        wait_for(lambda: self.subscriber.get_num_connections() > 0, "connected")

    def _add(self, message):
        is_entered = [(pair.first, pair.second) for pair in message.overlaps] == [("hand", ZONE)]
        self._received.setdefault(message.header.stamp, (time.monotonic(), is_entered))

    def wait(self, stamp):
        return wait_for(lambda: self._received.get(stamp), "overlaps of stamp %s" % stamp)


class SafetyZone(unittest.TestCase):
    stamps, numbers = itertools.count(1000), itertools.count(99)

    @classmethod
    def setUpClass(cls):
        cls.events = Recorder("/zone_events/events", String)
        cls.boxes = Recorder(NODE + "/boxes")
        wait_for(lambda: cls.events.subscriber.get_num_connections() > 0, "connected")
        cls.objects = ObjectSender(NODE)
        cls.objects.send_alone(zone())
        cls.without_robot = cls.boxes.wait(lambda m: m.boxes, "a zone")
        rospy.set_param("/robot_description", ROBOT)
        cls.tf = TfSender()
        cls.tf.wait_for_listener()
        cls.boxes.wait(lambda m: "hand" in m.incomplete, "a robot")

    def setUp(self):
        self.place(OUTSIDE)
        self.objects.clear()
        self.boxes.clear()
        self.objects.send(zone())
        self.boxes.wait(lambda m: names_of(m) == ["base", "hand", ZONE], "one zone")
        self.wait_for_events_until_now()
        self.events.clear()

    def wait_for_events_until_now(self):
        """Events come in order, and "left" is the last of one state."""
        number = next(self.numbers)
        far_zone, parcel = "zones/%d" % number, "parcels/%d" % number
        self.objects.send(zone(far_zone, 50.0), zone(parcel, 50.5))
        self.expect("object %s entered zone %s" % (parcel, far_zone))
        self.objects.send(deletion(parcel))
        self.expect("object %s left zone %s" % (parcel, far_zone))
        self.objects.send(deletion(far_zone))
        self.expect("zone %s is gone" % far_zone)

    def place(self, xyz):
        stamp = rospy.Time(next(self.stamps))
        self.tf.send(transform("base", "hand", stamp, xyz, turn((0, 0, 1), 30)))
        return stamp

    def reported(self):
        return [message.data for message in self.events.messages]

    def expect(self, event):
        self.events.wait(lambda m: m.data == event, event)

    def test_the_zone_was_there_before_the_robot(self):
        self.assertEqual(names_of(self.without_robot), [ZONE])

    def test_a_link_enters_and_leaves(self):
        overlaps = Recorder(NODE + "/overlaps", BoxOverlapArray)
        self.addCleanup(overlaps.subscriber.unregister)
        stamp = self.place(INSIDE)
        self.expect("link hand entered zone zones/1")
        pair = overlaps.wait(lambda m: m.header.stamp == stamp and m.overlaps, "a pair").overlaps[0]
        self.assertEqual((pair.first, pair.second), ("hand", ZONE))
        self.assertAlmostEqual(pair.distance, -0.01, delta=TOLERANCE)
        self.place(OUTSIDE)
        self.expect("link hand left zone zones/1")
        self.assertEqual(self.reported(), ["link hand entered zone zones/1",
                                       "link hand left zone zones/1"])

    def test_a_zone_comes_and_goes_around_a_link(self):
        self.objects.send(deletion(ZONE))
        self.expect("zone zones/1 is gone")
        self.place(INSIDE)
        self.objects.send(zone())
        self.expect("link hand entered zone zones/1")
        self.objects.send(deletion(ZONE))
        self.expect("link hand left zone zones/1")

    def test_zones_do_not_enter_each_other_but_objects_do(self):
        self.objects.send(zone(OTHER_ZONE, 2.5), zone(PARCEL, 3.2))
        self.expect("object parcels/1 entered zone zones/2")
        self.place(INSIDE)
        self.expect("link hand entered zone zones/1")
        self.assertEqual([event for event in self.reported() if "entered" in event],
                         ["object parcels/1 entered zone zones/2",
                          "link hand entered zone zones/1"])

    def test_who_has_no_box_has_not_left(self):
        self.place(INSIDE)
        self.expect("link hand entered zone zones/1")
        load(NODE, fixed_frame="base", timeout=STALE_AFTER)
        self.expect("hand is not watched: it is incomplete")
        self.wait_for_events_until_now()
        load(NODE, fixed_frame="base")
        self.place(INSIDE)
        self.expect("hand is no longer incomplete")
        self.place(OUTSIDE)
        self.expect("link hand left zone zones/1")
        of_hand = [event for event in self.reported() if event.startswith("link hand")]
        self.assertEqual(of_hand, ["link hand entered zone zones/1", "link hand left zone zones/1"])

    def test_a_name_cannot_forge_a_line_of_the_log(self):
        log = NodeLog("/zone_events")
        wait_for(lambda: self.wait_for_events_until_now() or log.messages, "zone_events logs")
        self.objects.send(zone("par\ncels/1"))
        self.expect("object par\ncels/1 entered zone zones/1")
        log.wait(lambda m: m.msg == "object par cels/1 entered zone zones/1", "one line")

    def test_it_is_reported_at_once(self):
        """Prints the latency, which is no failure on a busy machine."""
        overlaps = TimedOverlaps()
        self.addCleanup(overlaps.subscriber.unregister)
        latencies = []
        for _ in range(ENTRIES):
            _, is_entered = overlaps.wait(self.place(OUTSIDE))
            self.assertFalse(is_entered)
            start = time.monotonic()
            received, is_entered = overlaps.wait(self.place(INSIDE))
            self.assertTrue(is_entered)
            latencies.append((received - start) * 1e3)
        latencies.sort()
        print("latency: from tf sent to overlap received, %d entries of a link into a zone: "
              "median %.2f ms, p99 %.2f ms" % (ENTRIES, latencies[ENTRIES // 2],
                                               latencies[ENTRIES * 99 // 100]), flush=True)


class Publishers(unittest.TestCase):
    """Of a zone_events.py that listens to topics of its own."""

    def test_it_reports_that_nobody_publishes(self):
        events = Recorder("/zone_events_alone/events", String)
        wait_for(lambda: events.subscriber.get_num_connections() > 0, "connected")

        def publish(topic, kind):
            publisher = rospy.Publisher(topic, kind, queue_size=1)
            wait_for(lambda: publisher.get_num_connections() > 0, "heard on " + topic)
            return publisher

        def expect(event):
            events.wait(lambda m: m.data == event, event)
            events.clear()

        boxes = publish("/alone/boxes", AxisAlignedBoxArray)
        overlaps = publish("/alone/overlaps", BoxOverlapArray)
        for _ in range(2):
            overlaps.unregister()
            expect("no zone is watched: nobody publishes /alone/overlaps")
            overlaps = publish("/alone/overlaps", BoxOverlapArray)
            expect("zones are watched again")
        boxes.unregister()
        expect("no zone is watched: nobody publishes /alone/boxes")


ENTERED, LEFT = "link hand entered zone zones/1", "link hand left zone zones/1"


class LateBoxes(unittest.TestCase):
    """Messages in any order, without a node."""

    def setUp(self):
        self.told = []
        self.watch = Watch("zones", self.told.append)

    def overlaps(self, stamp, *names):
        self.watch.take_overlaps(BoxOverlapArray(
            header=Header(stamp=rospy.Time(stamp)),
            overlaps=[BoxOverlap(first=name, second=ZONE) for name in names]))

    def boxes(self, stamp, *incomplete):
        self.watch.take_boxes(AxisAlignedBoxArray(
            header=Header(stamp=rospy.Time(stamp)), incomplete=list(incomplete),
            boxes=[AxisAlignedBox(name=name) for name in {"hand"}.difference(incomplete)]))

    def has_left(self, periods=3):
        """Looked at for long enough."""
        for _ in range(periods):
            self.watch.settle()
        return self.told.count(LEFT) == 1

    def enter(self, stamp):
        self.boxes(stamp)
        self.overlaps(stamp, "hand")
        self.assertEqual(self.told, [ENTERED])

    def test_boxes_that_come_later_may_say_that_a_link_is_not_watched(self):
        self.enter(5)
        self.overlaps(6)
        self.assertFalse(self.has_left())
        self.boxes(6, "hand")
        self.assertFalse(self.has_left())

    def test_boxes_as_new_confirm_that_it_has_left(self):
        self.enter(5)
        self.overlaps(6)
        self.overlaps(7)
        self.assertFalse(self.has_left())
        self.boxes(6)
        self.assertTrue(self.has_left())

    def test_who_is_complete_again_is_looked_for_in_overlaps_as_new(self):
        self.enter(5)
        self.boxes(6, "hand")
        self.overlaps(6)
        self.boxes(7)
        self.assertFalse(self.has_left())
        self.overlaps(7, "hand")
        self.assertFalse(self.has_left())
        self.boxes(8)
        self.overlaps(8)
        self.assertTrue(self.has_left())

    def test_after_a_jump_of_the_clock_the_times_begin_anew(self):
        for first, second in ((self.boxes, self.overlaps), (self.overlaps, self.boxes)):
            with self.subTest(first.__name__):
                self.setUp()
                self.enter(1000)
                first(5)
                self.assertFalse(self.has_left())
                second(5)
                self.assertTrue(self.has_left())

    def test_a_box_that_is_lost_may_set_the_stamps_back(self):
        """It was the newest one."""
        self.enter(1000)
        self.overlaps(999)
        self.overlaps(1001)
        self.assertFalse(self.has_left())
        self.boxes(999, "hand")
        self.assertFalse(self.has_left())

    def test_stamps_may_go_back_twice(self):
        self.enter(1000)
        self.boxes(999)
        self.overlaps(999, "hand")
        self.overlaps(997)
        self.assertFalse(self.has_left())
        self.boxes(997, "hand")
        self.assertFalse(self.has_left())
        self.boxes(998)
        self.overlaps(998)
        self.assertTrue(self.has_left())

    def test_stamps_of_both_topics_go_back_equally_often(self):
        for first, second in ((self.boxes, self.overlaps), (self.overlaps, self.boxes)):
            with self.subTest(first.__name__):
                self.setUp()
                self.enter(1000)
                first(999)
                first(1001)
                second(1001)
                self.assertFalse(self.has_left())
                second(999)
                self.assertTrue(self.has_left())
                self.assertTrue(self.has_left(20))  # once

    def test_what_both_topics_know_counts_when_a_message_that_went_back_was_lost(self):
        for first, second in ((self.boxes, self.overlaps), (self.overlaps, self.boxes)):
            with self.subTest(first.__name__):
                self.setUp()
                self.enter(1000)
                first(999)
                first(1001)
                second(1001)
                self.assertFalse(self.has_left())
                self.assertTrue(self.has_left(20))

    def test_who_stays_incomplete_has_not_left_when_no_more_comes(self):
        self.enter(1000)
        self.boxes(1001)
        self.boxes(999, "hand")
        self.overlaps(1001)
        self.overlaps(999)
        self.assertFalse(self.has_left(40))
        self.assertNotIn(LEFT, self.told)

    def test_a_link_without_a_box_has_not_left(self):
        """As that of a neighbour that has ended, or one that is ignored since a reload."""
        self.enter(5)
        self.watch.take_boxes(AxisAlignedBoxArray(header=Header(stamp=rospy.Time(6))))
        self.overlaps(6)
        self.assertFalse(self.has_left())
        self.assertIn("link hand is not watched: it has no box any more", self.told)

    def test_a_publisher_that_is_missing_is_reported_once_it_stays_away(self):
        def look(periods, *missing):
            for _ in range(periods):
                self.watch.look_for(missing)
            return self.told
        self.assertEqual(look(50) + look(5, "/boxes") + look(50), [])
        alone = ["no zone is watched: nobody publishes /boxes"]
        self.assertEqual(look(50, "/boxes"), alone)
        self.assertEqual(look(50, "/boxes", "/overlaps"), alone)
        self.assertEqual(look(50), alone + ["zones are watched again"])
        self.assertEqual(look(50, "/boxes"), alone + ["zones are watched again"] + alone)

    def test_boxes_that_are_ahead_after_a_jump_stay_known(self):
        self.enter(1000)
        self.boxes(5)
        self.boxes(7)
        self.overlaps(5)
        self.assertTrue(self.has_left())


if __name__ == "__main__":
    rospy.init_node("safety_zone_test")
    rostest.rosrun("link_bounds", "safety_zone", "safety_zone_test")
