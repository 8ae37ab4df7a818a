#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_bounds --out writes, message by message, what the node publishes when the same messages reach
it one by one."""
import rospy
import rostest
from bag_player import BagBesideNode
from page_testing import PACKAGE


class DemoBesideNode(BagBesideNode):
    def test_the_demo_robot_among_objects(self):
        self.check('beside_demo', PACKAGE / 'launch/demo/demo.urdf', True, 'base')


if __name__ == '__main__':
    rospy.init_node('bag_beside_node_test')
    rostest.rosrun('link_bounds', 'bag_beside_node', DemoBesideNode)
