#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program cloud_filter: a gripper that moves past a cup, late transforms, and clouds that lie."""
import itertools
import math
import os
import resource
import struct
import subprocess
import unittest

import rospy
import rostest
from bounds_testing import (Recorder, TfSender, box_link, executable, robot, transform, wait_for)
from cloud_testing import wait_status
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Point
from link_bounds.msg import Distance, DistanceArray
from node_testing import SANITIZED, Repeater
from raw_messages import as_bytes, serialized
from sensor_msgs.msg import LaserScan, PointCloud2, PointField
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

SPEED = 1.0  # m/s along x
HAND = robot([box_link("base", (0.2, 0.2, 0.1)), box_link("left", (0.02, 0.02, 0.1), (0, 0.05, 0)),
              box_link("right", (0.02, 0.02, 0.1), (0, -0.05, 0))],
             [("base", "left"), ("base", "right")])
LEFT, BETWEEN, BASE, FAR = (0, 0.05, 0), (0, 0, 0), (-1, 0, 0), (0, 0, 2)
PLACES = [LEFT, BETWEEN, (0, -0.05, 0.055), BASE, FAR, (0, 0.0725, 0)]
IS_ROBOT = [True, False, True, True, False, False]
SPARE_SPACE = 50_000_000  # bytes of addresses; the stacks of 63 threads take more


def moved(place, seconds):
    """Where a point of the hand is in the sensor's frame."""
    return (place[0] + SPEED * seconds, place[1], place[2])


def cloud(stamp, points, frame="sensor"):
    """`points` are ((x, y, z), nanoseconds after the stamp)."""
    message = PointCloud2()
    message.header.stamp, message.header.frame_id = stamp, frame
    message.height, message.width, message.point_step = 1, len(points), 20
    message.row_step = message.width * message.point_step
    message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
    message.fields.append(PointField("t", 16, PointField.UINT32, 1))
    message.data = b"".join(struct.pack("<fffII", *place, 7, time) for place, time in points)
    return message


def places_of(message):
    return [struct.unpack_from("<fff", message.data, i * message.point_step)
            for i in range(message.width * message.height)]


def cut_off(message):
    return as_bytes(message, serialized(message)[:-1])


def address_space(pid):
    """Of a process [bytes]."""
    with open("/proc/%d/statm" % pid, encoding="ascii") as file:
        return int(file.read().split()[0]) * resource.getpagesize()


