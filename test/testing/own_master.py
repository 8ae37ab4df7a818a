# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A ROS master for one test script and the processes that it starts."""
import os
import signal
import socket
import subprocess

import rosgraph
from bounds_testing import wait_for


class OwnMaster:
    """It may die and start again at the same address, which is that of this process's master."""

    def __init__(self):
        with socket.socket() as probe:
            probe.bind(("localhost", 0))
            self.port = probe.getsockname()[1]
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
