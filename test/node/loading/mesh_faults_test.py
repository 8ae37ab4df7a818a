#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are no meshes, readers that hang, and nodes that end while they load."""
import itertools
import math
import os
import pathlib
import re
import shutil
import signal
import struct
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from bounds_testing import (Recorder, TfSender, box_link, box_of, names_of, robot, transform,
                            visual, wait_for)
from node_testing import SANITIZED, Delays, Diagnostics, NodeProcess, Repeater, value_of
from object_testing import ObjectSender, deletion, marker
from patience import PATIENCE
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker

TRIANGLES = 300000  # the reader needs so long for them that the test can stop it
SHORT_TIMEOUT = 3.0 * PATIENCE  # s; a multiple of MAX_DELAY
MAX_CALLBACK = 50.0 * PATIENCE  # ms of the update thread's own time
MAX_DELAY = 0.5 * PATIENCE  # wall seconds beyond what the machine takes
LARGE = 400000  # triangles of a file that the node counts as large
BALL = 1000000  # triangles; preparing it takes ten seconds and more, reading it one or two
# s; a test waits so long, and reading takes hardly longer under a sanitizer.
READS = 30.0 * (1 if SANITIZED else PATIENCE)
PROMPT = 5.0 * PATIENCE  # s, for the end of a node
ENDS = 10.0 * PATIENCE  # s; ten times what is promised


def write_stl(path, triangles, size=1):
    triangle = struct.pack("<12fH", *[0] * 3, 0, 0, 0, size, 0, 0, size, size, size, 0)
    path.write_bytes(bytes(80) + struct.pack("<I", triangles) + triangle * triangles)


def write_ball(path, triangles):
    """Each triangle has three points of its own on a sphere, so all of them can be extreme."""
    data = bytearray(84 + 50 * triangles)
    struct.pack_into("<I", data, 80, triangles)
    for i in range(triangles):
        corners = []
        for k in range(3 * i, 3 * i + 3):
            z = (k + 0.5) / (1.5 * triangles) - 1
            r = math.sqrt(1 - z * z)
            corners += [r * math.cos(2.4 * k), r * math.sin(2.4 * k), z]
        struct.pack_into("<12fH", data, 84 + 50 * i, 0, 0, 0, *corners, 0)
    path.write_bytes(data)


def write_polygons(path, count):
    """A polygon of 30 corners has 62 bytes in the file and becomes 15 triangles, 180 bytes of
    indices in memory. The time that assimp 5.4 takes grows with the square of the corners."""
    polygon = "f" + " 1 2 3" * 10 + "\n"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + count * polygon)


def mesh_robot(uri):
    """A mast beside the base, whose mesh is the case."""
    mesh = visual('<mesh filename="%s"/>' % uri)
    return robot([box_link("base", (1, 2, 3)), '<link name="mast">%s</link>' % mesh],
                 [("base", "mast")])


def read(path):
    """Empty if the file is gone, such as that of a process that has ended."""
    try:
        return pathlib.Path(path).read_text()
    except OSError:
        return ""


def is_alive(process):
    state = read("/proc/%d/stat" % process).rpartition(")")[2].split()[:1]
    return bool(state) and state != ["Z"]


def has_limits(process):
    """True if the process has set its own limits, as a mesh reader does first."""
    return bool(re.search(r"Max open files +32 ", read("/proc/%s/limits" % process)))


def workers_of(node):
    """Process numbers of the mesh readers of a node. Reads few files, because a reader may live for
    a tenth of a second only."""
    threads = pathlib.Path("/proc/%d/task" % node).glob("*/children")
    return [int(child) for thread in threads for child in read(thread).split()
            if has_limits(child)]