class CloudFilter(unittest.TestCase):
    newest = rospy.Time()  # of all transforms that were sent

    @classmethod
    def setUpClass(cls):
        cls.output = Recorder("/cloud_filter/output", PointCloud2)
        cls.compact = Recorder("/compact_filter/output", PointCloud2)
        cls.removed = Recorder("/cloud_filter/robot_points", PointCloud2)
        cls.nearest = Recorder("/cloud_filter/nearest", DistanceArray)
        cls.prefixed = Recorder("/prefixed_filter/output", PointCloud2)
        cls.late = Recorder("/late_filter/output", PointCloud2)
        cls.objects = rospy.Publisher("/cloud_filter/objects", MarkerArray, queue_size=100)
        cls.scans = Recorder("/cloud_filter/output_scan", LaserScan)
        cls.status = Recorder("/diagnostics", DiagnosticArray)
        cls.clouds = rospy.Publisher("/cloud", PointCloud2, queue_size=100)
        cls.scan = rospy.Publisher("/scan", LaserScan, queue_size=100)
        cls.tf, cls.tf_static = TfSender(), TfSender(is_static=True)
        wait_status(cls.status, "/cloud_filter", lambda status: status.level == 2)  # no robot yet
        rospy.set_param("/robot_description", HAND)
        for name in ("/cloud_filter", "/compact_filter", "/prefixed_filter", "/late_filter"):
            wait_status(cls.status, name, lambda status: status.level == 1 and
                        status.message.startswith("no cloud or scan has been filtered"))
        wait_status(cls.status, "/blind_filter", lambda status: status.level == 2 and
                    status.message.startswith("no link of the robot is filtered"))
        cls.tf.wait_for_listener()
        cls.tf_static.wait_for_listener()
        wait_for(lambda: cls.clouds.get_num_connections() >= 4, "the filters listen")
        wait_for(lambda: cls.objects.get_num_connections() >= 1, "the filter listens to objects")
        wait_for(lambda: cls.scan.get_num_connections() >= 1, "the filter listens to scans")
        cls.tf_static.send(transform("sensor", "base", rospy.Time(), BASE),
                           transform("sensor", "one/base", rospy.Time(), BASE))

    def setUp(self):
        for recorder in (self.output, self.compact, self.removed, self.scans, self.nearest,
                         self.prefixed, self.late, self.status):
            recorder.clear()
        self.stamp = self.first_stamp = self.next_stamp()

    def messages_of_this_test(self, recorder):
        """Without those of an earlier test that come only now; without a stamp, none is earlier."""
        return [m for m in recorder.messages
                if m.header.stamp.is_zero() or m.header.stamp >= self.first_stamp]

    def next_stamp(self):
        """Later than all that was sent, so that no transform of the next way is late."""
        return max(rospy.Time.now(), self.newest + rospy.Duration(0.2))

    def send_tf(self, begin, end, prefix=""):
        """The way of the hand; it is where the sensor is at the stamp."""
        type(self).newest = max(self.newest, self.stamp + rospy.Duration(end))
        for i in range(round(begin * 50), round(end * 50) + 1):
            stamp = self.stamp + rospy.Duration(i / 50)
            self.tf.send(*[transform("sensor", prefix + finger, stamp, (SPEED * i / 50, 0, 0))
                           for finger in ("left", "right")])

    def check(self, expected, send):
        """The labels of both filters: NaN where the robot is, or nothing."""
        send()
        output = self.output.wait(lambda m: m.header.stamp == self.stamp, "the filtered cloud")
        compact = self.compact.wait(lambda m: m.header.stamp == self.stamp, "the compact cloud")
        places = places_of(output)
        self.assertEqual([math.isnan(place[0]) for place in places], expected)
        self.assertEqual(places_of(compact), [p for p in places if not math.isnan(p[0])])
        removed = self.removed.wait(lambda m: m.header.stamp == self.stamp, "the robot's points")
        self.assertEqual(removed.width, sum(expected))

    def test_what_lies_between_the_fingers_is_kept(self):
        self.send_tf(-0.1, 0.3)
        self.status.clear()
        self.check(IS_ROBOT, lambda: self.clouds.publish(
            cloud(self.stamp, [(place, 0) for place in PLACES])))
        wait_status(self.status, "/cloud_filter", lambda status: status.message == "filtering",
                    is_new=False)

    def test_each_point_has_its_own_time(self):
        self.send_tf(-0.1, 0.3)
        late = [(moved(place, 0.09) if place != BASE else BASE, 90000000) for place in PLACES]
        # By the stamp alone, the next one would be the robot's; the hand has left that place.
        left_behind = [(LEFT, 90000000), (moved(LEFT, 0.09), 0)]
        self.check(IS_ROBOT + [False, False],
                   lambda: self.clouds.publish(cloud(self.stamp, late + left_behind)))

    def wait_of_a_cloud(self):
        """That of a filter until tf comes, which the other one has passed on without [ms]."""
        self.stamp = self.next_stamp()
        self.send_tf(-0.1, -0.02)
        self.clouds.publish(cloud(self.stamp, [(LEFT, 0)]))
        passed = self.compact.wait(lambda m: m.header.stamp == self.stamp, "the passed cloud")
        self.assertEqual(passed.width, 1)
        self.status.clear()
        self.send_tf(0, 0.1)
        output = self.output.wait(lambda m: m.header.stamp == self.stamp, "the cloud that waited")
        self.assertTrue(math.isnan(places_of(output)[0][0]))
        waits = []
        wait_status(self.status, "/cloud_filter", lambda status: waits.extend(
            float(value.value) for value in status.values
            if value.key == "wait for tf and turn, max [ms]") or waits, is_new=False)
        return max(waits)

    def test_a_cloud_waits_for_tf(self):
        """A busy machine may give the cloud to the filter only when tf is there."""
        wait_for(lambda: self.wait_of_a_cloud() > 50, "a cloud waits for longer than 50 ms")

    def test_a_message_larger_than_all_that_may_wait_is_told(self):
        """By its intensities alone."""
        self.send_tf(-0.1, 0.1)
        scan = LaserScan(range_min=0.01, range_max=10, ranges=[1])
        scan.header.stamp, scan.header.frame_id = self.stamp, "sensor"
        count = 65_000_000
        self.scan.publish(as_bytes(scan, serialized(scan)[:-4] + struct.pack("<I", count) +
                                   bytes(4 * count)))
        self.wait_refused("larger than 256 MB")
        self.assertEqual(self.messages_of_this_test(self.scans), [])

    def test_tf_that_ends(self):
        self.send_tf(-0.1, 0)
        self.clouds.publish(cloud(self.stamp + rospy.Duration(0.05), [(LEFT, 0)]))
        self.wait_refused("does not cover the span")
        self.assertEqual(self.messages_of_this_test(self.output), [])

    def test_more_clouds_than_can_wait_for_tf_are_late(self):
        self.send_tf(-0.1, 0)
        stamps = [self.stamp + rospy.Duration(0.001 * i) for i in range(1, 66)]
        self.clouds.publish(cloud(stamps[0], [(LEFT, 0)]))
        filters = "/cloud_filter", "/late_filter"
        for name in filters:
            wait_status(self.status, name, lambda status: any(
                (value.key, value.value) == ("waiting", "1") for value in status.values), False)
        # At once no more than an input's queue holds. The last ones are more than a status has rows
        # for reasons, and their times differ.
        for begin, end in (1, 33), (33, 65):
            for stamp in stamps[begin:end]:
                self.clouds.publish(cloud(stamp, [(LEFT, 0)]))
            for name in filters:
                wait_for(lambda n=name, count=end - 32:
                         self.refused("does not cover the span", n) == count,
                         "those that cannot wait are counted, and why")
        self.late.wait(lambda m: m.header.stamp == stamps[32], "the last late one is passed")
        self.assertEqual([m.header.stamp for m in self.messages_of_this_test(self.late)], stamps[:33])
        self.send_tf(0, 0.1)
        self.output.wait(lambda m: m.header.stamp == stamps[-1], "the last cloud")
        # The newest ones are left, in their order.
        self.assertEqual([m.header.stamp for m in self.messages_of_this_test(self.output)], stamps[-32:])
        self.assertEqual(self.refused("more clouds came"), 0)

    def test_a_late_cloud_that_cannot_be_read_is_not_passed(self):
        self.send_tf(-0.1, 0)
        stamps = [self.stamp + rospy.Duration(0.001 * i) for i in range(1, 35)]
        self.clouds.publish(cloud(stamps[0], [(LEFT, 0)]))
        wait_status(self.status, "/late_filter", lambda status: any(
            (value.key, value.value) == ("waiting", "1") for value in status.values), False)
        for i, stamp in enumerate(stamps[1:]):
            message = cloud(stamp, [(LEFT, 0)])
            message.is_bigendian = i == 0
            self.clouds.publish(message)
        wait_for(lambda: self.refused("big-endian", "/late_filter") == 1, "why it is dropped")
        self.assertEqual([m.header.stamp for m in self.messages_of_this_test(self.late)], stamps[:1])
        self.send_tf(0, 0.1)
        self.late.wait(lambda m: m.header.stamp == stamps[-1], "the last cloud")

    def test_the_nearest_point_of_what_remains(self):
        self.send_tf(-0.1, 0.1)
        self.clouds.publish(cloud(self.stamp, [(LEFT, 0), (BETWEEN, 0), (FAR, 0)]))
        message = self.nearest.wait(lambda m: m.header.stamp == self.stamp, "the nearest points")
        self.assertEqual([(d.first, d.second) for d in message.distances],
                         [("base", "cloud"), ("left", "cloud"), ("right", "cloud")])
        self.assertEqual(message.incomplete, [])
        left = message.distances[1]
        self.assertLessEqual(left.distance, 0.04)
        self.assertAlmostEqual(left.distance, 0.04, delta=1e-5)
        self.assertAlmostEqual(left.distance_max, 0.04, delta=1e-5)
        self.assertAlmostEqual(left.on_first.y, 0.04, delta=1e-5)
        self.assertAlmostEqual(left.normal.y, -1, delta=1e-4)
        self.assertEqual((left.stamp, left.level), (self.stamp, Distance.HULL))
        self.assertAlmostEqual(message.distances[0].distance, 0.9, delta=1e-5)

    def is_kept(self, place):
        """Whether the filter keeps a point at that place, now."""
        self.output.clear()
        self.stamp = self.next_stamp()
        self.send_tf(-0.02, 0.02)
        self.clouds.publish(cloud(self.stamp, [(place, 0)]))
        output = self.output.wait(lambda m: m.header.stamp == self.stamp, "the filtered cloud")
        return not math.isnan(places_of(output)[0][0])

    def test_a_marker_that_follows_a_link_is_the_robots(self):
        marker = Marker(ns="held", id=1, type=Marker.CUBE, frame_locked=True)
        marker.header.frame_id, marker.header.stamp = "left", rospy.Time.now()
        marker.pose.orientation.w = 1
        marker.scale.x = marker.scale.y = marker.scale.z = 0.02
        stranger = Marker(ns="scene", id=1, type=Marker.CUBE, frame_locked=True)
        stranger.header.frame_id, stranger.scale = "sensor", marker.scale
        stranger.pose.orientation.w = 1
        self.objects.publish(MarkerArray([stranger]))
        self.assertTrue(self.is_kept(BETWEEN))
        self.objects.publish(MarkerArray([marker]))
        wait_for(lambda: not self.is_kept(BETWEEN), "the held object is filtered")
        self.assertTrue(self.is_kept((0, 0.0225, 0)))
        marker.action = Marker.DELETE
        self.objects.publish(MarkerArray([marker]))
        wait_for(lambda: self.is_kept(BETWEEN), "the object is forgotten")
        marker.action, marker.lifetime = Marker.ADD, rospy.Duration(1)

        def is_held_again():
            self.objects.publish(MarkerArray([marker]))  # which prolongs its life
            return not self.is_kept(BETWEEN)
        wait_for(is_held_again, "the held object is filtered again")
        wait_for(lambda: self.is_kept(BETWEEN), "its lifetime is over")

    def test_nearest_points_that_are_missing_are_told(self):
        """A thousand poses are enough for the links, but not for a point so far away."""
        for i in range(-5, 10):
            stamp = self.stamp + rospy.Duration(i / 50)
            self.tf.send(*[transform("sensor", finger, stamp, (0, 0, 0),
                                     (0, 0, math.sin(i / 2), math.cos(i / 2)))
                           for finger in ("left", "right")])
        type(self).newest = self.stamp + rospy.Duration(0.2)
        self.clouds.publish(cloud(self.stamp, [((900, 0, 0), 0), (FAR, 90000000)]))
        self.output.wait(lambda m: m.header.stamp == self.stamp, "the filtered cloud")
        wait_status(self.status, "/cloud_filter", lambda status: status.level == 1 and any(
            value.key.startswith("no ~nearest: the robot or the sensor moves so fast")
            for value in status.values), False)
        self.assertEqual(self.messages_of_this_test(self.nearest), [])

    def test_reload(self):
        reload_robot = rospy.ServiceProxy("/cloud_filter/reload", Trigger)
        self.assertFalse(self.is_kept(LEFT))
        rospy.set_param("/robot_description", "no robot")
        answer = reload_robot()
        self.assertFalse(answer.success)
        self.assertFalse(self.is_kept(LEFT))
        rospy.set_param("/robot_description", robot([box_link("base", (0.2, 0.2, 0.1))], []))
        answer = reload_robot()
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(self.is_kept(LEFT))
        rospy.set_param("/robot_description", HAND)
        self.assertTrue(reload_robot().success)
        self.assertFalse(self.is_kept(LEFT))

    def held(self, number, place, size):
        """A cube that follows the left finger."""
        marker = Marker(ns="held", id=number, type=Marker.CUBE, frame_locked=True)
        marker.header.frame_id, marker.header.stamp = "left", rospy.Time.now()
        marker.pose.orientation.w = 1
        marker.pose.position.x, marker.pose.position.y, marker.pose.position.z = place
        marker.scale.x = marker.scale.y = marker.scale.z = size
        return marker

    def incomplete_at(self, place):
        """What the nearest points say is incomplete, for a cloud of that point, now."""
        self.is_kept(place)
        return set(self.nearest.wait(lambda m: m.header.stamp == self.stamp, "the nearest").incomplete)

    def delete_held(self):
        self.objects.publish(MarkerArray([Marker(action=Marker.DELETEALL)]))

    def test_objects_that_are_not_filtered_are_told(self):
        """Too many, and one that cannot be used."""
        self.addCleanup(self.delete_held)
        markers = [self.held(i, (0, 0, 3), 0.001) for i in range(70)]
        stranger = self.held(98, (0, 0, 3), -1)
        stranger.header.frame_id = "sensor"
        self.objects.publish(MarkerArray(markers + [self.held(99, (0, 0, 3), -1), stranger]))
        left_out = {"held/%d" % i for i in range(64, 70)} | {"held/99"}

        wait_for(lambda: self.incomplete_at(FAR) == left_out, "those are incomplete")
        wait_status(self.status, "/cloud_filter", lambda status: status.level == 1 and left_out == {
            value.value.split()[1] for value in status.values if value.key == "problem"})

    def test_an_object_too_large_for_a_grid_is_told(self):
        self.addCleanup(self.delete_held)
        marker = self.held(7, (0, 0, 0), 1e29)
        marker.type = Marker.TRIANGLE_LIST
        marker.points = [Point(1e12, 0, 0), Point(0, 1e12, 0), Point(0, 0, 1e12)]
        self.objects.publish(MarkerArray([marker]))
        wait_for(lambda: self.incomplete_at(FAR) == {"held/7"}, "it is incomplete")
        wait_status(self.status, "/cloud_filter", lambda status: status.level == 1 and any(
            value.key == "problem" and "held/7 is not filtered" in value.value and
            "not finite" in value.value for value in status.values))

    def test_an_object_that_changes_all_the_time_is_filtered(self):
        """Its grid takes longer to be made than its shape lasts."""
        self.addCleanup(self.delete_held)
        place, sizes = (0, 0, 3), itertools.cycle((0.15, 0.151))
        changes = Repeater(30, lambda: self.objects.publish(
            MarkerArray([self.held(1, place, next(sizes))])))
        self.addCleanup(changes.stop)
        # Asking with clouds all the time would take the processor from what makes grids.
        wait_status(self.status, "/cloud_filter", lambda status: any(
            value.key == "problem" and "held/1" in value.value and
            "the old one counts" in value.value for value in status.values))
        self.assertFalse(self.is_kept(place))
        self.assertIn("held/1", self.incomplete_at(place))
        changes.stop()
        wait_for(lambda: not self.is_kept(place) and "held/1" not in self.incomplete_at(place),
                 "the last shape is filtered")

    def test_reload_forgets_a_stamp_of_the_future(self):
        future = self.stamp + rospy.Duration(3600)
        self.tf.send(*[transform("sensor", finger, future) for finger in ("left", "right")])
        self.send_tf(-0.1, 0.1)
        self.clouds.publish(cloud(self.stamp, [(LEFT, 0)]))
        self.wait_refused("does not cover the span")
        for name in ("cloud_filter", "compact_filter"):
            self.assertTrue(rospy.ServiceProxy("/%s/reload" % name, Trigger)().success)
        self.assertFalse(self.is_kept(LEFT))

    def test_transforms_that_are_far_apart_do_not_tell_the_way(self):
        self.send_tf(-0.1, 0)
        self.send_tf(1.5, 1.6)
        self.clouds.publish(cloud(self.stamp + rospy.Duration(0.7), [(LEFT, 0)]))
        self.wait_refused("longer than timeout")

    def test_a_prefix_and_the_shadow(self):
        self.send_tf(-0.1, 0.1, "one/")
        self.clouds.publish(cloud(self.stamp, [(place, 0) for place in PLACES]))
        output = self.prefixed.wait(lambda m: m.header.stamp == self.stamp, "the filtered cloud")
        # The last point is behind the left finger.
        self.assertEqual([math.isnan(place[0]) for place in places_of(output)],
                         IS_ROBOT[:-1] + [True])

    def refused(self, words, name="/cloud_filter"):
        """How many clouds were not filtered for that reason, in all statuses of this test."""
        return sum(int(value.value) for message in self.status.messages
                   for status in message.status if status.name == name + ": cloud filter"
                   for value in status.values
                   if value.key.startswith("not filtered") and words in value.key)

    def wait_refused(self, words):
        wait_for(lambda: self.refused(words) == 1, "one cloud is refused: " + words)

    def test_a_cloud_without_tf_is_dropped_and_counted(self):
        self.clouds.publish(cloud(self.stamp, [(LEFT, 0)], "nowhere"))
        self.wait_refused('tf does not know its frame "nowhere"')
        self.assertEqual(self.messages_of_this_test(self.output), [])

    def test_frames_that_differ_in_a_digit_have_a_row_each(self):
        for name in "nowhere_1", "nowhere_2":
            self.clouds.publish(cloud(self.stamp, [(LEFT, 0)], name))
        for name in "nowhere_1", "nowhere_2":
            self.wait_refused('tf does not know its frame "%s"' % name)

    def test_lies_are_refused_with_words(self):
        for field, value, words in (("point_step", 10, "field z"), ("row_step", 3, "row_step"),
                                    ("is_bigendian", True, "big-endian"), ("height", 9, "data")):
            message = cloud(self.stamp, [(LEFT, 0)] * 3)
            setattr(message, field, value)
            self.clouds.publish(message)
            self.wait_refused(words)
        self.clouds.publish(cloud(rospy.Time(), [(LEFT, 0)]))
        self.wait_refused("no stamp")
        self.assertEqual(self.messages_of_this_test(self.output), [])
        self.send_tf(-0.1, 0.1)
        self.stamp = self.stamp + rospy.Duration(0.01)
        self.clouds.publish(cloud(self.stamp, []))
        self.output.wait(lambda m: m.header.stamp == self.stamp and m.width == 0, "the empty cloud")

    def test_a_cloud_without_width_has_no_data(self):
        """And none has more than its rows."""
        for field in ("width", "height"):
            message = cloud(self.stamp, [(LEFT, 0)] * 3)
            setattr(message, field, 0)
            self.clouds.publish(message)
        wait_for(lambda: self.refused("60 bytes of data") == 2, "both are refused")
        message = cloud(self.stamp, [(LEFT, 0)] * 3)
        message.data += bytes(1)
        self.clouds.publish(message)
        self.wait_refused("61 bytes of data")
        self.assertEqual(self.messages_of_this_test(self.output), [])

    def test_ranges_of_a_scan_become_nan(self):
        self.send_tf(-0.1, 0.1)
        scan = LaserScan(angle_min=-math.pi, angle_increment=math.pi / 2, range_min=0.01,
                         range_max=10, ranges=[1, 0.05, 3, 0.05, 0.3])
        scan.header.stamp, scan.header.frame_id = self.stamp, "sensor"
        self.scan.publish(scan)
        ranges = self.scans.wait(lambda m: m.header.stamp == self.stamp, "the scan").ranges
        self.assertEqual([math.isnan(r) for r in ranges], [True, True, False, True, False])

    def test_messages_that_are_cut_off_are_counted(self):
        scan = LaserScan(ranges=[1])
        scan.header.stamp = self.stamp
        self.scan.publish(cut_off(scan))
        self.clouds.publish(cut_off(cloud(self.stamp, [(LEFT, 0)])))
        wait_for(lambda: self.refused("shorter than it says") == 2, "both are counted")

    def test_a_scan_without_limits_is_refused(self):
        for low, high in ((float("nan"), 10), (0.01, float("nan")), (0, 0), (3, 2)):
            self.status.clear()
            self.stamp = self.next_stamp()
            self.send_tf(-0.1, 0.1)
            scan = LaserScan(angle_increment=1, range_min=low, range_max=high, ranges=[1, 0.05])
            scan.header.stamp, scan.header.frame_id = self.stamp, "sensor"
            self.scan.publish(scan)
            self.wait_refused("range_min or range_max")

    @unittest.skipIf(SANITIZED, "a sanitizer claims more address space than any limit allows")
    def test_clouds_are_filtered_where_no_thread_can_start(self):
        """There is no address space for the stack of one."""
        name = "/limited"
        for key, value in (("threads", 64), ("max_wait", 3)):
            rospy.set_param("%s/%s" % (name, key), value)
        self.addCleanup(rospy.delete_param, name)
        output = Recorder(name + "/output", PointCloud2)
        clouds = rospy.Publisher(name + "/input", PointCloud2, queue_size=100)
        for end in (output.subscriber.unregister, clouds.unregister):
            self.addCleanup(end)
        senders = (self.tf, self.tf_static)
        before = [sender.listeners() for sender in senders]
        limited = subprocess.Popen([executable("link_bounds", "cloud_filter"),
                                    "__name:=limited"])
        self.addCleanup(limited.wait)
        self.addCleanup(limited.kill)
        wait_status(self.status, name, lambda status: status.message.startswith(
            "no cloud or scan has been filtered"))
        wait_for(clouds.get_num_connections, "the filter listens")
        for sender, count in zip(senders, before):
            wait_for(lambda s=sender, n=count: s.listeners() > n, "the filter listens to tf")
        points = [(LEFT, 0)] * 64

        def send():
            self.stamp = self.next_stamp()
            self.send_tf(-0.1, 0.1)
            clouds.publish(cloud(self.stamp, points))

        none = resource.RLIM_INFINITY
        resource.prlimit(limited.pid, resource.RLIMIT_AS,
                         (address_space(limited.pid) + SPARE_SPACE, none))
        send()
        message = output.wait(lambda _: True, "the cloud")
        self.assertEqual(message.header.stamp, self.stamp)
        self.assertTrue(all(math.isnan(place[0]) for place in places_of(message)))
        self.assertIsNone(limited.poll())

    def test_a_wrong_parameter_is_one_error(self):
        for name, value in (("padding", -1), ("late", "never"), ("threads", 0)):
            rospy.set_param("/wrong/" + name, value)
            run = subprocess.run([executable("link_bounds", "cloud_filter"), "__name:=wrong"],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=60, check=False)
            rospy.delete_param("/wrong/" + name)
            self.assertEqual(run.returncode, 1, run.stdout)
            self.assertIn("~%s" % name, run.stdout)
            self.assertIn("must be", run.stdout)

    def test_a_wrong_argument_does_no_harm_to_the_running_filter(self):
        """A node that registers would end the running one, and set the parameter for ever."""
        for argument, words in (("_padding:=abc", "~padding"), ("padding:=0.1", "_padding:=0.1"),
                                ("what", "see --help")):
            run = subprocess.run([executable("link_bounds", "cloud_filter"),
                                  "__name:=cloud_filter", argument], timeout=60, check=False,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(run.returncode, 1, run.stdout)
            self.assertIn(words, run.stdout)
        self.assertFalse(rospy.has_param("/cloud_filter/padding"))
        wait_status(self.status, "/cloud_filter", lambda status: True)

    def test_a_master_uri_that_ros_refuses(self):
        for arguments, uri in ((["__master:=localhost"], os.environ["ROS_MASTER_URI"]),
                               ([], "localhost")):
            run = subprocess.run([executable("link_bounds", "cloud_filter"), *arguments],
                                 env=dict(os.environ, ROS_MASTER_URI=uri), stderr=subprocess.PIPE,
                                 text=True, timeout=60, check=False)
            self.assertEqual(run.returncode, 1, run.stderr)
            self.assertIn('is "localhost"; it must be http://HOST:PORT', run.stderr)


if __name__ == "__main__":
    rospy.init_node("cloud_filter_test")
    rostest.rosrun("link_bounds", "cloud_filter_test", CloudFilter)
