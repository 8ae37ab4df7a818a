#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports which link enters or leaves a zone: an object in the marker namespace ~zones.

Subscribes to boxes and overlaps of link_bounds_publisher; logs each event and publishes it on
~events (std_msgs/String): "link X entered zone Y", "link X left zone Y". A name in incomplete, and
a link that has no box any more, is reported as not watched and leaves no zone meanwhile; the header
stamps say what belongs together. Where nobody publishes one of the topics for two seconds: "no zone is
watched".
Parameter: ~zones (default zones).
"""

import copy
import os
import re
import sys
import threading

import rospy
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray
from std_msgs.msg import String

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import (  # noqa: E402
    check_arguments, has_publisher, printable, refuse, run)

PERIOD = 0.1  # s of wall time for which a link must be gone
QUIET = 10  # PERIODs without a message: then both topics have sent what they know
APART = 30  # PERIODs after which the stamps of both topics must have gone back equally often
LOST = 10  # PERIODs within which messages of one stamp must once have come equally often
KEPT = 200  # messages of a topic, for those of the other one that come late
ALONE = 20  # PERIODs for which nobody publishes a topic
NEVER = -1  # ns, before each stamp
OBJECT = re.compile(r'([^/].*)?/-?\d+', re.DOTALL)  # a link of such a name counts as an object


def kind(name):
    return ('object ' if OBJECT.fullmatch(name) else 'link ') + name


class History:
    """The newest messages of a topic, by their times: how often the stamps went back, the stamp, and
    how many messages had it before.
    """

    def __init__(self):
        self.by_time = {}
        self._back, self._stamp, self._before = 0, NEVER, 0

    def add(self, message, content):
        """Returns its time."""
        stamp = message.header.stamp.to_nsec()
        self._back += stamp < self._stamp
        self._before = self._before + 1 if stamp == self._stamp else 0
        self._stamp = stamp
        self.by_time[self._time()] = content
        if len(self.by_time) > KEPT:
            del self.by_time[next(iter(self.by_time))]
        return self._time()

    def is_behind(self, other):
        """Or ahead: the stamps have not gone back equally often."""
        return self._back != other._back

    def contradicts(self, other):
        """Once both have sent all: one has lost a message that counts for the times of later ones."""
        return self.is_behind(other) or (self._stamp == other._stamp and
                                         self._before != other._before)

    def begin_anew(self, other):
        """The newest message is as new as that of the other topic, if they have one stamp."""
        newest = self.by_time[self._time()]
        self._back, self._before = max(self._back, other._back) + 1, 0
        self.by_time = {self._time(): newest}
        return self._time()

    def _time(self):
        return self._back, self._stamp, self._before


class Watch:
    """Who is in which zone; callbacks come from a thread per topic."""

    def __init__(self, zones, tell):
        self._is_zone = re.compile(re.escape(zones) + r'/-?\d+').fullmatch
        self._tell = tell
        self._lock = threading.Lock()
        self._zones, self._incomplete = set(), set()
        self._boxes, self._overlaps = History(), History()
        self._inside = {}  # (name, zone): the time of the newest ~overlaps with it
        self._outside = {}  # of those inside, who is not any more: whether it has a box
        self._settled = set()  # of those outside, who was so when both topics last agreed
        self._quiet = 0  # PERIODs since the last message
        self._apart = 0  # PERIODs for which the topics contradict each other
        self._alone = 0  # PERIODs for which nobody publishes a topic

    def take_overlaps(self, message):
        """Reports who enters, at once."""
        overlapping = set(filter(None, map(self._visit, message.overlaps)))
        with self._lock:
            self._quiet = 0
            time = self._overlaps.add(message, overlapping)
            for pair in sorted(overlapping.difference(self._inside)):
                self._tell('%s entered zone %s' % (kind(pair[0]), pair[1]))
            for pair in overlapping:
                self._inside[pair] = time
                self._outside.pop(pair, None)
            self._compare(time)

    def take_boxes(self, message):
        boxed = {box.name for box in message.boxes}
        incomplete = set(message.incomplete)
        with self._lock:
            self._quiet = 0
            time = self._boxes.add(message, (boxed, incomplete))
            zones = set(filter(self._is_zone, boxed))
            self._tell_difference(zones, self._zones, 'zone %s is there', 'zone %s is gone')
            self._tell_difference(incomplete, self._incomplete,
                                  '%s is not watched: it is incomplete',
                                  '%s is no longer incomplete')
            self._zones, self._incomplete = zones, incomplete
            self._compare(time)

    def settle(self):
        """Reports who leaves; to be called every PERIOD."""
        with self._lock:
            self._quiet += 1
            contradict = self._boxes.contradicts(self._overlaps)
            self._apart = self._apart + 1 if contradict else 0
            is_quiet = self._quiet > QUIET and contradict
            patience = APART if self._boxes.is_behind(self._overlaps) else LOST
            if is_quiet or self._apart > patience:
                self._begin_anew()
            if self._boxes.contradicts(self._overlaps):  # a message of one topic is on its way
                self._settled &= set(self._outside)
                return
            outside = {pair for pair in self._outside
                       if not self._incomplete.intersection(pair)}
            for name, zone in sorted(outside & self._settled):
                if self._outside.pop((name, zone)):
                    self._tell('%s left zone %s' % (kind(name), zone))
                else:
                    self._tell('%s is not watched: it has no box any more' % kind(name))
                del self._inside[name, zone]
            self._settled = outside & set(self._outside)

    def look_for(self, missing):
        """Reports that nobody publishes these topics; to be called every PERIOD."""
        was_alone, self._alone = self._alone, self._alone + 1 if missing else 0
        if self._alone == ALONE:
            self._tell('no zone is watched: nobody publishes %s' % ' and '.join(missing))
        elif was_alone >= ALONE and not missing:
            self._tell('zones are watched again')

    def _begin_anew(self):
        if not self._boxes.by_time or not self._overlaps.by_time:
            return
        boxes, overlaps = copy.copy(self._boxes), copy.copy(self._overlaps)
        self._boxes.begin_anew(overlaps)
        time = self._overlaps.begin_anew(boxes)
        for pair in self._overlaps.by_time[time]:
            self._inside[pair] = time
        self._compare(time)

    def _compare(self, time):
        """Who is outside, once both topics have told of one moment."""
        if not self._boxes.contradicts(self._overlaps):
            self._apart = 0
        if time not in self._boxes.by_time or time not in self._overlaps.by_time:
            return
        boxed, incomplete = self._boxes.by_time[time]
        for pair in set(self._inside) - self._overlaps.by_time[time]:
            if incomplete.intersection(pair):
                self._outside.pop(pair, None)
            elif time >= self._inside[pair]:
                self._outside[pair] = pair[0] in boxed or bool(OBJECT.fullmatch(pair[0]))

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


def tell(text, publish):
    """A log that cannot be written, as on a full disk or where it is closed, keeps no event back."""
    publish(text)
    try:
        rospy.loginfo(printable(text))
    except (OSError, AttributeError, ValueError):
        pass


def main():
    check_arguments(__doc__)
    rospy.init_node('zone_events')
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    publisher = rospy.Publisher('~events', String, queue_size=100)

    zones = rospy.get_param('~zones', 'zones')
    if not isinstance(zones, str):
        refuse('zones', zones, 'a namespace, as text')
    rospy.loginfo(printable(f'watching the zones {zones}/...'))
    watch = Watch(zones, lambda text: tell(text, publisher.publish))
    topics = [rospy.Subscriber('link_bounds_publisher/boxes', AxisAlignedBoxArray, watch.take_boxes,
                               tcp_nodelay=True),
              rospy.Subscriber('link_bounds_publisher/overlaps', BoxOverlapArray, watch.take_overlaps,
                               tcp_nodelay=True)]
    while not ended.wait(PERIOD):
        watch.settle()
        watch.look_for([topic.name for topic in topics if not has_publisher(topic)])


if __name__ == '__main__':
    run(main)
