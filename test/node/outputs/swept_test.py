#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~swept: the boxes of the last swept_span seconds, as ~get_boxes gives them; and their markers."""
import rospy
import rostest
from arms_testing import ArmsTest
from bounds_testing import DEADLINE, Recorder, box_of, corners_of, latched, load, names_of, wait_for
from link_bounds.srv import GetBoxes, GetBoxesRequest
from node_testing import ALL, DYNAMIC, NODE, STATIC, arm_bounds
from visualization_msgs.msg import Marker, MarkerArray

SPAN = 2.0  # s
NEAR = 1e-9  # m
POINTS_PER_BOX = [36, 24]  # of faces and edges


def contains(outer, inner):
    return (all(outer[i] <= inner[i] + NEAR for i in range(3)) and
            all(outer[i] >= inner[i] - NEAR for i in range(3, 6)))


class SweptTest(ArmsTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rospy.wait_for_service(NODE + "/get_boxes", DEADLINE)
        cls.call = rospy.ServiceProxy(NODE + "/get_boxes", GetBoxes)

    def setUp(self):
        super().setUp()
        load(NODE, swept_span=SPAN)

    def listen(self, topic="/swept", message_type=None):
        recorder = Recorder(NODE + topic, message_type) if message_type else Recorder(NODE + topic)
        self.addCleanup(recorder.subscriber.unregister)
        wait_for(lambda: recorder.subscriber.get_num_connections() > 0, "connected")
        return recorder

    def turn_arms(self):
        """During the last two seconds from 30 over 60 to 90 degrees."""
        for angle in (30, 60, 90):
            self.send_good(angle, angle)

    def newest_of(self, recorder):
        """All that has been sent until now is in it."""
        stamp = rospy.Time(self.now)
        return recorder.wait(lambda m: m.header.stamp == stamp, "boxes of %g s" % self.now)

    def test_equals_what_the_service_gives(self):
        swept = self.listen()
        self.turn_arms()
        message = self.newest_of(swept)
        answer = self.call(GetBoxesRequest(span=rospy.Duration(SPAN)))
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(message.boxes, answer.boxes.boxes)
        self.assertEqual((names_of(message), message.incomplete), (ALL, []))
        self.assertEqual(message.header.frame_id, "base")
        for box in message.boxes:
            self.assertEqual(box.stamp, rospy.Time(0 if box.name in STATIC else self.now))
            for angle in range(30, 91, 5):
                self.assertTrue(contains(corners_of(box), arm_bounds(box.name, angle)), box.name)

    def test_a_new_subscriber_gets_one_while_nothing_moves(self):
        self.turn_arms()
        first, second = latched(NODE + "/swept"), latched(NODE + "/swept")
        self.assertEqual(first.boxes, second.boxes)
        self.assertEqual(first.header.stamp, rospy.Time(self.now))

    def test_motions_that_tf_does_not_know_are_incomplete(self):
        swept = self.listen()
        self.turn_arms()
        self.newest_of(swept)
        load(NODE, swept_span=100.0)
        message = swept.wait(lambda m: m.incomplete, "a span longer than the history")
        self.assertEqual((names_of(message), message.incomplete), (STATIC, DYNAMIC))

    def test_is_silent_without_a_span(self):
        load(NODE)
        swept = self.listen()
        self.turn_arms()
        self.assertEqual(swept.messages, [])
        load(NODE, swept_span=SPAN)
        self.assertEqual(names_of(self.newest_of(swept)), ALL)

    def test_markers(self):
        self.turn_arms()
        recorder = self.listen("/swept_markers", MarkerArray)
        boxes = self.newest_of(self.listen())
        markers = recorder.wait(
            lambda m: m.markers[0].header.stamp == rospy.Time(self.now), "markers").markers
        self.assertEqual([m.action for m in markers], [Marker.ADD] * 2)
        self.assertEqual([m.ns for m in markers], ["link_bounds/swept"] * 2)
        self.assertEqual([len(m.points) for m in markers], [n * len(ALL) for n in POINTS_PER_BOX])
        for marker in markers:
            self.assertLess(marker.color.a, 1)
            highest = max(point.z for point in marker.points)
            self.assertEqual(highest, max(box.max.z for box in boxes.boxes))
        self.assertGreater(box_of(boxes, "mast").max.z, 0)
        load(NODE)
        recorder.wait(lambda m: all(x.action == Marker.DELETE for x in m.markers), "no markers")


if __name__ == "__main__":
    rospy.init_node("swept_test")
    rostest.rosrun("link_bounds", "swept", SweptTest)
