# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of load: a master, a node, its scene, its load and its memory."""
import contextlib
import json
import subprocess
import threading
import time

import rospy
from bounds_testing import (DEADLINE, TfSender, box_link, executable, robot, transform,
                            wait_for)
from node_testing import NODE, Diagnostics, NodeProcess, resident_bytes, value_of
from own_master import OwnMasterTest
from patience import PATIENCE
from raw_subscriber import RawSubscriber, Reader
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

OTHER = "/other_publisher"  # a node beside NODE, to whose optional topics nobody listens
LINK_SIZE = (0.08, 0.1, 0.1)
PATIENT = 120 * PATIENCE  # s, the deadline of what takes long under load


def link_names(count):
    """The links that load_driver and storm_driver move."""
    return ["link_%d" % i for i in range(count)]


def description(links):
    names = link_names(links)
    return robot([box_link(name, LINK_SIZE) for name in ["base"] + names],
                 [("base", name) for name in names])


def cube(i, xyz, size=0.1):
    marker = Marker(ns="cube", id=i, type=Marker.CUBE, frame_locked=True)
    marker.header.frame_id = "base"
    marker.pose.position.x, marker.pose.position.y, marker.pose.position.z = xyz
    marker.pose.orientation.w = 1
    marker.scale.x = marker.scale.y = marker.scale.z = size
    return marker


def carried_cubes(count, frames):
    """Each moves with one of the frames."""
    cubes = touching_cubes(count, gap=0.1)
    for i, marker in enumerate(cubes):
        marker.header.frame_id = frames[i % len(frames)]
    return cubes


def overlapping_cubes(count):
    """Each overlaps each other one."""
    return [cube(i, (0.0001 * i, 1, 0), 1.0) for i in range(count)]


def touching_cubes(count, gap=0.0):
    """A block, in which each has up to 26 neighbours."""
    edge, step = 10, 0.1 + gap
    return [cube(i, (step * (i % edge), 1 + step * (i // edge % edge), step * (i // edge ** 2)))
            for i in range(count)]


class MemoryWatch:
    """The largest memory of a process, looked at often [bytes]."""

    PERIOD = 0.1  # s

    def __init__(self, pid):
        self.first = self.largest = resident_bytes(pid)
        self._pid = pid
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        while not self._end.wait(self.PERIOD):
            with contextlib.suppress(OSError, StopIteration):
                self.largest = max(self.largest, resident_bytes(self._pid))

    def end(self):
        """The growth since the beginning [bytes]."""
        self._end.set()
        self._thread.join()
        return self.largest - self.first


class Statuses(Diagnostics):
    """The diagnostics of the node as numbers."""

    def newest(self, key):
        """0 where the node does not have the key."""
        received = self.received
        return float(value_of(received[-1][1], key) or 0) if received else 0.0

    def longest_gap(self, start, end):
        """The longest time without a status between two times [s]."""
        times = [start, *(time for _, _, time in self.since(start) if time < end), end]
        return max(b - a for a, b in zip(times, times[1:]))

    def has(self, key):
        return any(value_of(status, key) is not None for _, status, _ in self.received)


class LoadTest(OwnMasterTest):
    """Starts a node with `LINKS` links for each test, and ends it."""

    LINKS = 20

    def start_node(self, **parameters):
        rospy.set_param("/robot_description", description(self.LINKS))
        self.node = NodeProcess(NODE[1:], timeout=parameters.pop("timeout", 0.0), **parameters)
        self.addCleanup(self.node.end)
        rospy.wait_for_service(NODE + "/reload", DEADLINE)
        self.statuses = Statuses()
        self.addCleanup(self.statuses._subscriber.unregister)
        wait_for(lambda: self.statuses.newest("bounded links"), "the robot is loaded")

    def add(self, markers):
        """Returns when the node has all of them, and a pose of each link."""
        tf = TfSender()
        tf.wait_for_listener()
        tf.send(*(transform("base", name, rospy.Time.now()) for name in link_names(self.LINKS)))
        objects = rospy.Publisher(NODE + "/objects", MarkerArray, queue_size=10)
        wait_for(lambda: objects.get_num_connections() > 0, "the node takes objects")
        objects.publish(MarkerArray(markers))
        wait_for(lambda: self.statuses.newest("objects") == len(markers), "all objects are there",
                 PATIENT)
        tf.end()
        objects.unregister()

    def start_other(self, markers, **parameters):
        """A node with the same robot, objects and tf. What the machine does beside the test makes
        both late."""
        other = NodeProcess(OTHER[1:], timeout=0.0, **parameters)
        self.addCleanup(other.end)
        objects = rospy.Publisher(OTHER + "/objects", MarkerArray, queue_size=10)
        self.addCleanup(objects.unregister)
        statuses = Statuses(OTHER)
        self.addCleanup(statuses._subscriber.unregister)
        wait_for(lambda: objects.get_num_connections() > 0, "the other node takes objects")
        objects.publish(MarkerArray(markers))
        wait_for(lambda: statuses.newest("objects") == len(markers), "all objects there", PATIENT)
        return other, statuses

    def listen(self, topic):
        """A subscriber that reads all messages without parsing them."""
        reader = Reader(NODE, NODE + "/" + topic)
        self.addCleanup(reader.end)
        return reader

    def stop_reading(self, topic):
        """A subscriber that never reads."""
        subscriber = RawSubscriber(NODE, NODE + "/" + topic)
        self.addCleanup(subscriber.end)
        return subscriber

    def start_drive(self, hz, seconds, nodes=(NODE,)):
        return subprocess.Popen(
            [executable("link_bounds", "load_driver"), str(self.LINKS), str(hz), str(seconds),
             *nodes], stdout=subprocess.PIPE)

    def drive(self, hz, seconds):
        """Sends tf and returns what load_driver prints of NODE."""
        return self.end_drive(self.start_drive(hz, seconds))[0]

    def end_drive(self, driver):
        """What it prints of each node."""
        output = driver.communicate(timeout=PATIENT)[0]
        self.assertEqual(driver.returncode, 0)
        print("%s\n%s" % (self.id().rpartition(".")[2], output.decode()), end="", flush=True)
        return [json.loads(line) for line in output.splitlines()]

    def reload_seconds(self):
        start = time.monotonic()
        answer = rospy.ServiceProxy(NODE + "/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        return time.monotonic() - start

    def check_age(self, result, limit_ms, key="max_ms"):
        """Not counted is how long the machine did not let programs run."""
        self.assertLess(result[key] - result["stall_ms"], limit_ms, result)
