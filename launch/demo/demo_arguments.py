# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of the nodes that are started by launch files."""

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


def parameter(name, default, is_valid, rule):
    """A private parameter; one that means nothing ends the node with a line."""
    value = rospy.get_param('~' + name, default)
    if not is_valid(value):
        sys.exit(f'{os.path.basename(sys.argv[0])}: parameter ~{name} is {value!r}, but must be {rule}')
    return value


def rate_parameter(default):
    """Of a node that publishes regularly [Hz]."""
    return parameter('rate', default, lambda rate: type(rate) in (int, float) and 0 < rate < math.inf,
                     'a finite number > 0')


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
