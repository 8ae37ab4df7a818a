# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses the robot of scripts/pictures.launch and takes pictures of what rviz draws of it.

A picture is taken when the boxes of the pose have arrived and rviz has drawn them. The time for
which the screen must not change grows with the time that rviz takes for a new picture, so this also
works on a slow machine.
"""
import copy
import threading
import time

import rosgraph
import rospy
from link_bounds.msg import AxisAlignedBoxArray
from PIL import Image, ImageChops, ImageFont, ImageGrab
from sensor_msgs.msg import JointState
from visualization_msgs.msg import Marker, MarkerArray

DEADLINE = 120  # s, for rviz to load the robot; later steps take a fraction of a second
STILL = 0.4     # s without a change, at least: rviz draws some ten times meanwhile
NOISE = 60      # pixels that may differ between two pictures of one scene
SHARPNESS = 2   # width and height of the screen, divided by those of the picture
INK, FAINT, PAPER = '#1d2733', '#8a94a0', '#fafafc'  # PAPER is rviz's background


class Stage:
    """The robot, and the screen that shows it."""

    def __init__(self, node_name):
        wait_for(rosgraph.is_master_online, 'the ROS master')
        rospy.init_node(node_name)
        self._news = threading.Condition()
        self._newest = {}
        self._joints = rospy.Publisher('joint_states', JointState, queue_size=10)
        self._drawing = rospy.Publisher('drawing', MarkerArray, queue_size=10, latch=True)
        self._seen = None
        for topic, kind in (('boxes', AxisAlignedBoxArray), ('markers', MarkerArray)):
            rospy.Subscriber('link_bounds_publisher/' + topic, kind, self._record, topic)
        wait_for(lambda: self._drawing.get_num_connections() and self._joints.get_num_connections(),
                 'rviz and robot_state_publisher')

    def _record(self, message, topic):
        with self._news:
            self._newest[topic] = message
            self._news.notify_all()

    def pose(self, positions):
        """Moves the joints, named, in rad or m; returns the boxes and markers of that pose."""
        def are_of(stamp):
            boxes, markers = self._newest.get('boxes'), self._newest.get('markers')
            return (boxes and boxes.header.stamp == stamp and not boxes.incomplete
                    and markers and markers.markers
                    and markers.markers[0].header.stamp == stamp)
        end = time.monotonic() + DEADLINE
        while time.monotonic() < end and not rospy.is_shutdown():
            stamp = rospy.Time.now()
            message = JointState(name=list(positions), position=list(positions.values()))
            message.header.stamp = stamp
            self._joints.publish(message)
            with self._news:
                if self._news.wait_for(lambda: are_of(stamp), timeout=2):
                    return self._newest['boxes'], self._newest['markers']
        raise SystemExit('no boxes of the new pose')

    def warm_up(self, positions):
        """Waits until rviz shows the robot and follows it."""
        for markers in ([], self.pose(positions)[1].markers):
            self.draw(markers)
            self.picture()

    def draw(self, markers):
        """Draws these markers and removes all others."""
        sharp = copy.deepcopy(markers)
        for marker in sharp:
            if marker.type == Marker.LINE_LIST:
                marker.scale.x *= SHARPNESS
        self._drawing.publish(MarkerArray([Marker(action=Marker.DELETEALL)] + sharp))

    def picture(self):
        """The screen after the last call of draw, which must have changed it."""
        start = time.monotonic()
        wait_for(lambda: self._seen is None or changed_pixels(self._seen, ImageGrab.grab()),
                 'a new picture in rviz')
        self._seen = still_screen(max(STILL, 3 * (time.monotonic() - start)))
        return to_size(self._seen)


def still_screen(still=STILL):
    """The screen, as soon as it has not changed for so many seconds."""
    last, since = ImageGrab.grab(), time.monotonic()
    end = since + DEADLINE
    while time.monotonic() < since + still:
        if time.monotonic() > end:
            raise SystemExit('rviz does not come to rest')
        time.sleep(still / 10)
        shot = ImageGrab.grab()
        if changed_pixels(last, shot) > NOISE:
            since = time.monotonic()
        last = shot
    return last


def to_size(screen):
    return screen.resize([size // SHARPNESS for size in screen.size], Image.LANCZOS)


def font(size, style=''):
    return ImageFont.truetype(f'DejaVuSansMono{style}.ttf', size)


def rgb(color):
    """A colour of PIL from a marker's three numbers from 0 to 1."""
    return tuple(round(255 * value) for value in color)


def changed_pixels(a, b):
    difference = ImageChops.difference(a, b).convert('L')
    return sum(difference.histogram()[8:])


def wait_for(condition, what):
    end = time.monotonic() + DEADLINE
    while not condition():
        if time.monotonic() > end or rospy.is_shutdown():
            raise SystemExit(f'timeout: {what}')
        time.sleep(0.02)
