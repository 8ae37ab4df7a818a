#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relays boxes of link_bounds to messages of another package.

Subscribes to ~topic (link_bounds/AxisAlignedBoxArray, default link_bounds_publisher/boxes) and
publishes ~out, latched: jsk_recognition_msgs/BoundingBoxArray of node boxes_to_jsk, or
vision_msgs/BoundingBox3DArray of node boxes_to_vision.
"""

import argparse
import importlib
import os
import sys
import zlib
from xml.etree import ElementTree

import rospkg
import rospy
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from link_bounds.msg import AxisAlignedBoxArray
from std_msgs.msg import Header

QUEUE = 200  # messages, as the node has for ~boxes


def center(box):
    low, high = box.min, box.max
    middle = Point((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2)
    return Pose(middle, Quaternion(0, 0, 0, 1))


def length(low, high):
    """The size along one axis [m], rounded up: half of it on both sides of the center
    contains the box."""
    middle = (low + high) / 2
    result = 2 * max(high - middle, middle - low)
    while middle - result / 2 > low or middle + result / 2 < high:
        result += max(abs(low), abs(high), result) * 2 ** -52 + 5e-324
    return result


def size(box):
    low, high = box.min, box.max
    return Vector3(length(low.x, high.x), length(low.y, high.y), length(low.z, high.z))


def to_jsk(array, messages):
    """label is the CRC-32 of the name; value is 1, or 0 for a name in incomplete."""
    incomplete = set(array.incomplete)
    frame = array.header.frame_id
    return messages.BoundingBoxArray(header=array.header, boxes=[messages.BoundingBox(
        header=Header(stamp=box.stamp, frame_id=frame), pose=center(box), dimensions=size(box),
        value=float(box.name not in incomplete), label=zlib.crc32(box.name.encode()))
        for box in array.boxes])


def to_vision(array, messages):
    return messages.BoundingBox3DArray(header=array.header, boxes=[
        messages.BoundingBox3D(center=center(box), size=size(box)) for box in array.boxes])


# value of --type: package, name of its message, function that makes the message from an array
TYPES = {'jsk': ('jsk_recognition_msgs', 'BoundingBoxArray', to_jsk),
         'vision': ('vision_msgs', 'BoundingBox3DArray', to_vision)}


def version():
    """The version in package.xml. rospkg's manifest would need the data of rosdep."""
    folder = rospkg.RosPack().get_path('link_bounds')
    return ElementTree.parse(os.path.join(folder, 'package.xml')).findtext('version')


def parse_arguments():
    """Call it before the node connects to ROS: a node that registers ends a running node of the
    same name."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--version', action='store_true', help='print the version and exit')
    parser.add_argument('--type', choices=TYPES, help='messages of jsk_recognition_msgs or '
                        'vision_msgs; that package has to be installed')
    # Print errors in one line, without the usage.
    parser.error = lambda text: parser.exit(
        2, f'{parser.prog}: {text}; write parameters as _NAME:=VALUE, or see --help\n')
    arguments = parser.parse_args(rospy.myargv()[1:])
    if arguments.version:
        print(os.path.basename(sys.argv[0]), version())
        sys.exit()
    if arguments.type is None:
        parser.error('--type is missing, which is jsk or vision')
    return arguments.type


def find_messages(package, message):
    """The module of the messages; ends the program if there is none."""
    try:
        messages = importlib.import_module(package + '.msg')
    except ImportError:
        sys.exit(f'boxes_to.py: there is no package {package} here; with Noetic, install '
                 f'ros-noetic-{package.replace("_", "-")}; elsewhere, build it in your workspace')
    if not hasattr(messages, message):
        sys.exit(f'boxes_to.py: {package} has no {message} here; install a newer {package}, of '
                 'vision_msgs at least 0.0.2')
    return messages


def main():
    kind = parse_arguments()
    package, message, convert = TYPES[kind]
    messages = find_messages(package, message)
    rospy.init_node('boxes_to_' + kind)
    publisher = rospy.Publisher('~out', getattr(messages, message), queue_size=QUEUE, latch=True)
    rospy.Subscriber(rospy.get_param('~topic', 'link_bounds_publisher/boxes'), AxisAlignedBoxArray,
                     lambda array: publisher.publish(convert(array, messages)), queue_size=QUEUE,
                     tcp_nodelay=True)
    rospy.spin()


if __name__ == '__main__':
    main()
