#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bag that is played with its clock, and paused: ~stopping goes by the stamps of tf alone."""
import os
import shutil
import subprocess
import tempfile
import time
import unittest

import rosbag
import rospy
import rostest
from bounds_testing import (DEADLINE, Recorder, box_link, box_of, latched, load, transform,
                            wait_for)
from node_testing import NODE
from rosgraph_msgs.msg import Clock
from std_srvs.srv import SetBool
from tf2_msgs.msg import TFMessage

SLIDE = ('<robot name="slide">' + box_link("rail", (0.2, 0.2, 0.2)) +
         box_link("cart", (0.2, 0.2, 0.2)) +
         '<joint name="slide" type="prismatic"><parent link="rail"/><child link="cart"/><axis '
         'xyz="1 0 0"/><limit lower="-5" upper="5" effort="1" velocity="2"/></joint></robot>')
SPEED, DECELERATION, REACTION = 0.5, 2.0, 0.2
WAY = SPEED * REACTION + SPEED ** 2 / (2 * DECELERATION)  # m until the cart stands
BEGIN, LENGTH, PERIOD = 1000.0, 3.0, 0.01  # s, of the bag
PAUSE_AT = BEGIN + 1.0  # s, of the clock
TIMEOUT = 0.5  # ROS seconds
STILL = 1.5  # wall seconds, in which a wall clock would call all stale
NEAR = 1e-6  # m
PLAYER = "/player"


def place_at(stamp):
    """Of the cart [m]."""
    return SPEED * (stamp.to_sec() - BEGIN)


def write_bag(path):
    with rosbag.Bag(path, "w") as bag:
        for index in range(round(LENGTH / PERIOD)):
            stamp = rospy.Time.from_sec(BEGIN + PERIOD * index)
            bag.write("/tf", TFMessage([transform("rail", "cart", stamp, (place_at(stamp), 0, 0))]),
                      stamp)


class StoppingBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load(NODE, SLIDE, timeout=TIMEOUT, deceleration={"slide": DECELERATION},
             reaction_time=REACTION)
        folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, folder)
        bag = os.path.join(folder, "cart.bag")
        write_bag(bag)
        cls.boxes = Recorder(NODE + "/boxes")
        cls.stopping = Recorder(NODE + "/stopping")
        cls.clock = Recorder("/clock", Clock)
        wait_for(lambda: cls.stopping.subscriber.get_num_connections() > 0, "connected")
        player = subprocess.Popen(
            ["rosbag", "play", "--clock", "--quiet", "--wait-for-subscribers", bag,
             "__name:=" + PLAYER[1:]], stdin=subprocess.DEVNULL)
        cls.addClassCleanup(player.wait)
        cls.addClassCleanup(player.terminate)
        cls.clock.wait(lambda m: m.clock.to_sec() > PAUSE_AT, "a second of the bag")
        cls.pause(True)
        cls.during = cls.look_while_paused()
        cls.pause(False)
        end = BEGIN + LENGTH - PERIOD
        for recorder in (cls.stopping, cls.boxes):
            recorder.wait(lambda m: abs(m.header.stamp.to_sec() - end) < PERIOD / 2, "the end")

    @staticmethod
    def pause(is_paused):
        name = PLAYER + "/pause_playback"
        rospy.wait_for_service(name, DEADLINE)
        assert rospy.ServiceProxy(name, SetBool)(is_paused).success

    @classmethod
    def look_while_paused(cls):
        """What a new subscriber gets when the clock has stood still for long."""
        seen = len(cls.clock.messages)
        end = time.monotonic() + STILL
        wait_for(lambda: time.monotonic() > end and len(cls.clock.messages) > seen + 10,
                 "some time")
        standing = {message.clock for message in cls.clock.messages[seen + 5:]}
        assert len(standing) == 1, standing
        cls.stopping.subscriber.unregister()
        message = latched(NODE + "/stopping")
        received = cls.stopping.messages
        cls.stopping = Recorder(NODE + "/stopping")
        cls.before = received
        return message

    def messages(self):
        return self.before + [self.during] + self.stopping.messages

    def test_the_cart_reaches_what_its_stamp_says(self):
        """Neither the pause nor the time after it changes its speed."""
        complete = [m for m in self.messages() if not m.incomplete and box_of(m, "cart")]
        self.assertGreater(len(complete), 50)
        for message in complete:
            cart = box_of(message, "cart")
            place = place_at(cart.stamp)
            self.assertAlmostEqual(cart.min.x, place - 0.1, delta=NEAR)
            self.assertAlmostEqual(cart.max.x, place + 0.1 + WAY, delta=NEAR)

    def test_nothing_is_incomplete_once_the_speed_is_known(self):
        for messages in (self.messages(), self.boxes.messages):
            first = next(i for i, m in enumerate(messages) if box_of(m, "cart"))
            self.assertEqual([m.incomplete for m in messages[first:] if m.incomplete], [])

    def test_the_pause_is_in_the_middle(self):
        stamp = self.during.header.stamp.to_sec()
        self.assertGreater(stamp, PAUSE_AT - 0.5)
        self.assertLess(stamp, BEGIN + LENGTH - 0.5)
        self.assertTrue(box_of(self.during, "cart"))


if __name__ == "__main__":
    rospy.init_node("stopping_bag_test")
    rostest.rosrun("link_bounds", "stopping_bag", StoppingBag)
