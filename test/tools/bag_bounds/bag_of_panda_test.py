#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_beside_node with the Panda of LINK_BOUNDS_DATA."""
import os
import pathlib
import sys
import unittest

import rospy
import rostest
from bag_player import BagBesideNode

SKIPPED = 'skipped: bag_of_panda: LINK_BOUNDS_DATA is not set'
PANDA = pathlib.Path(os.environ.get('LINK_BOUNDS_DATA', ''),
                     'robots/franka_description/urdf/panda.urdf')


class PandaBesideNode(BagBesideNode):
    def test_the_panda(self):
        self.check('beside_panda', PANDA, False, 'panda_link0')


class NothingTest(unittest.TestCase):
    """Without data not one test runs, so none is counted as passed."""


if __name__ == '__main__':
    if '--say-skipped' in sys.argv:
        print(SKIPPED)
    else:
        rospy.init_node('bag_of_panda_test')
        rostest.rosrun('link_bounds', 'bag_of_panda',
                       PandaBesideNode if os.environ.get('LINK_BOUNDS_DATA') else NothingTest)
