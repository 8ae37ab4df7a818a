#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Swings every joint of robot_description for ever, smoothly and inside its limits.

Publishes joint_states (sensor_msgs/JointState); the position is a function of ROS time since the
start. Subscribes to ~speed (std_msgs/Float64): the motion goes on so many times as fast, 0 to 1.
Parameters: ~rate (Hz, default 50), ~amplitude (0..1, default 0.8) of each joint's range,
~ahead (s, default 0): where in the motion to start.
"""

import math
import os
import sys
from typing import NamedTuple
from xml.etree import ElementTree

import rospy
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import (  # noqa: E402
    check_arguments, number_parameter, printable, robot_description, run, run_regularly)

GOLDEN = (1 + math.sqrt(5)) / 2  # two periods of this ratio never coincide again
SLOW_SHARE, FAST_SHARE = 0.7, 0.3  # of the two sines; their sum is 1, so no limit is passed


class Swing(NamedTuple):
    """The endless motion of one joint, in rad or m, and s."""
    joint: str
    middle: float
    reach: float
    period: float
    phase: float

    def position(self, seconds):
        turn = 2 * math.pi * seconds / self.period
        return self.middle + self.reach * (SLOW_SHARE * math.sin(turn + self.phase)
                                           + FAST_SHARE * math.sin(GOLDEN * turn))


def movable_joints(description):
    """The movable joints of one coordinate that do not mimic another joint."""
    joints = ElementTree.fromstring(description).findall('joint')
    return [joint for joint in joints
            if joint.get('type') in ('revolute', 'continuous', 'prismatic')
            and joint.find('mimic') is None]


def make_swing(index, joint, amplitude):
    """Joints differ in period and phase; the period grows until the velocity limit is kept."""
    limit = joint.find('limit')
    limits = {} if limit is None else limit.attrib
    lower, upper = float(limits.get('lower', 0)), float(limits.get('upper', 0))
    if joint.get('type') == 'continuous':
        lower, upper = -math.pi, math.pi
    if not math.isfinite(upper - lower):
        raise ValueError(f'a limit of joint "{joint.get("name")}" is not finite')
    reach = amplitude * (upper - lower) / 2
    period = 7.0 + 1.3 * (index % 8)
    fastest = reach * 2 * math.pi / period * (SLOW_SHARE + FAST_SHARE * GOLDEN)
    permitted = float(limits.get('velocity', 0)) or fastest
    return Swing(joint.get('name'), (lower + upper) / 2, reach,
                 period * max(1.0, fastest / permitted if permitted else 1.0), 0.9 * index)


class Motion:
    """How far the motion is: the time since the start, but for times at a lower speed."""

    def __init__(self, ahead):
        self._speed = 1.0
        self._last = rospy.Time.now()
        self._seconds = ahead
        rospy.Subscriber('~speed', Float64, self._take, queue_size=1)

    def _take(self, message):
        self._speed = min(1.0, max(0.0, message.data))

    def seconds(self, now):
        self._seconds += self._speed * (now - self._last).to_sec()
        self._last = now
        return self._seconds


def main():
    check_arguments(__doc__)
    rospy.init_node('joint_mover')
    amplitude = min(1.0, max(0.0, number_parameter('amplitude', 0.8)))
    try:
        joints = movable_joints(robot_description('to move'))
        swings = [make_swing(index, joint, amplitude) for index, joint in enumerate(joints)]
    except (TypeError, ValueError, ElementTree.ParseError) as error:
        rospy.logfatal(printable(f'robot_description cannot be used: {error}'))
        sys.exit(1)
    publisher = rospy.Publisher('joint_states', JointState, queue_size=10)
    motion = Motion(number_parameter('ahead', 0))
    message = JointState(name=[swing.joint for swing in swings])

    def publish():
        message.header.stamp = rospy.Time.now()
        seconds = motion.seconds(message.header.stamp)
        message.position = [swing.position(seconds) for swing in swings]
        publisher.publish(message)

    run_regularly(50, publish)


if __name__ == '__main__':
    run(main)
