#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""overlap_colors.py without a node: what it draws in which colour."""
import os
import sys
import unittest
import unittest.mock

from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray, BoxOverlap, BoxOverlapArray
from page_testing import PACKAGE
from visualization_msgs.msg import Marker

sys.path.append(os.path.join(PACKAGE, "launch", "demo"))
import overlap_colors  # noqa: E402

EDGE_POINTS = 24  # of a box
NAMES = ["arm", "base", "hand", "part/1"]


class OverlapColors(unittest.TestCase):
    def setUp(self):
        self.is_there = True
        for name, value in (("rospy.Publisher", None), ("rospy.Subscriber", None),
                            ("rospy.get_param", None),
                            ("overlap_colors.has_publisher", lambda topic: self.is_there)):
            patch = unittest.mock.patch(name, **({"new": value} if value else {}))
            patch.start()
            self.addCleanup(patch.stop)
        self.colors = overlap_colors.OverlapColors()
        self.colors.only_links = False

    def published(self):
        self.colors.publisher.publish.reset_mock()
        self.colors.publish()
        calls = self.colors.publisher.publish.call_args_list
        return [marker for call in calls for marker in call[0][0].markers]

    def counts(self):
        """How many boxes are drawn in each colour."""
        return {marker.ns: len(marker.points) / EDGE_POINTS for marker in self.published()
                if marker.type == Marker.LINE_LIST}

    def take(self, incomplete, *pairs):
        self.colors.take_boxes(AxisAlignedBoxArray(
            boxes=[AxisAlignedBox(name=name) for name in NAMES], incomplete=incomplete))
        self.colors.take_overlaps(BoxOverlapArray(overlaps=[
            BoxOverlap(first=first, second=second) for first, second in pairs]))

    def test_nothing_before_the_first_boxes(self):
        self.assertEqual(self.published(), [])

    def test_each_box_has_one_colour(self):
        self.take(["arm", "hand", "gone"], ("base", "part/1"), ("hand", "part/1"))
        self.assertEqual(self.counts(), {"free": 0, "overlapping": 3, "incomplete": 1})

    def test_of_links_alone_overlaps_with_objects_count(self):
        self.colors.only_links = True
        self.take(["arm"], ("arm", "base"), ("hand", "part/1"))
        self.assertEqual(self.counts(), {"free": 1, "overlapping": 1, "incomplete": 1})

    def test_nothing_is_left_of_a_node_that_has_ended(self):
        self.take([])
        self.is_there = False
        self.assertEqual([marker.action for marker in self.published()], [Marker.DELETEALL])
        self.assertEqual(self.published(), [])
        self.is_there = True
        self.take([])
        self.assertEqual(self.counts()["free"], len(NAMES))


if __name__ == "__main__":
    unittest.main()
