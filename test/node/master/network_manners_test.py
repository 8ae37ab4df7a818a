#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""After meshes, reloads and listeners only ports and files that ROS needs are open in the node."""
import contextlib
import os
import pathlib
import re
import shutil
import signal
import socket
import tempfile
import unittest
import xmlrpc.client
from urllib.parse import urlparse

import rosgraph
import rospkg
import rospy
import rostest
from bounds_testing import Recorder, box_link, load, names_of, robot, visual
from geometry_msgs.msg import Polygon
from node_testing import ALL, ARMS, NODE, ArmsTf, Diagnostics, NodeProcess
from visualization_msgs.msg import MarkerArray

DEMO = "package://link_bounds/launch/demo/meshes/"
LISTENS_TCP = "0A"  # states in /proc/net/tcp
ACCEPTS_UNIX = 0x10000  # a flag in /proc/net/unix
FOLDERS = {"HOME": "home", "ROS_HOME": "ros_home", "ROS_LOG_DIR": "log", "TMPDIR": "tmp",
           "XDG_CACHE_HOME": "cache", "XDG_RUNTIME_DIR": "runtime"}
HARMLESS = re.compile(r"pipe:|anon_inode:|/dev/(null|pts/\d+|tty)$")


def mesh_link(name, uri):
    return '<link name="%s">%s</link>' % (name, visual('<mesh filename="%s"/>' % uri))


MESHES = robot([mesh_link("base", DEMO + "pedestal.stl"), mesh_link("arm", DEMO + "forearm.obj"),
                mesh_link("lost", DEMO + "no_such.stl")], [("base", "arm"), ("base", "lost")])


def files_below(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir()}


class Process:
    """A process in /proc; its sockets are identified by their inodes."""

    def __init__(self, pid):
        self._folder = "/proc/%d/" % pid

    def open_files(self):
        """Without those that the process closes while this reads."""
        files = []
        folder = self._folder + "fd/"
        for number in os.listdir(folder):
            with contextlib.suppress(FileNotFoundError):
                files.append(os.readlink(folder + number))
        return files

    def _sockets(self, kind, inode_column):
        with open(self._folder + "net/" + kind, encoding="utf-8") as file:
            rows = [line.split() for line in file.readlines()[1:]]
        own = self.open_files()
        return [row for row in rows if "socket:[%s]" % row[inode_column] in own]

    def listening_ports(self):
        rows = self._sockets("tcp", 9) + self._sockets("tcp6", 9)
        return sorted(int(row[1].split(":")[1], 16) for row in rows if row[3] == LISTENS_TCP)

    def udp_sockets(self):
        return self._sockets("udp", 9) + self._sockets("udp6", 9)

    def listening_unix_sockets(self):
        return [row for row in self._sockets("unix", 6) if int(row[3], 16) & ACCEPTS_UNIX]


class NetworkManners(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.others = [Recorder(NODE + "/markers", MarkerArray), Diagnostics(),
                      Recorder(NODE + "/footprint", Polygon)]
        cls.master = rosgraph.Master(rospy.get_name())
        cls.live_with_meshes()
        cls.live_with_tf()
        cls.uri = cls.master.lookupNode(NODE)
        cls.process = Process(xmlrpc.client.ServerProxy(cls.uri).getPid(rospy.get_name())[2])

    @classmethod
    def live_with_meshes(cls):
        load(NODE, MESHES)
        cls.boxes.wait(lambda m: names_of(m) == ["base"], "the box of a mesh")

    @classmethod
    def live_with_tf(cls):
        load(NODE, ARMS)
        tf = ArmsTf()
        tf.send(rospy.Time(1000))
        cls.boxes.wait(lambda m: names_of(m) == ALL, "all boxes")

    def test_only_the_two_ports_of_roscpp_listen(self):
        service_uri = self.master.lookupService(NODE + "/reload")
        ports = sorted(urlparse(uri).port for uri in (self.uri, service_uri))
        self.assertEqual(self.process.listening_ports(), ports)
        self.assertEqual(self.process.listening_unix_sockets(), [])

    def test_only_roscpp_waits_for_datagrams(self):
        self.assertLessEqual(len(self.process.udp_sockets()), 1)

    def test_only_log_files_are_open(self):
        log_folder = os.path.realpath(rospkg.get_log_dir())
        for file in self.process.open_files():
            if HARMLESS.match(file) or file.startswith("socket:"):
                continue
            self.assertEqual(os.path.commonpath([log_folder, os.path.realpath(file)]), log_folder)

    def test_which_files_are_written(self):
        """The process has its own folder for each variable of its environment that names one."""
        folder = pathlib.Path(tempfile.mkdtemp()).resolve()
        self.addCleanup(shutil.rmtree, folder)
        for name in [*FOLDERS.values(), "working"]:
            (folder / name).mkdir(mode=0o700)
        environment = dict(os.environ)
        environment.update((key, str(folder / name)) for key, name in FOLDERS.items())
        rospy.set_param("/robot_description", MESHES)
        with NodeProcess("writer", environment=environment, folder=folder / "working") as node:
            boxes = Recorder(node.name + "/boxes")
            self.addCleanup(boxes.subscriber.unregister)
            boxes.wait(lambda m: names_of(m) == ["base"], "the box of a mesh")
            self.assertEqual(os.readlink("/proc/%d/cwd" % node.pid), str(folder / "working"))
            load(node.name, MESHES, parts_per_link=2)
            node.interrupt(signal.SIGINT)
            self.assertEqual(node.wait(), 0)
        self.assertEqual([file for file in files_below(folder) if not file.startswith("log/")], [])

    def test_no_url_is_read(self):
        with socket.create_server(("localhost", 0)) as server:
            load(NODE, robot([box_link("base", (1, 1, 1)), mesh_link(
                "far", "http://localhost:%d/mesh.stl" % server.getsockname()[1])],
                             [("base", "far")]))
            self.boxes.wait(lambda m: m.incomplete == ["far"], "the mesh's refusal")
            server.setblocking(False)
            with self.assertRaises(BlockingIOError):
                server.accept()


if __name__ == "__main__":
    rospy.init_node("network_manners_test")
    rostest.rosrun("link_bounds", "network_manners", NetworkManners)
