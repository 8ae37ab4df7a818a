#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robot, node and consumer on three hosts for a minute, in which two cables are cut.

Run without arguments; with one it is a process on one of the hosts.
"""
import contextlib
import json
import math
import os
import signal
import statistics
import subprocess
import sys
import threading
import time
import unittest

import rospy
from bounds_testing import DEADLINE, box_link, corners_of, difference, executable, wait_for
from link_bounds.msg import AxisAlignedBoxArray
from node_testing import ALL, NODE, SIZES, TOLERANCE, arm_bounds
from sensor_msgs.msg import JointState
from std_msgs.msg import Header
from three_hosts_testing import hosts, unshare_command

MINUTE = 60.0  # s
CUTS = {"robot": 6.0, "node": 28.0}  # when a host's cable is cut [s]
CUT_LENGTH = 10.0  # s
RIGHT_AGAIN = 2.0  # s after a cable is back
YOUNG = 0.2  # s; two cables with their delay take 40 ms
RATE = 20  # Hz
SILENT_STATES = RATE * RIGHT_AGAIN  # so many joint states in a row are never without boxes
DEGREES_PER_SECOND = 36

JOINTS = {"left": ("0.5 0.3 0", "0 0 1"), "left_tip": ("0.3 0 0", "0 1 0"),
          "right": ("0.5 -0.3 0", "0 0 -1")}  # origin and axis, as joint_pose has them
ROBOT = '<robot name="arms">%s%s%s</robot>' % (
    "".join(box_link(name, SIZES[name]) for name in ALL),
    '<joint name="mast" type="fixed"><origin xyz="0 0 0.4" rpy="0 0 %r"/><parent link="base"/>'
    '<child link="mast"/></joint>' % math.radians(45),
    "".join('<joint name="%s" type="continuous"><origin xyz="%s"/><axis xyz="%s"/>'
            '<parent link="%s"/><child link="%s"/></joint>' % (
                name, xyz, axis, "left" if name == "left_tip" else "base", name)
            for name, (xyz, axis) in JOINTS.items()))


def degrees_at(nanoseconds):
    """The angle of all joints at a time."""
    return nanoseconds % (10 * 10 ** 9) / 1e9 * DEGREES_PER_SECOND


def be_robot():
    """Sets the description, then moves the joints for ever and prints the stamp of each state."""
    rospy.init_node("robot")
    rospy.set_param("/robot_description", ROBOT)
    publisher = rospy.Publisher("/joint_states", JointState, queue_size=1, tcp_nodelay=True)
    ticks = rospy.Rate(RATE, reset=True)
    while not rospy.is_shutdown():
        now = rospy.Time.now()
        angle = math.radians(degrees_at(now.to_nsec()))
        publisher.publish(JointState(header=Header(stamp=now), name=list(JOINTS),
                                     position=[angle] * len(JOINTS)))
        print(json.dumps(now.to_sec()))
        ticks.sleep()


def be_consumer():
    """Prints a line for each message."""
    def tell(message):
        print(json.dumps({
            "received": time.time(), "stamp": message.header.stamp.to_sec(),
            "incomplete": message.incomplete,
            "boxes": {box.name: [box.stamp.to_nsec(), corners_of(box)]
                      for box in message.boxes}}))
    rospy.init_node("consumer")
    rospy.Subscriber(NODE + "/boxes", AxisAlignedBoxArray, tell, queue_size=1000,
                     tcp_nodelay=True)
    rospy.spin()


class Printed:
    """What a process prints."""

    def __init__(self, process):
        self._process = process
        self._values = []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self._process.stdout:
            with contextlib.suppress(ValueError):  # rospy tells there that the master is not up
                self._values.append(json.loads(line))

    @property
    def values(self):
        return list(self._values)


def wait_until(moment):
    """Sleeps, because the schedule of the minute is part of the test."""
    time.sleep(max(0.0, moment - time.time()))


class ThreeHosts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.hosts = dict(zip(("robot", "node", "consumer"), hosts(3)))
        for host in cls.hosts.values():
            cls.addClassCleanup(host.end)
        for host in cls.hosts.values():
            host.watch_neighbours()
        cls.start_processes()
        wait_for(lambda: cls.first_after(0), "boxes on the third host")
        if not all([host.make_bad() for host in cls.hosts.values()]):
            print("skipped: no tc netem, so three hosts without delay and loss", flush=True)
        cls.live_for_a_minute()

    @classmethod
    def start(cls, host, *command, **options):
        process = cls.hosts[host].start(*command, **options)
        if process.stdout:
            cls.addClassCleanup(process.stdout.close)
        cls.addClassCleanup(process.wait)
        cls.addClassCleanup(process.kill)
        return process

    @classmethod
    def start_processes(cls):
        me = [sys.executable, os.path.abspath(__file__)]
        cls.start("robot", "rosmaster", "--core", "-p", "11311", stdout=subprocess.DEVNULL)
        cls.robot = Printed(cls.start("robot", *me, "robot", stdout=subprocess.PIPE))
        wait_for(lambda: cls.robot.values, "the robot has its description and moves")
        cls.start("robot", executable("robot_state_publisher", "robot_state_publisher"))
        cls.node = cls.start("node", executable("link_bounds", "link_bounds_publisher"))
        cls.consumer = Printed(cls.start("consumer", *me, "consumer", stdout=subprocess.PIPE))

    @classmethod
    def first_after(cls, moment):
        """The first message that is complete and made after a moment, or None."""
        return next((m for m in cls.consumer.values
                     if m["stamp"] > moment and not m["incomplete"]), None)

    @classmethod
    def live_for_a_minute(cls):
        """Notes when each cable was cut and restored."""
        cls.begin = start = time.time()
        cls.cuts = {}
        for host, moment in CUTS.items():
            wait_until(start + moment)
            cls.hosts[host].cut()
            cut = time.time()
            wait_until(cut + CUT_LENGTH)
            cls.hosts[host].restore()
            cls.cuts[host] = (cut, time.time())
        wait_until(start + MINUTE)
        cls.end = time.time()
        wait_for(lambda: cls.first_after(cls.end), "boxes after the minute")

    def test_every_box_is_right(self):
        for message in self.consumer.values:
            boxes = message["boxes"]
            self.assertEqual(sorted([*boxes, *message["incomplete"]]), sorted(ALL))
            for name, (stamp, corners) in boxes.items():
                self.assertLess(difference(corners, arm_bounds(name, degrees_at(stamp))),
                                TOLERANCE, message)

    def test_no_stretch_without_cut_is_silent(self):
        borders = [self.begin, *(moment for cut in self.cuts.values() for moment in cut), self.end]
        for begin, end in zip(borders[::2], borders[1::2]):
            # States, not seconds: a machine that stands still for a moment stops the robot, too.
            states = [stamp for stamp in self.robot.values if begin < stamp < end]
            boxed = {m["stamp"] for m in self.consumer.values if not m["incomplete"]}
            # TCP repeats what is lost on the way, but the robot skips some joint states.
            self.assertGreater(len(boxed & set(states)), (len(states) - SILENT_STATES) / 2)
            seen = [i for i, stamp in enumerate(states) if stamp in boxed]
            self.assertGreater(len(seen), 1)
            self.assertLess(max(b - a for a, b in zip(seen, seen[1:])), SILENT_STATES)

    def test_a_cut_cable_carries_nothing(self):
        for cut, restored in self.cuts.values():
            came = [m for m in self.consumer.values if cut + 1 < m["received"] < restored]
            self.assertEqual([m for m in came if not m["incomplete"]], [])

    def test_boxes_are_right_again_in_time(self):
        for host, (_, restored) in self.cuts.items():
            after = self.first_after(restored)["received"] - restored
            print("three hosts: right boxes %.2f s after the cable of the %s host was back"
                  % (after, host), flush=True)
            self.assertLess(after, RIGHT_AGAIN)

    def test_boxes_are_young(self):
        ages = [m["received"] - m["stamp"] for m in self.consumer.values if not m["incomplete"]]
        print("three hosts: %d messages, median age %.1f ms"
              % (len(ages), 1e3 * statistics.median(ages)), flush=True)
        self.assertLess(statistics.median(ages), YOUNG)

    def test_the_node_ends_as_it_should(self):
        self.node.send_signal(signal.SIGTERM)
        self.assertEqual(self.node.wait(DEADLINE), 0)


def main():
    command = unshare_command()
    if command is None:
        print("skipped: no network namespaces, or no ip that sets their neighbours")
        return 0
    os.execvp(command[0], [*command, sys.executable, os.path.abspath(__file__), "inside"])


if __name__ == "__main__":
    role = sys.argv.pop() if len(sys.argv) > 1 else None
    roles = {"robot": be_robot, "consumer": be_consumer, "inside": unittest.main}
    sys.exit(roles.get(role, main)())
