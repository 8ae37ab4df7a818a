#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clock that is absent, stands still, or jumps back and forth while tf goes on."""
import itertools
import threading
import time
import unittest

import rospy
import rostest
from bounds_testing import (Recorder, TfSender, at, box_link, box_of, load, names_of, transform,
                            wait_for)
from node_testing import (ARMS, DYNAMIC, NODE, STATIC, ArmsTf, Diagnostics, Repeater,
                          SimulatedClock, at_angles, shows)
from sensor_msgs.msg import JointState

CLOCKLESS = "/clockless"
TIMEOUT = 0.5  # ROS seconds
STILL = 3.0  # wall seconds
BACK_AGAIN = 0.5  # wall seconds in which boxes of a new era must appear
YEAR_2100 = rospy.Time(4102444800)
ONLY_STATIC = {name: 0 for name in STATIC}

SLIDE = ('<robot name="slide"><link name="rail"/>' + box_link("cart", (0.2, 0.2, 0.2)) +
         '<joint name="slide" type="prismatic"><parent link="rail"/><child link="cart"/>'
         '<axis xyz="1 0 0"/><limit lower="-99" upper="99" effort="1" velocity="2"/></joint></robot>')


class ClockTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.clock = SimulatedClock(Diagnostics())
        cls.tf = ArmsTf()
        cls.now = 0

    def setUp(self):
        """Sets the clock forward, to a time that no other test uses."""
        load(NODE, ARMS, timeout=TIMEOUT)
        ClockTest.now += 10000
        self.clock.set(self.now)
        self.boxes.clear()

    def send(self, seconds, degrees=30, links=tuple(DYNAMIC)):
        self.tf.send(at(seconds), degrees, links)

    def wait_for(self, seconds, degrees=30):
        return self.boxes.wait(lambda m: m.header.stamp == at(seconds) and
                               shows(m, at_angles(degrees, degrees)), "time %g" % seconds)

    def test_absent(self):
        load(CLOCKLESS, ARMS, timeout=TIMEOUT)
        boxes = Recorder(CLOCKLESS + "/boxes")
        boxes.wait(lambda m: True, "the latched message")
        wait_for(lambda: self.tf.listeners() == 2, "both nodes listen")
        for degrees, seconds in ((30, self.now), (45, self.now + 1)):
            self.send(seconds, degrees)
            boxes.wait(lambda m: m.header.stamp == at(seconds) and
                       shows(m, at_angles(degrees, degrees)), "boxes without a clock")
        end = time.monotonic() + STILL
        wait_for(lambda: time.monotonic() > end, "some time")
        self.assertEqual(boxes.messages[-1].incomplete, [])

    def test_paused(self):
        """Nothing becomes stale while time stands still, and what tf accepts is published."""
        self.send(self.now)
        first = self.wait_for(self.now)
        end = time.monotonic() + STILL
        count = 0
        while time.monotonic() < end:
            count += 1
            self.clock.publish(self.now)
            self.send(self.now + 0.001 * count, 45, ["right"])
            stamp = at(self.now + 0.001 * count)
            self.boxes.wait(lambda m, s=stamp: box_of(m, "right") and box_of(m, "right").stamp == s,
                            "the right arm")
        later = self.boxes.messages[self.boxes.messages.index(first) + 1:]
        self.assertTrue(all(shows(m, at_angles(30, 45)) for m in later))
        self.clock.publish(self.now + 2 * TIMEOUT)
        self.boxes.wait(lambda m: shows(m, ONLY_STATIC, DYNAMIC), "stale links when it goes on")

    def test_back_and_forth(self):
        """The sender changes its stamps at once; the node may receive the new clock later."""
        era = {"now": self.now, "degrees": 30}
        lock = threading.Lock()

        def tick():
            with lock:
                era["now"] += 0.02
                self.clock.publish(era["now"])
                self.send(era["now"], era["degrees"])
        sender = Repeater(50, tick)
        self.addCleanup(sender.stop)
        for i, jump in enumerate((100, -150, 300, -20, -1, 5, -500)):
            degrees = (45, 30)[i % 2]
            with lock:
                era.update(now=era["now"] + jump, degrees=degrees)
                begin, start = era["now"], time.monotonic()
                self.boxes.clear()
            first = self.boxes.wait(lambda m: shows(m, at_angles(degrees, degrees)) and
                                    abs((m.header.stamp - at(begin)).to_sec()) < 1, "new boxes")
            self.assertLess(time.monotonic() - start, BACK_AGAIN, "after a jump by %g s" % jump)
            self.check_no_return(first, degrees)

    def test_joint_states_of_before_a_jump(self):
        """As with tf: one that comes after it, of five seconds ahead, would make the cart fast."""
        load(NODE, SLIDE, timeout=TIMEOUT, joint_states=True, velocity_window=0.1,
             deceleration={"slide": 2.0}, acceleration={"slide": 2.0})
        stopping = Recorder(NODE + "/stopping")
        joints = rospy.Publisher("joint_states", JointState, queue_size=1000, tcp_nodelay=True)
        self.addCleanup(joints.unregister)
        tf = TfSender()
        self.addCleanup(tf.end)
        tf.wait_for_listener()

        def report(seconds, x):
            message = JointState(name=["slide"], position=[x], velocity=[0.1])
            message.header.stamp = at(seconds)
            joints.publish(message)

        def send(seconds, x):
            """The driver is later than tf."""
            self.clock.publish(seconds)
            report(seconds - 0.02, x - 0.002)
            tf.send(transform("rail", "cart", at(seconds), (x, 0, 0)))

        def boxes_since(begin):
            return [box_of(m, "cart") for m in stopping.messages if box_of(m, "cart") and
                    0 <= (box_of(m, "cart").stamp - at(begin)).to_sec() < 2]

        def drive(begin):
            ticks = itertools.count()

            def has_boxes():
                tick = next(ticks)
                send(begin + 0.01 * tick, 0.001 * tick)
                if begin < self.now and tick < 50:  # its stamp is before the jump
                    report(self.now + 1, 0.1)
                return tick > 60 and len(boxes_since(begin)) > 10
            wait_for(has_boxes, "boxes from %g s on" % begin)
            return max(box.max.x - box.min.x for box in boxes_since(begin))

        self.assertLess(drive(self.now), 1)
        self.assertLess(drive(self.now - 5), 1)

    def check_no_return(self, first, degrees):
        """All further messages are of the new era."""
        def later():
            messages = self.boxes.messages
            return messages[messages.index(first):]
        wait_for(lambda: len(later()) > 10, "more messages")
        for message in later():
            self.assertTrue(shows(message, at_angles(degrees, degrees)), message)

    def test_a_jump_back_heals_a_stamp_of_2100(self):
        self.send(self.now)
        self.wait_for(self.now)
        self.boxes.clear()
        self.tf.send(YEAR_2100, 30, ["left"])
        self.boxes.wait(lambda m: "left_tip" in m.incomplete, "the block")
        self.send(self.now + 0.1, links=["left_tip", "right"])
        self.boxes.clear()
        self.clock.publish(self.now - 5)
        self.boxes.wait(lambda m: names_of(m) == STATIC, "loss of dynamic boxes")
        self.send(self.now - 5, 45)
        self.wait_for(self.now - 5, 45)

    def test_stamps_of_2100_right_after_a_jump_are_dropped(self):
        self.send(self.now)
        self.wait_for(self.now)
        self.boxes.clear()
        self.clock.publish(self.now - 5)
        self.boxes.wait(lambda m: names_of(m) == STATIC, "loss of dynamic boxes")
        self.tf.send(YEAR_2100, 30, ["left"])
        self.send(self.now - 5, 45)
        self.wait_for(self.now - 5, 45)


if __name__ == "__main__":
    rospy.init_node("clock_test")
    rostest.rosrun("link_bounds", "clock", ClockTest)
