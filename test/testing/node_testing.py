# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of a running node: arms in tf, periodic senders, clock, status, processes."""
import itertools
import os
import subprocess
import tempfile
import threading
import time
import unittest

import roslib.packages
import rospy
from bounds_testing import (DEADLINE, Pose, Recorder, TfSender, box_link, corners_of, difference,
                            names_of, robot, transform, turn, wait_for)
from diagnostic_msgs.msg import DiagnosticArray
from link_bounds.msg import AxisAlignedBoxArray
from rosgraph_msgs.msg import Clock

NODE = "/link_bounds_publisher"
SANITIZED = "ASAN_OPTIONS" in os.environ or "TSAN_OPTIONS" in os.environ
TOLERANCE = 1e-12  # m
ALL = ["base", "mast", "left", "left_tip", "right"]
STATIC = ["base", "mast"]
DYNAMIC = ["left", "left_tip", "right"]
PARENTS = {"mast": "base", "left": "base", "left_tip": "left", "right": "base"}
SIZES = {"base": (0.4, 0.4, 0.2), "mast": (0.1, 0.2, 0.6), "left": (0.4, 0.2, 0.1),
         "left_tip": (0.1, 0.1, 0.05), "right": (0.4, 0.2, 0.1)}
ARMS = robot([box_link(name, SIZES[name]) for name in ALL] + ['<link name="bare"/>'],
             [(parent, child) for child, parent in PARENTS.items()] + [("base", "bare")])


def joint_pose(child, degrees):
    """Pose of a link in its parent when the arms are turned by an angle."""
    return {"mast": Pose((0, 0, 0.4), turn((0, 0, 1), 45)),
            "left": Pose((0.5, 0.3, 0), turn((0, 0, 1), degrees)),
            "left_tip": Pose((0.3, 0, 0), turn((0, 1, 0), degrees)),
            "right": Pose((0.5, -0.3, 0), turn((0, 0, 1), -degrees))}[child]


def arm_bounds(name, degrees):
    """The six coordinates that the link's box must have."""
    pose = Pose()
    link = name
    while link != "base":
        pose = joint_pose(link, degrees) * pose
        link = PARENTS[link]
    return pose.box_bounds(SIZES[name])


def shows(message, degrees, incomplete=()):
    """True if a message has exactly these links, each in the box of its angle."""
    return (names_of(message) == [name for name in ALL if name in degrees] and
            message.incomplete == list(incomplete) and
            all(difference(corners_of(box), arm_bounds(box.name, degrees[box.name])) < TOLERANCE
                for box in message.boxes))


def at_angles(left, right):
    """All links; the arms are turned by different angles."""
    return {"base": 0, "mast": 0, "left": left, "left_tip": left, "right": right}


def arm_transform(child, stamp, degrees, prefix=""):
    pose = joint_pose(child, degrees)
    return transform(prefix + PARENTS[child], prefix + child, stamp, pose.xyz, pose.xyzw)


class ArmsTf:
    """Sends the poses of the arms; the mast is static."""

    def __init__(self, prefix=""):
        self._prefix = prefix
        self._tf = TfSender()
        self._tf_static = TfSender(is_static=True)
        self._tf.wait_for_listener()
        self._tf_static.wait_for_listener()
        self._tf_static.send(self.transform("mast", rospy.Time(), 0))

    def transform(self, child, stamp, degrees):
        return arm_transform(child, stamp, degrees, self._prefix)

    def send(self, stamp, degrees=30, links=tuple(DYNAMIC)):
        self.send_transforms(*(self.transform(link, stamp, degrees) for link in links))

    def send_arms(self, stamp, left, right):
        """One message of the arms at two angles."""
        self.send_transforms(self.transform("left", stamp, left),
                             self.transform("left_tip", stamp, left),
                             self.transform("right", stamp, right))

    def send_transforms(self, *transforms):
        """One message, in order with those of send()."""
        self._tf.send(*transforms)

    def publish(self, message):
        self._tf.publish(message)

    def listeners(self):
        return self._tf.listeners()

    def end(self):
        self._tf.end()
        self._tf_static.end()


class Repeater:
    """Calls a function at a rate, from a thread of its own, until stop()."""

    def __init__(self, rate, function):
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(1 / rate, function), daemon=True)
        self._thread.start()

    def _run(self, period, function):
        due = time.monotonic()
        while not self._end.is_set():
            function()
            due += period
            self._end.wait(max(0.0, due - time.monotonic()))

    def stop(self):
        self._end.set()
        self._thread.join()


JOINED = "updates joined, last second"
SKIPPED = "tf messages skipped, last second"


