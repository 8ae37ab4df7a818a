#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""usage: rviz_in_fixed_frame.py [--help] [--version] [ARGUMENT_OF_RVIZ ...]

Starts rviz with the fixed frame of a link_bounds_publisher, when its first message on topic
link_bounds_publisher/boxes is there.
"""

import contextlib
import os
import shutil
import sys

import rospy
from link_bounds.msg import AxisAlignedBoxArray

# Installed, all programs are in one folder.
HERE = os.path.dirname(os.path.realpath(__file__))
sys.path += [HERE, os.path.join(HERE, 'demo')]
from demo_arguments import version  # noqa: E402


def package_of_rviz():
    distro = os.environ.get('ROS_DISTRO', 'Debian')
    return 'rviz' if distro == 'Debian' else f'ros-{distro}-rviz'


def main():
    if {'-h', '--help'} & set(sys.argv[1:]):
        print(__doc__.strip())
        return
    if '--version' in sys.argv[1:]:
        print('rviz_in_fixed_frame.py', version())
        return
    if not shutil.which('rviz'):
        sys.exit('rviz_in_fixed_frame: rviz is not installed; install its package '
                 + package_of_rviz())
    rospy.init_node('rviz_in_fixed_frame', anonymous=True)
    try:
        boxes = rospy.wait_for_message('link_bounds_publisher/boxes', AxisAlignedBoxArray)
    except rospy.ROSInterruptException:
        return  # a signal
    # On Debian 11 rospy calls isAlive() of a thread, which Python 3.9 lacks, after it has ended all.
    with contextlib.suppress(AttributeError):
        rospy.signal_shutdown('rviz takes the place of this node')
    os.execvp('rviz', ['rviz', *sys.argv[1:], '--fixed-frame', boxes.header.frame_id])


if __name__ == '__main__':
    main()
