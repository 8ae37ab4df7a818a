#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""cloud_filter registers with a master that was restarted."""
import subprocess
import tempfile
import unittest

import rospy
from bounds_testing import executable, wait_for
from node_testing import ARMS
from own_master import OwnMaster, entries, is_known

FILTER = "/cloud_filter"


def has_registered():
    """Objects are what it subscribes to last."""
    return is_known(FILTER) and FILTER + "/objects" in entries(FILTER)["subscriptions"]


class CloudMaster(unittest.TestCase):
    def test_a_new_master_learns_everything(self):
        master = OwnMaster()
        self.addCleanup(master.kill)
        rospy.init_node("cloud_master_test", disable_signals=True)
        rospy.set_param("/robot_description", ARMS)
        output = tempfile.NamedTemporaryFile("r")
        self.addCleanup(output.close)
        with open(output.name, "w", encoding="utf-8") as log:
            cloud_filter = subprocess.Popen([executable("link_bounds", "cloud_filter")], stdout=log,
                                            stderr=log)
        self.addCleanup(cloud_filter.wait)
        self.addCleanup(cloud_filter.kill)
        wait_for(has_registered, "the filter has registered")
        before = entries(FILTER)
        master.kill()
        self.wait_for_output(output.name, "lost the ROS master")
        master.start()
        self.wait_for_output(output.name, "knows this node again")
        self.assertEqual(entries(FILTER), before)

    @staticmethod
    def wait_for_output(name, text):
        def has_come():
            with open(name, encoding="utf-8") as log:
                return text in log.read()
        try:
            wait_for(has_come, text)
        except AssertionError as error:
            with open(name, encoding="utf-8") as log:
                raise AssertionError("the filter said:\n" + log.read()) from error


if __name__ == "__main__":
    unittest.main()
