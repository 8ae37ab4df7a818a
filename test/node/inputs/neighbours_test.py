#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Neighbours that end, fall silent or are killed; two robots through one relay or one bag player."""
import os
import shutil
import signal
import subprocess
import tempfile
import unittest

import genpy
import rosbag
import rospy
import rostest
from bounds_testing import Recorder, names_of, wait_for
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from node_testing import Diagnostics, NodeProcess
from std_msgs.msg import Header

LINKS = ["arm", "hand"]
COUNT = 100  # messages of each robot
PERIOD = 0.02  # s
FOREVER = 1000.0  # s; a timeout that no test waits for
SHORT = 0.5  # s
SENDERS = 5
PLAYER = shutil.which("rosbag")


def array_of(names, frame="map", incomplete=()):
    boxes = [AxisAlignedBox(name, rospy.Time(1), Point(0, 0, 0), Point(1, 1, 1)) for name in names]
    return AxisAlignedBoxArray(Header(frame_id=frame), boxes, list(incomplete))


def all_names(message):
    return names_of(message) + message.incomplete


class Neighbours(unittest.TestCase):
    def start(self, timeout):
        self.node = NodeProcess("neighbours_" + self._testMethodName, fixed_frame="map",
                                timeout=timeout)
        self.addCleanup(self.node.end)
        self.topic = self.node.name + "/neighbours"
        self.boxes = Recorder(self.node.name + "/boxes")
        self.addCleanup(self.boxes.subscriber.unregister)
        self.boxes.wait(lambda m: m.header.frame_id == "map" and not m.boxes, "an empty array")

    def bag_of(self, topic, messages):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, "robots.bag")
        with rosbag.Bag(path, "w") as bag:
            for i, message in enumerate(messages):
                bag.write(topic, message, genpy.Time.from_sec(1000 + i * PERIOD))
        return path

    def two_robots(self, topic):
        """A bag of two robots that take turns; the second one has no hand in the second half."""
        messages = []
        for i in range(COUNT):
            messages.append(array_of(["a_" + name for name in LINKS]))
            messages.append(array_of(["b_" + name for name in LINKS[:2 if i < COUNT // 2 else 1]]))
        return self.bag_of(topic, messages)

    def play(self, bag, name, *options):
        """Waits a second after the connection, so that no message is lost."""
        player = subprocess.Popen([PLAYER, "play", "-q", "-d", "1", *options, bag,
                                   "__name:=" + name], stdin=subprocess.DEVNULL,
                                  stdout=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(self.end, player, signal.SIGKILL)
        return player

    @staticmethod
    def end(player, signal_number):
        if player.poll() is None:
            os.killpg(player.pid, signal_number)
        player.wait(60)

    def expect_nothing(self):
        self.boxes.wait_newest(lambda m: not all_names(m), "nothing is left")

    def expect_both_robots(self, sender):
        full = {"%s/%s_%s" % (sender, robot, link) for robot in "ab" for link in LINKS}
        rest = full - {sender + "/b_hand"}
        self.boxes.wait(lambda m: set(names_of(m)) == full, "two robots")
        self.boxes.wait(lambda m: set(names_of(m)) == rest, "a box is gone")
        self.expect_nothing()
        shown = [set(all_names(m)) for m in self.boxes.messages]
        shown = shown[shown.index(full):]
        shown = shown[:shown.index(set())]
        begin = shown.index(rest)
        self.assertEqual([names for names in shown[:begin] if names != full], [])
        self.assertEqual([names for names in shown[begin:] if names != rest], [])

    def test_a_publisher_that_unregisters(self):
        self.start(FOREVER)
        sender = rospy.Publisher(self.topic, AxisAlignedBoxArray, queue_size=10, latch=True)
        sender.publish(array_of(LINKS, incomplete=["finger"]))
        self.boxes.wait(lambda m: len(m.boxes) == 2 and len(m.incomplete) == 1, "boxes")
        diagnostics = Diagnostics(self.node.name)
        for _ in range(2):  # by then the node has asked the master who that is
            diagnostics.wait_for_new(lambda *_: True, "a status")
        sender.unregister()
        self.expect_nothing()

    def test_many_short_lived_senders(self):
        self.start(FOREVER)
        bag = self.bag_of(self.topic, [array_of(LINKS, incomplete=["finger"])] * COUNT)
        players = [self.play(bag, "sender_%d" % i, "-l") for i in range(SENDERS)]
        names = {"/sender_%d/%s" % (i, link) for i in range(SENDERS) for link in LINKS}
        self.boxes.wait_newest(lambda m: set(names_of(m)) == names, "boxes of all")
        for player in players:
            self.end(player, signal.SIGINT)
        self.expect_nothing()

    def test_one_that_is_killed_is_silent_and_then_forgotten(self):
        self.start(SHORT)
        player = self.play(self.bag_of(self.topic, [array_of(LINKS)] * COUNT), "killed", "-l")
        names = ["/killed/" + link for link in LINKS]
        self.boxes.wait(lambda m: names_of(m) == names and not m.incomplete, "boxes")
        self.boxes.clear()
        self.end(player, signal.SIGKILL)
        self.boxes.wait(lambda m: not m.boxes and m.incomplete == names, "it is silent")
        self.expect_nothing()

    def test_one_that_is_killed_and_started_again_is_silent_until_it_sends(self):
        """What it sends first is empty, as it does not know its robot yet."""
        self.start(4.0)
        player = self.play(self.bag_of(self.topic, [array_of(LINKS)] * COUNT), "again", "-l")
        names = ["/again/" + link for link in LINKS]
        self.boxes.wait(lambda m: names_of(m) == names and not m.incomplete, "boxes")
        self.end(player, signal.SIGKILL)
        self.boxes.clear()
        self.play(self.bag_of(self.topic, [array_of([])] * COUNT), "again", "-l")
        message = self.boxes.wait(lambda m: not m.boxes, "no boxes")
        self.assertEqual(message.incomplete, names)

    def test_a_bag_player_with_two_robots(self):
        self.start(FOREVER)
        self.play(self.two_robots(self.topic), "player")
        self.expect_both_robots("/player")

    def test_a_relay_with_two_robots(self):
        self.start(FOREVER)
        relay = rospy.Publisher(self.topic, AxisAlignedBoxArray, queue_size=10 * COUNT)
        source = rospy.Subscriber("/all_boxes", AxisAlignedBoxArray, relay.publish,
                                  queue_size=10 * COUNT)
        self.addCleanup(source.unregister)
        wait_for(lambda: relay.get_num_connections() > 0, "the node takes neighbours")
        player = self.play(self.two_robots("/all_boxes"), "player")
        player.wait(60)
        self.boxes.wait_newest(lambda m: len(m.boxes) == 3, "all was relayed")
        relay.unregister()
        self.expect_both_robots(rospy.get_name())


if __name__ == "__main__":
    rospy.init_node("neighbours_test")
    rostest.rosrun("link_bounds", "neighbours", Neighbours)