class Diagnostics:
    """The statuses of one node, each with the node's time and the wall time of receipt."""

    def __init__(self, node=NODE):
        self.name = node.lstrip("/") + ": boxes"
        self._received = []
        self._subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self._add)

    def _add(self, message):
        for status in message.status:
            if status.name == self.name:
                self._received.append((message.header.stamp, status, time.monotonic()))

    @property
    def received(self):
        return list(self._received)

    def since(self, start):
        return [entry for entry in self.received if entry[2] >= start]

    def joined(self, start):
        """How many messages were answered together with a newer one, by the statuses since then."""
        return self.sum_of(JOINED, start)

    def skipped(self, start):
        """How many messages of /tf were not read, by the statuses since then."""
        return self.sum_of(SKIPPED, start)

    def wait_until_counted(self):
        """Until a status counts all that was joined so far, and none of it is in a later one."""
        start = time.monotonic()
        wait_for(lambda: self.since(start)[1:], "two more diagnostics")

    def sum_of(self, key, start):
        """Of the values of all statuses since then."""
        return sum(float(value_of(status, key) or 0) for _, status, _ in self.since(start))

    def wait_for_new(self, condition, what, deadline=DEADLINE):
        """The first status received from now on for which condition(stamp, status) is true."""
        seen = len(self._received)
        return wait_for(
            lambda: next((status for stamp, status, _ in self.received[seen:]
                          if condition(stamp, status)), None),
            "%s in the diagnostics of %s" % (what, self.name), deadline)


def value_of(status, key):
    return next((pair.value for pair in status.values if pair.key == key), None)


class SimulatedClock:
    """Publishes /clock."""

    def __init__(self, diagnostics):
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=10, latch=True)
        self._diagnostics = diagnostics

    def publish(self, seconds):
        self._publisher.publish(Clock(rospy.Time.from_sec(seconds)))

    def set(self, seconds):
        """Returns when the stamps of the node's diagnostics show this time."""
        self.publish(seconds)
        self._diagnostics.wait_for_new(
            lambda stamp, _: stamp == rospy.Time.from_sec(seconds), "time %g" % seconds)


class Delays:
    """How long the boxes of some nodes take by the wall clock, from sending the tf message of their
    stamp to their receipt. All nodes get the same messages on the same machine, so a node that
    nothing holds up shows what the machine itself takes."""

    def __init__(self, *nodes):
        self._sent = {}
        self._received = {node: {} for node in nodes}
        self._subscribers = [
            rospy.Subscriber(node + "/boxes", AxisAlignedBoxArray, self._add, node,
                             queue_size=10000, tcp_nodelay=True) for node in nodes]

    def _add(self, message, node):
        self._received[node].setdefault(message.header.stamp, time.monotonic())

    def record(self, stamp):
        """To be called right before the tf message is sent."""
        self._sent[stamp] = time.monotonic()

    def longest(self, node):
        """Of all messages sent so far [s]; waits until the last of them is answered."""
        wait_for(lambda: max(self._sent) in self._received[node], "the last boxes of " + node)
        return max(received - self._sent[stamp]
                   for stamp, received in list(self._received[node].items())
                   if stamp in self._sent)

    def end(self):
        for subscriber in self._subscribers:
            subscriber.unregister()


def resident_bytes(pid):
    """The memory of a process that is in RAM."""
    with open("/proc/%d/status" % pid, encoding="ascii") as file:
        line = next(line for line in file if line.startswith("VmRSS:"))
    return int(line.split()[1]) * 1024


class NodeProcess:
    """Starts a publisher node with private parameters, and keeps its output."""

    def __init__(self, name, arguments=(), environment=None, folder=None, **parameters):
        self.name = "/" + name
        for key, value in parameters.items():
            rospy.set_param("%s/%s" % (self.name, key), value)
        path = roslib.packages.find_node("link_bounds", "link_bounds_publisher")[0]
        self._output = tempfile.TemporaryFile()
        self._process = subprocess.Popen([path, "__name:=" + name, *arguments], env=environment,
                                         cwd=folder, stdout=self._output, stderr=subprocess.STDOUT)

    @property
    def pid(self):
        return self._process.pid

    def interrupt(self, signal_number):
        self._process.send_signal(signal_number)

    def wait(self, deadline=DEADLINE):
        """Its exit status."""
        return self._process.wait(deadline)

    @property
    def output(self):
        """Read without a seek, which would also move where the node writes next."""
        file = self._output.fileno()
        return os.pread(file, os.fstat(file).st_size, 0).decode(errors="replace")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    @property
    def is_running(self):
        return self._process.poll() is None

    def end(self):
        self._process.kill()
        self._process.wait()
        self._output.close()
        if rospy.has_param(self.name):
            rospy.delete_param(self.name)


class OwnNodes(unittest.TestCase):
    """Starts nodes, each under another name, and sends them tf."""
    names = ("node_%d" % i for i in itertools.count())
    stamps = itertools.count(1000)

    def setUp(self):
        self.tf = TfSender()
        self.addCleanup(self.tf.end)

    def start(self, description, **parameters):
        """Returns the node when it has the model and listens to tf. boxes is what it publishes."""
        rospy.set_param("/robot_description", description)
        node = NodeProcess(next(self.names), timeout=0.0, **parameters)
        self.addCleanup(node.end)
        self.boxes = Recorder(node.name + "/boxes")
        self.boxes.wait(lambda m: True, "the model")
        wait_for(lambda: self.tf.listeners() > 0, "somebody listens to tf")
        return node
