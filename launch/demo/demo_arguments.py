# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the nodes share that are started by launch files: arguments, parameters, the loop, text."""

import argparse
import math
import os
import sys
from xml.etree import ElementTree

import rospkg
import rospy


def version():
    """That of package.xml, without rospkg's manifest: that would ask for the data of rosdep."""
    folder = rospkg.RosPack().get_path('link_bounds')
    return ElementTree.parse(os.path.join(folder, 'package.xml')).findtext('version')


def refuse(name, value, rule):
    """Ends the node with a line."""
    sys.exit(f'{os.path.basename(sys.argv[0])}: parameter ~{name} is {value!r}, but must be {rule}')


def number_parameter(name, default, least=-math.inf, rule='a finite number'):
    """A private parameter that is above `least`. A number may be sent as text."""
    value = rospy.get_param('~' + name, default)
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    return number if least < number < math.inf else refuse(name, value, rule)


def run_regularly(default_rate, step, at_once=True):
    """Calls `step` at ~rate [Hz] until the node ends. The first call is at once, or else after one
    period."""
    ticks = rospy.Rate(number_parameter('rate', default_rate, 0, 'a finite number > 0'), reset=True)
    try:
        if not at_once:
            ticks.sleep()
        while not rospy.is_shutdown():
            step()
            ticks.sleep()
    except rospy.ROSInterruptException:
        pass  # a signal during sleep is the usual end


def run(main):
    """Calls main(), the whole of a node. Ctrl-C before there is a master, or a reader of the output
    that has ended, ends it without a traceback."""
    try:
        main()
    except rospy.ROSInitException:
        sys.exit(1)
    except OSError as error:
        # What waits is dropped: Python would try to write it once more.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            print(f'{os.path.basename(sys.argv[0])}: {error}', file=sys.stderr)
        sys.exit(1)


def robot_description(purpose):
    """The text of the parameter. If there is none, logs what it is for and ends the node."""
    name = rospy.search_param('robot_description')
    if name is None:
        rospy.logfatal(f'there is no robot_description {purpose}')
        sys.exit(1)
    return rospy.get_param(name)


def printable(text):
    """One line: control characters, which could move the cursor, become spaces."""
    return ''.join(c if c.isprintable() else ' ' for c in text)


def has_publisher(topic):
    """On Debian 11, rospy's get_num_connections() also counts those that have gone."""
    return any(connection.socket is not None for connection in topic.impl.connections or ())


def check_arguments(description):
    """Answers --help and --version, and refuses what is unknown. To be called before the node
    connects to ROS, because a node that registers ends the running one of its name."""
    parser = argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--version', action='store_true', help='print the version and exit')
    # In one line, without the usage.
    parser.error = lambda text: parser.exit(
        2, f'{parser.prog}: {text}; write parameters as _NAME:=VALUE, or see --help\n')
    if parser.parse_args(rospy.myargv()[1:]).version:
        print(os.path.basename(sys.argv[0]), version())
        sys.exit()
