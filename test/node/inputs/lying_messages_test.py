#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages and requests that announce more than they have: each is refused with a line that names
topic and sender, takes no memory, and the next message is read."""
import re
import unittest

import rospy
import rostest
from bounds_testing import DEADLINE, Recorder, names_of, wait_for
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from link_bounds.srv import CheckPath, CheckPathRequest, GetBoxes, GetBoxesRequest
from node_testing import ARMS, ArmsTf, NodeProcess
from raw_messages import as_bytes, serialized
from std_msgs.msg import Header
from visualization_msgs.msg import Marker, MarkerArray

MEBIBYTE = 1 << 20
MAX_GROWTH = 100 * MEBIBYTE  # of the peak; each lie announces more than 1000
HUGE = 50000000  # elements


def lying(message, place):
    """Like the message, but the four bytes there announce a huge length."""
    data = serialized(message)
    return as_bytes(message, data[:place] + HUGE.to_bytes(4, "little") + data[place + 4:])


def cube(number):
    marker = Marker(header=Header(frame_id="base"), ns="cube", id=number, type=Marker.CUBE)
    marker.pose.orientation.w = 1
    marker.scale.x = marker.scale.y = marker.scale.z = 1
    return marker


def neighbour(name):
    message = AxisAlignedBoxArray(header=Header(frame_id="base"))
    message.boxes = [AxisAlignedBox(name=name)]
    message.boxes[0].max.x = message.boxes[0].max.y = message.boxes[0].max.z = 1
    return message


class LyingMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.set_param("/robot_description", ARMS)
        cls.node = NodeProcess("strict", timeout=0.0)
        cls.boxes = Recorder(cls.node.name + "/boxes")
        cls.tf = ArmsTf()
        cls.tf.send(rospy.Time(1000))
        cls.boxes.wait(lambda m: "left" in names_of(m), "boxes")

    @classmethod
    def tearDownClass(cls):
        cls.node.end()

    def peak(self):
        with open("/proc/%d/status" % self.node.pid) as status:
            return int(re.search(r"VmHWM:\s+(\d+) kB", status.read()).group(1)) << 10

    def lines(self, name):
        return re.findall('a message on "%s" from "%s" is refused: .*' % (name, rospy.get_name()),
                          self.node.output)

    def check(self, name, send_lie, send_good):
        before = self.peak()
        for _ in range(3):
            send_lie()
        send_good()
        wait_for(lambda: self.lines(name), "a line about " + name)
        self.assertEqual(len(self.lines(name)), 1, self.node.output)
        self.assertLess(self.peak() - before, MAX_GROWTH)
        self.assertNotIn("unexpected", self.node.output)

    def check_topic(self, name, lie, good, box):
        sender = rospy.Publisher("%s/%s" % (self.node.name, name[1:]), type(good), queue_size=10)
        wait_for(lambda: sender.get_num_connections() == 1, "a connection")

        def send_good():
            sender.publish(good)
            self.boxes.wait(lambda m: box in names_of(m), box)

        self.check(name, lambda: sender.publish(lie), send_good)

    def test_objects(self):
        self.check_topic("~objects", lying(MarkerArray(), 0), MarkerArray([cube(1)]), "cube/1")

    def test_points_of_an_object(self):
        lie = cube(2)
        place = len(serialized(lie)) - 4 * 4 - 1  # before points, colors, text, mesh_resource
        self.check_topic("~object", lying(lie, place), cube(2), "cube/2")

    def test_neighbours(self):
        lie = lying(AxisAlignedBoxArray(), 16)  # after the header
        self.check_topic("~neighbours", lie, neighbour("arm"), rospy.get_name() + "/arm")

    def test_requests(self):
        good = CheckPathRequest()
        good.trajectory.joint_names = ["none"]
        for service, kind, request, place in (
                ("get_boxes", GetBoxes, GetBoxesRequest(), 20),       # after stamp, span and frame
                ("check_path", CheckPath, good, 16),                  # after the header
                ("check_path", CheckPath, CheckPathRequest(), 20)):   # the points
            with self.subTest(service):
                self.check_requests(service, kind, lying(request, place))

    def check_requests(self, service, kind, lie):
        name = self.node.name + "/" + service
        rospy.wait_for_service(name, DEADLINE)
        ask = rospy.ServiceProxy(name, kind)

        def ask_lying():
            answer = ask.call(lie)
            self.assertFalse(answer.success)
            self.assertRegex(answer.message, "the request is refused: it is shorter than it says")

        def ask_well():
            self.assertNotRegex(ask().message, "refused")

        self.check("~" + service, ask_lying, ask_well)


if __name__ == "__main__":
    rospy.init_node("lying_messages_test")
    rostest.rosrun("link_bounds", "lying_messages", LyingMessages)
