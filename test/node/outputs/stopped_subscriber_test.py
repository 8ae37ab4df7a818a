#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A subscriber that stops reading costs bounded memory and no message of other subscribers."""
import os
import signal
import struct
import subprocess
import sys
import threading
import time
import unittest

import rospy
import rostest
from bounds_testing import TfSender, box_link, robot, transform, wait_for
from node_testing import NODE, NodeProcess, Repeater, resident_bytes

LISTENER = "--listener"  # the argument of a second process of this script
RATE = 1000  # Hz
LINKS = 200
HEALTHY = 5000  # messages before and after the stop; a busy machine stands still for 50 ms
STOPPED = 5000  # messages, more than the buffers of both kernels and our queue hold
STOP = 30.0  # wall seconds in which the listener does not read
KERNEL_BUFFERS = 40e6  # bytes
LOSS = 0.02  # part that a busy machine may cost: of boxes by the node, of messages by its reader
GROWTH = 8e6  # bytes; twice the size of the 200 messages that may wait


class Counter:
    """The stamps of all boxes messages, and the numbers that roscpp gave them. Nothing else of them
    is parsed."""

    def __init__(self):
        self._lock = threading.Lock()
        self._stamps = set()
        self._numbers = set()
        self.bytes = 0
        self._subscriber = rospy.Subscriber(
            NODE + "/boxes", rospy.AnyMsg, self._add, queue_size=10000, tcp_nodelay=True)

    def _add(self, message):
        with self._lock:
            number, *stamp = struct.unpack_from("<III", message._buff)
            self._numbers.add(number)
            self._stamps.add(tuple(stamp))
            self.bytes += len(message._buff)

    @property
    def stamps(self):
        with self._lock:
            return set(self._stamps)

    @property
    def lost(self):
        """How many messages were published to it and did not come."""
        with self._lock:
            if not self._numbers:
                return 0
            return max(self._numbers) - min(self._numbers) + 1 - len(self._numbers)


class StoppedSubscriber(unittest.TestCase):
    def setUp(self):
        names = ["link_%d" % i for i in range(LINKS)]
        rospy.set_param("/robot_description", robot(
            [box_link(name, (0.1, 0.2, 0.3)) for name in ["base"] + names],
            [("base", name) for name in names]))
        # Memory that ASan keeps for its reports would count as growth.
        options = os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1"
        self.node = NodeProcess(NODE[1:], environment=dict(os.environ, ASAN_OPTIONS=options),
                                timeout=0.0)
        self.addCleanup(self.node.end)
        self.healthy = Counter()
        self.start_listener()
        self.start_tf(names)

    def start_listener(self):
        self.listener = subprocess.Popen([sys.executable, __file__, LISTENER],
                                         stdout=subprocess.PIPE)
        self.addCleanup(self.listener.stdout.close)
        self.addCleanup(self.listener.wait)
        self.addCleanup(self.listener.kill)
        self.listener.stdout.readline()

    def start_tf(self, names):
        self.tf = TfSender()
        self.tf.wait_for_listener()
        fixed = TfSender(is_static=True)
        fixed.send(*(transform("base", name, rospy.Time()) for name in names[1:]))
        self.sent = []

        def send():
            stamp = rospy.Time(1000 + len(self.sent) // RATE,
                               len(self.sent) % RATE * (10 ** 9 // RATE))
            self.tf.send(transform("base", names[0], stamp, (len(self.sent) * 1e-3, 0, 0)))
            self.sent.append((stamp.secs, stamp.nsecs))
        sender = Repeater(RATE, send)
        self.addCleanup(sender.stop)

    def check_next(self, count, seconds=0.0):
        """The next transforms, at least for so long: the node publishes boxes for all but a few, and
        the healthy subscriber gets all but a few messages that the node publishes."""
        start, end, lost = len(self.sent), time.monotonic() + seconds, self.healthy.lost
        wait_for(lambda: len(self.sent) >= start + count and time.monotonic() > end,
                 "%d messages" % count, 60 + seconds)
        phase = self.sent[start:]
        wait_for(lambda: phase[-1] <= max(self.healthy.stamps, default=(0, 0)), "the last of them")
        missed = set(phase) - self.healthy.stamps
        lost = self.healthy.lost - lost
        print("%d of %d transforms without boxes, %d messages lost" % (len(missed), len(phase), lost))
        self.assertLess(len(missed), LOSS * len(phase))
        self.assertLess(lost, LOSS * len(phase))

    def test_others_and_memory_stay_as_they_are(self):
        self.check_next(HEALTHY)
        before, bytes_before = resident_bytes(self.node.pid), self.healthy.bytes
        self.listener.send_signal(signal.SIGSTOP)
        self.check_next(STOPPED, STOP)
        self.assertGreater(self.healthy.bytes - bytes_before, KERNEL_BUFFERS + GROWTH)
        growth = resident_bytes(self.node.pid) - before
        print("memory grew by %g bytes, %g sent" % (growth, self.healthy.bytes - bytes_before))
        self.assertLess(growth, GROWTH)
        self.listener.send_signal(signal.SIGCONT)
        self.check_next(HEALTHY)


def listen():
    """Prints a line when the first boxes have come."""
    rospy.init_node("stopped_listener")
    first = threading.Event()
    rospy.Subscriber(NODE + "/boxes", rospy.AnyMsg, lambda _: first.set(), tcp_nodelay=True)
    first.wait()
    print("listening", flush=True)
    rospy.spin()


if __name__ == "__main__":
    if LISTENER in sys.argv:
        listen()
    else:
        rospy.init_node("stopped_subscriber_test")
        rostest.rosrun("link_bounds", "stopped_subscriber", StoppedSubscriber)
