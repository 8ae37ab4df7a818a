# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses the robot of scripts/pictures.launch and takes pictures of what rviz draws of it.

A picture is taken when the boxes of the pose are there and rviz has drawn them, however slow the
machine: how long the screen must be still grows with the time that rviz takes for a new picture.
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
SHARPNESS = 2   # the screen is so many times as large as the picture, in width and height
INK, FAINT, PAPER = '#1d2733', '#8a94a0', '#fafafc'  # the last one is rviz's background


class Stage:
    """The robot, and the screen it is seen on."""

    def __init__(self, node_name):
        wait_for(rosgraph.is_master_online, 'the ROS master')
        rospy.init_node(node_name)
        self._news = threading.Condition()
        self._newest = {}
        self._joints = rospy.Publisher('joint_states', JointState, queue_size=10)
        self._drawing = rospy.Publisher('drawing', MarkerArray, queue_size=10, latch=True)
        self._seen = None
        for topic, kind in (('boxes', AxisAlignedBoxArray), ('markers', MarkerArray)):
            rospy.Subscriber('link_bounds_publisher/' + topic, kind, self._take, topic)
        wait_for(lambda: self._drawing.get_num_connections() and self._joints.get_num_connections(),
                 'rviz and robot_state_publisher')

    def _take(self, message, topic):
        with self._news:
            self._newest[topic] = message
            self._news.notify_all()

    def pose(self, positions):
        """Moves the joints, in rad and m by name; the boxes and markers of just that pose."""
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
        """Nothing but these markers, and no longer those of before."""
        sharp = copy.deepcopy(markers)
        for marker in sharp:
            if marker.type == Marker.LINE_LIST:
                marker.scale.x *= SHARPNESS
        self._drawing.publish(MarkerArray([Marker(action=Marker.DELETEALL)] + sharp))

    def picture(self):
        """What is on the screen after the last call of draw, which has to show something new."""
        start = time.monotonic()
        wait_for(lambda: self._seen is None or changed_pixels(self._seen, ImageGrab.grab()),
                 'a new picture in rviz')
        self._seen = still_screen(max(STILL, 3 * (time.monotonic() - start)))
        return to_size(self._seen)


def still_screen(still=STILL):
    """What is on the screen as soon as it has not changed for so many seconds."""
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
    """Of three numbers from 0 to 1, as markers have them."""
    return tuple(round(255 * value) for value in color)


def changed_pixels(a, b):
    difference = ImageChops.difference(a, b).convert('L')
    return sum(difference.histogram()[8:])


def wait_for(condition, what):
    end = time.monotonic() + DEADLINE
    while not condition():
        if time.monotonic() > end or rospy.is_shutdown():
            raise SystemExit(f'waited in vain for {what}')
        time.sleep(0.02)