class MeshFaults(unittest.TestCase):
    names = ("node_%d" % i for i in itertools.count())

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.package = self.folder / "meshes"
        self.package.mkdir()
        (self.package / "package.xml").write_text("<package><name>meshes</name></package>")
        self.large = self.package / "large.stl"
        write_stl(self.large, TRIANGLES)

    def start(self, description, search=None, **parameters):
        """`search`: where packages are searched first."""
        rospy.set_param("/robot_description", description)
        folders = [*(search or [self.package]), os.environ["ROS_PACKAGE_PATH"]]
        environment = dict(os.environ, ROS_PACKAGE_PATH=":".join(map(str, folders)))
        node = NodeProcess(next(self.names), (), environment, timeout=0.0, **parameters)
        self.addCleanup(node.end)
        return node

    def catch_worker(self, node):
        """Stops a mesh reader while it reads, so that it hangs."""
        worker = wait_for(lambda: workers_of(node.pid), "a mesh reader")[0]
        os.kill(worker, signal.SIGSTOP)
        self.addCleanup(lambda: is_alive(worker) and os.kill(worker, signal.SIGKILL))
        return worker

    def check_refused(self, uri, *words, **parameters):
        node = self.start(mesh_robot(uri), **parameters)
        self.check_mast_refused(node, *words)
        return node

    def check_mast_refused(self, node, *words):
        message = Recorder(node.name + "/boxes").wait(lambda m: m.boxes, "the base")
        self.assertEqual((names_of(message), message.incomplete), (["base"], ["mast"]))
        # The log may be read in the middle of a line.
        for word in ('link "mast"', *words):
            wait_for(lambda word=word: word in node.output, "%s in the log" % word)
        self.assertEqual(node.output.count("ERROR"), 1, node.output)

    def reload(self, node):
        self.assertTrue(rospy.ServiceProxy(node.name + "/reload", Trigger)().success)

    def test_what_is_no_regular_file(self):
        os.mkfifo(self.folder / "pipe.stl")
        for path in (self.folder / "pipe.stl", pathlib.Path("/dev/zero"), self.folder):
            with self.subTest(path=path):
                self.check_refused("file://%s" % path, str(path), "not a regular file")

    def test_a_link_that_leads_out_of_the_package(self):
        outside = self.folder / "outside.stl"
        write_stl(outside, 1)
        (self.package / "link.stl").symlink_to(outside)
        self.check_refused("package://meshes/link.stl", str(outside), "outside package")

    def test_a_link_within_the_package(self):
        write_stl(self.package / "small.stl", 1)
        (self.package / "link.stl").symlink_to("small.stl")
        node = self.start(mesh_robot("package://meshes/link.stl"))
        boxes, tf = Recorder(node.name + "/boxes"), TfSender(is_static=True)
        tf.wait_for_listener()
        tf.send(transform("base", "mast", rospy.Time()))
        message = boxes.wait(lambda m: not m.incomplete, "the mast")
        self.assertEqual(names_of(message), ["base", "mast"])
        self.assertNotIn("ERROR", node.output)

    def test_a_broken_manifest_on_the_search_path(self):
        broken = self.package / "other" / "package.xml"
        (self.package / "package.xml").rename(self.package / "meshes.xml")
        for name in ("other", "meshes", "odd"):
            (self.package / name).mkdir()
        broken.write_text("<package><name>other")
        (self.package / "odd" / "package.xml").write_text("<package><name/></package>")
        (self.package / "meshes.xml").rename(self.package / "meshes" / "package.xml")
        write_stl(self.package / "meshes" / "small.stl", 1)
        node = self.check_refused("package://other/a.stl", str(broken))
        boxes = Recorder(node.name + "/boxes")
        for identity, package in enumerate(("other", "meshes")):
            resource = "package://%s/small.stl" % package
            ObjectSender(node.name).send(marker("a/%d" % identity, Marker.MESH_RESOURCE,
                                                frame="base", mesh_resource=resource))
        boxes.wait(lambda m: names_of(m) == ["base", "a/1"] and m.incomplete == ["mast", "a/0"],
                   "the good object")
        wait_for(lambda: 'from "a/0 of ' in node.output, "a line that names the object")
        self.reload(node)

    def test_a_package_that_shadows_another_one(self):
        """The node has just searched for packages when the new one appears."""
        old, new = (self.package / name / "pk" for name in ("b", "a"))
        for folder, width in ((old, 2), (new, 5)):
            folder.mkdir(parents=True)
            write_stl(folder / "a.stl", 1, width)
        (self.package / "package.xml").unlink()
        (old / "package.xml").write_text("<package><name>pk</name></package>")
        node = self.start(mesh_robot("package://pk/no.stl"), search=(new.parent, old.parent))
        boxes, objects = Recorder(node.name + "/boxes"), ObjectSender(node.name)
        objects.send(marker("a/1", Marker.MESH_RESOURCE, frame="base",
                            mesh_resource="package://pk/a.stl"))

        def has_width(message, width):
            return ("a/1" in names_of(message) and
                    math.isclose(box_of(message, "a/1").max.x, width))

        boxes.wait(lambda m: has_width(m, 2), "the old package")
        self.reload(node)
        (new / "package.xml").write_text("<package><name>pk</name></package>")
        self.reload(node)
        boxes.wait(lambda m: has_width(m, 5), "the new package")

    def test_max_mesh_bytes(self):
        size = self.large.stat().st_size
        node = self.check_refused("file://%s" % self.large, "max_mesh_bytes", str(size),
                                  max_mesh_bytes=size - 1)
        rospy.set_param(node.name + "/max_mesh_bytes", size)
        self.reload(node)
        self.assertEqual(node.output.count("ERROR"), 1, node.output)

    def test_max_mesh_bytes_where_a_small_file_unfolds(self):
        polygons = self.package / "polygons.obj"
        write_polygons(polygons, 80000)
        node = self.check_refused("file://%s" % polygons, "raise max_mesh_bytes or simplify",
                                  max_mesh_bytes=polygons.stat().st_size)
        rospy.set_param(node.name + "/max_mesh_bytes", 2 * TRIANGLES * 50)
        self.reload(node)
        self.assertEqual(node.output.count("ERROR"), 1, node.output)

    def test_a_reader_that_hangs_delays_no_other_box(self):
        links, joints = [box_link("base", (1, 2, 3)), box_link("arm", (1, 1, 1))], [("base", "arm")]
        node = self.start(robot(links, joints), mesh_timeout=SHORT_TIMEOUT)
        beside = self.start(robot(links, joints))
        boxes, boxes_beside = (Recorder(each.name + "/boxes") for each in (node, beside))
        tf, sent = TfSender(), itertools.count()
        delays = Delays(node.name, beside.name)
        wait_for(lambda: tf.listeners() == 2, "both nodes listen")

        def send():
            stamp = rospy.Time(1000, next(sent) * 1000000)
            delays.record(stamp)
            tf.send(transform("base", "arm", stamp))
        sender = Repeater(100, send)
        self.addCleanup(sender.stop)
        boxes.wait(lambda m: box_of(m, "arm"), "the arm")
        mast = '<link name="mast">%s</link>' % visual('<mesh filename="file://%s"/>' % self.large)
        rospy.set_param("/robot_description", robot(links + [mast], joints + [("base", "mast")]))
        reloading = threading.Thread(target=self.reload, args=(node,))
        reloading.start()
        worker = self.catch_worker(node)
        statuses, start, begin = Diagnostics(node.name), time.monotonic(), len(boxes.messages)
        boxes_beside.clear()
        wait_for(lambda: not is_alive(worker), "the end of the reader")
        self.check_no_gap([m.header.stamp for m in boxes.messages[begin:]], statuses, start)
        self.assertGreater(len(boxes.messages) - begin, len(boxes_beside.messages) / 2)
        reloading.join()
        sender.stop()
        self.check_delays(delays, node, beside)
        self.assertIn("mesh_timeout", node.output)
        boxes.wait(lambda m: names_of(m) == ["base", "arm"] and m.incomplete == ["mast"],
                   "the mast is named")

    def check_no_gap(self, stamps, statuses, start):
        """Each message has its boxes, or was joined with a newer one while the machine was busy."""
        milliseconds = sorted({stamp.nsecs // 1000000 for stamp in stamps})
        status = statuses.wait_for_new(lambda *_: True, "a status")
        sent = milliseconds[-1] + 1 - milliseconds[0]
        self.assertLessEqual(sent - len(milliseconds), statuses.joined(start))
        self.assertLess(float(value_of(status, "longest callback, CPU [ms]")), MAX_CALLBACK)

    def check_delays(self, delays, node, beside):
        """By the wall clock, so that a wait for a lock counts; `beside` loads nothing."""
        machine, own = delays.longest(beside.name), delays.longest(node.name)
        print("boxes after at most %.1f ms, those of a node beside it %.1f ms"
              % (1e3 * own, 1e3 * machine))
        self.assertLess(own, machine + MAX_DELAY)

    def test_small_meshes_and_a_reload_wait_for_no_large_mesh(self):
        write_stl(self.large, LARGE)
        write_stl(self.package / "small.stl", 1)
        node = self.start(robot([box_link("base", (1, 2, 3))], []), mesh_timeout=600.0)
        boxes, objects = Recorder(node.name + "/boxes"), ObjectSender(node.name)
        boxes.wait(lambda m: names_of(m) == ["base"], "the base")

        def send(name, path):
            objects.send(marker(name, Marker.MESH_RESOURCE, frame="base",
                                mesh_resource="file://%s" % path))
        send("large/0", self.large)
        worker = self.catch_worker(node)
        for i in range(5):
            shutil.copy(self.package / "small.stl", self.package / ("small_%d.stl" % i))
            send("small/%d" % i, self.package / ("small_%d.stl" % i))
        small = ["small/%d" % i for i in range(5)]
        boxes.wait(lambda m: names_of(m) == ["base"] + small and m.incomplete == ["large/0"],
                   "the small ones")
        self.assertTrue(is_alive(worker))
        self.reload(node)  # starts reading the large one again
        wait_for(lambda: not is_alive(worker), "the end of the reader")
        boxes.wait_newest(lambda m: sorted(names_of(m)) == ["base", "large/0"] + small and
                          not m.incomplete, "all of them")
        self.assertNotIn("ERROR", node.output)

    def start_preparing(self, **parameters):
        """A node whose mesh has just been read, in time, and will take long to prepare."""
        ball = self.package / "ball.stl"
        write_ball(ball, BALL)
        node = self.start(mesh_robot("file://%s" % ball), **parameters)
        worker = wait_for(lambda: workers_of(node.pid), "a mesh reader")[0]
        wait_for(lambda: not is_alive(worker), "the end of the reader", READS)
        return node

    def test_a_mesh_that_nobody_has_any_more_is_given_up(self):
        write_stl(self.large, LARGE)
        node = self.start(robot([box_link("base", (1, 2, 3))], []), mesh_timeout=600.0)
        boxes, objects = Recorder(node.name + "/boxes"), ObjectSender(node.name)
        boxes.wait(lambda m: names_of(m) == ["base"], "the base")
        large = marker("large/0", Marker.MESH_RESOURCE, frame="base",
                       mesh_resource="file://%s" % self.large)
        objects.send(large)
        worker = self.catch_worker(node)
        objects.send(deletion("large/0"))
        wait_for(lambda: not is_alive(worker), "the end of the reader")
        boxes.clear()
        objects.send(large)
        boxes.wait_newest(lambda m: "large/0" in names_of(m), "it is read when it comes again")
        self.assertNotIn("ERROR", node.output)

    def test_preparing_a_mesh_counts_to_its_time(self):
        """The time runs out while the node is stopped, so that nothing depends on its pace."""
        begin = time.monotonic()
        node = self.start_preparing(mesh_timeout=READS)
        node.interrupt(signal.SIGSTOP)
        self.assertNotIn("mast", node.output)  # neither refused nor prepared
        wait_for(lambda: time.monotonic() > begin + 1.2 * READS, "the time is over", 2 * READS)
        node.interrupt(signal.SIGCONT)
        self.check_mast_refused(node, "mesh_timeout")

    def test_a_node_that_is_stopped_waits_for_no_preparation(self):
        node = self.start_preparing(mesh_timeout=600.0)
        start = time.monotonic()
        node.interrupt(signal.SIGINT)
        self.assertEqual(node.wait(), 0)
        print("ended after %.2f s" % (time.monotonic() - start))
        self.assertLess(time.monotonic() - start, ENDS)
        self.assertNotIn("bounding 2 links", node.output)  # it was still loading

    def test_a_node_that_is_killed_leaves_no_reader(self):
        node = self.start(mesh_robot("file://%s" % self.large))
        worker = self.catch_worker(node)
        node.interrupt(signal.SIGKILL)
        wait_for(lambda: not is_alive(worker), "the end of the reader")

    def test_a_node_that_is_stopped_waits_for_no_reader(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            node = self.start(mesh_robot("file://%s" % self.large))
            worker = self.catch_worker(node)
            start = time.monotonic()
            node.interrupt(number)
            self.assertEqual(node.wait(), 0)
            self.assertLess(time.monotonic() - start, PROMPT)
            self.assertFalse(is_alive(worker))


if __name__ == "__main__":
    rospy.init_node("mesh_faults_test")
    rostest.rosrun("link_bounds", "mesh_faults", MeshFaults)
