#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The running node offers what its --help says, and nothing else."""
import subprocess
import unittest

import rosgraph
import rospy
import rosservice
import rostest
from bounds_testing import executable, wait_for
from help_testing import help_rows
from node_testing import NODE

OF_ROS = {"/rosout", "/clock", NODE + "/get_loggers", NODE + "/set_logger_level"}


class Interface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.master = rosgraph.Master(rospy.get_name())
        cls.help = subprocess.run([executable("link_bounds", "link_bounds_publisher"), "--help"],
                                  check=True, stdout=subprocess.PIPE).stdout.decode()
        wait_for(lambda: NODE + "/reload" in cls.offered(2), "the node is up")

    @classmethod
    def offered(cls, kind):
        """What the node publishes (0), subscribes (1) or serves (2), without what ROS adds."""
        return {name for name, nodes in cls.master.getSystemState()[kind]
                if NODE in nodes} - OF_ROS

    def promised(self, section):
        """Names and types; ~ stands for the node."""
        return {name.replace("~", NODE + "/"): kind
                for name, kind, _ in help_rows(section, self.help)}

    def test_help_says_how_lists_are_given(self):
        self.assertIn("Set lists and maps by rosparam or in a launch file.",
                      " ".join(self.help.split()))

    def test_topics_and_their_types(self):
        topics = self.promised("Topics")
        topics.pop("joint_states")  # only while somebody listens to ~stopping: stopping_test.py
        self.assertEqual(self.offered(0) | self.offered(1), set(topics))
        types = dict(self.master.getTopicTypes())
        self.assertEqual({name: types[name] for name in topics}, topics)

    def test_only_tf_and_objects_are_subscribed(self):
        self.assertEqual(self.offered(1),
                         {"/tf", "/tf_static", NODE + "/objects", NODE + "/object",
                          NODE + "/neighbours"})

    def test_services_and_their_types(self):
        services = self.promised("Services")
        self.assertEqual(self.offered(2), set(services))
        for name, kind in services.items():
            self.assertEqual(rosservice.get_service_type(name), kind)


if __name__ == "__main__":
    rospy.init_node("interface_test")
    rostest.rosrun("link_bounds", "interface", Interface)
