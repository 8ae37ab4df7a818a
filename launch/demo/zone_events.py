#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports which link enters or leaves a zone: an object in the marker namespace ~zones.

Subscribes to boxes and overlaps of link_bounds_publisher; logs each event and publishes it on
~events (std_msgs/String): "link X entered zone Y", "link X left zone Y". A name in incomplete, and
a link that has no box any more, is reported as not watched and leaves no zone meanwhile; the header
stamps say what belongs together.
Parameter: ~zones (default zones).
"""

import os
import re
import sys
import threading

import rospy
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray
from std_msgs.msg import String

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import check_arguments  # noqa: E402

PERIOD = 0.1  # s of wall time for which a link must be gone
QUIET = 10  # PERIODs without a message: then both topics have sent what they know
NEVER = -1  # ns, before each stamp
OBJECT = re.compile(r'.*/-?\d+', re.DOTALL)  # a link of such a name counts as an object


def printable(text):
    """One line: control characters, which could move the cursor, become spaces."""
    return ''.join(c if c.isprintable() else ' ' for c in text)


def kind(name):
    return ('object ' if OBJECT.fullmatch(name) else 'link ') + name


class Watch:
    """Who is in which zone; callbacks come from a thread per topic."""

    def __init__(self, zones, tell):
        self._is_zone = re.compile(re.escape(zones) + r'/-?\d+').fullmatch
        self._tell = tell
        self._lock = threading.Lock()
        self._zones, self._incomplete = set(), set()
        self._overlapping, self._inside, self._missing = set(), set(), set()  # (name, zone)
        self._boxed = set()  # names
        self._boxes_stamp = self._overlaps_stamp = NEVER  # ns, of the newest message
        self._went_back = False  # the stamps, so that they may not tell what belongs together
        self._quiet = 0  # PERIODs since the last message
        self._missing_since = {}  # (name, zone): the first ~overlaps without it
        self._complete_since = {}  # name: the ~boxes that it is complete again in, if newer than
        #                            ~overlaps

    def take_overlaps(self, message):
        """Reports who enters, at once."""
        stamp = message.header.stamp.to_nsec()
        with self._lock:
            self._quiet = 0
            if stamp < self._overlaps_stamp:
                self._begin_anew()
            self._overlaps_stamp = stamp
            self._complete_since = {name: since for name, since in self._complete_since.items()
                                    if since > stamp}
            self._overlapping = set(filter(None, map(self._visit, message.overlaps)))
            for name, zone in sorted(self._overlapping - self._inside):
                self._tell('%s entered zone %s' % (kind(name), zone))
            self._inside |= self._overlapping
            self._missing_since = {pair: self._missing_since.get(pair, stamp)
                                   for pair in self._inside - self._overlapping}

    def take_boxes(self, message):
        stamp = message.header.stamp.to_nsec()
        with self._lock:
            self._quiet = 0
            if stamp < self._boxes_stamp:
                self._begin_anew()
            self._boxes_stamp = stamp
            self._boxed = {box.name for box in message.boxes}
            zones = set(filter(self._is_zone, self._boxed))
            incomplete = set(message.incomplete)
            self._tell_difference(zones, self._zones, 'zone %s is there', 'zone %s is gone')
            self._tell_difference(incomplete, self._incomplete,
                                  '%s is not watched: it is incomplete',
                                  '%s is no longer incomplete')
            if stamp > self._overlaps_stamp:
                self._complete_since.update(dict.fromkeys(self._incomplete - incomplete, stamp))
            self._zones, self._incomplete = zones, incomplete

    def _begin_anew(self):
        """The stamps of a topic went back: those of the other one tell nothing until it sends."""
        self._went_back = True
        self._boxes_stamp = self._overlaps_stamp = NEVER
        self._missing_since, self._complete_since = {}, {}

    def settle(self):
        """Reports who leaves; to be called every PERIOD."""
        with self._lock:
            self._quiet += 1
            missing = self._find_missing()
            for name, zone in sorted(missing & self._missing):
                if name in self._boxed or OBJECT.fullmatch(name):
                    self._tell('%s left zone %s' % (kind(name), zone))
                else:
                    self._tell('%s is not watched: it has no box any more' % kind(name))
                self._missing_since.pop((name, zone), None)
            self._inside -= missing & self._missing
            self._missing = missing

    def _find_missing(self):
        """Who is not in a zone any more, by both topics."""
        if self._went_back and self._quiet > QUIET:
            missing = {pair for pair in self._inside - self._overlapping
                       if not self._incomplete.intersection(pair)}
            self._went_back = bool(missing)  # until they are told
            return missing
        unwatched = self._incomplete.union(self._complete_since)
        return {pair for pair, since in self._missing_since.items()
                if since <= self._boxes_stamp and not unwatched.intersection(pair)}

    def _visit(self, pair):
        """(name, zone), or None for two zones or none."""
        first, second = self._is_zone(pair.first), self._is_zone(pair.second)
        if bool(first) == bool(second):
            return None
        return (pair.second, pair.first) if first else (pair.first, pair.second)

    def _tell_difference(self, now, before, new, gone):
        for text, names in ((new, now - before), (gone, before - now)):
            for name in sorted(names):
                self._tell(text % name)


def main():
    check_arguments(__doc__)
    rospy.init_node('zone_events')
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    publisher = rospy.Publisher('~events', String, queue_size=100)

    def tell(text):
        rospy.loginfo(printable(text))
        publisher.publish(text)

    watch = Watch(rospy.get_param('~zones', 'zones'), tell)
    rospy.Subscriber('link_bounds_publisher/boxes', AxisAlignedBoxArray, watch.take_boxes,
                     tcp_nodelay=True)
    rospy.Subscriber('link_bounds_publisher/overlaps', BoxOverlapArray, watch.take_overlaps,
                     tcp_nodelay=True)
    while not ended.wait(PERIOD):
        watch.settle()


if __name__ == '__main__':
    main()
