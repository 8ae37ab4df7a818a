# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A ROS master for one test script and the processes that it starts."""
import contextlib
import os
import signal
import subprocess
import unittest
import xmlrpc.client

import rosgraph
import rospy
from bounds_testing import wait_for
from free_port import free_port


class OwnMaster:
    """It may die and start again at the same address, which is that of this process's master."""

    def __init__(self):
        self.port = free_port()
        os.environ["ROS_MASTER_URI"] = "http://localhost:%d" % self.port
        self.start()

    def start(self):
        self._process = subprocess.Popen(
            ["rosmaster", "--core", "-p", str(self.port)], stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        wait_for(rosgraph.is_master_online, "the master answers")

    def signal(self, number):
        self._process.send_signal(number)

    def kill(self):
        self.signal(signal.SIGKILL)
        self._process.wait()


class OwnMasterTest(unittest.TestCase):
    """Runs with a master of its own, which is `self.master`."""

    @classmethod
    def setUpClass(cls):
        cls.master = OwnMaster()
        cls.addClassCleanup(cls.master.kill)
        rospy.init_node(cls.__name__, disable_signals=True)

    @classmethod
    def tearDownClass(cls):
        # On Debian 11 rospy calls isAlive() of a thread, which Python 3.9 lacks.
        with contextlib.suppress(AttributeError):
            rospy.signal_shutdown("the end")


def entries(node):
    """What the master knows of a node: topics and services, and their addresses."""
    master = rosgraph.Master("/asking")
    topics, subscriptions, services = (
        sorted(name for name, nodes in kind for n in nodes if n == node)
        for kind in master.getSystemState())
    types = dict(master.getTopicTypes())  # after the state, to which a node may be adding topics
    return {"uri": master.lookupNode(node),
            "publications": [(name, types[name]) for name in topics],
            "subscriptions": subscriptions,
            "services": [(name, master.lookupService(name)) for name in services]}


def is_known(node):
    try:
        return rosgraph.Master("/asking").lookupNode(node)
    except (rosgraph.MasterException, OSError, xmlrpc.client.Error):
        return None
