# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Collects the messages that a step may cause, on all topics."""
import threading

import rospy
from bounds_testing import DEADLINE
from geometry_msgs.msg import Polygon
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray

TOPICS = {"boxes": AxisAlignedBoxArray, "groups": AxisAlignedBoxArray, "parts": AxisAlignedBoxArray,
          "footprint": Polygon, "overlaps": BoxOverlapArray}
SILENCE = 0.3  # wall s


class Inbox:
    """Messages of all topics since the last take()."""

    def __init__(self, node):
        self._news = threading.Condition()
        self._messages = {topic: [] for topic in TOPICS}
        self._subscribers = [
            rospy.Subscriber("%s/%s" % (node, topic), kind, self._add, topic, queue_size=10000,
                             tcp_nodelay=True) for topic, kind in TOPICS.items()]

    def _add(self, message, topic):
        with self._news:
            self._messages[topic].append(message)
            self._news.notify_all()

    def wait(self, condition, what, deadline=DEADLINE):
        """Waits until condition(messages by topic)."""
        with self._news:
            if not self._news.wait_for(lambda: condition(self._messages), deadline):
                raise AssertionError("%s did not come within %g s" % (what, deadline))

    def wait_for_silence(self):
        """Waits until nothing comes for a moment, so that all topics show the same state."""
        with self._news:
            while self._news.wait(SILENCE):
                pass

    def take(self):
        with self._news:
            taken = self._messages
            self._messages = {topic: [] for topic in TOPICS}
            return taken

    def is_connected(self):
        return all(subscriber.get_num_connections() for subscriber in self._subscribers)

    def close(self):
        for subscriber in self._subscribers:
            subscriber.unregister()


def center_x(message, name):
    box = next((box for box in message.boxes if box.name == name), None)
    return None if box is None else (box.min.x + box.max.x) / 2
