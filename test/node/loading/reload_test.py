#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~reload applies what is new, keeps the old model on failure, and delays no box."""
import os
import struct
import subprocess
import tempfile
import time
import unittest

import rospy
import rostest
from bounds_testing import (DEADLINE, Recorder, box_link, box_of, corners_of, difference, load, names_of,
                            robot, visual, wait_for)
from node_testing import (ALL, ARMS, NODE, ArmsTf, Delays, Diagnostics, NodeProcess, Repeater,
                          value_of)
from patience import PATIENCE
from std_srvs.srv import Trigger

TOLERANCE = 1e-12  # m
MAX_CALLBACK = 50.0 * PATIENCE  # ms of the update thread's own time
MAX_DELAY = 0.2 * PATIENCE  # wall seconds beyond what the machine takes
TRIANGLES = 60000
DOUBLINGS = 4


def write_stl(path, size, triangles=1):
    """The first triangle has a corner at (size, size, size); the others lie inside its box."""
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", triangles))
        file.write(struct.pack("<12fH", *[0] * 3, *[0] * 3, size, 0, 0, size, size, size, 0))
        for i in range(1, triangles):
            part = size * i / triangles
            file.write(struct.pack("<12fH", *[0] * 3, 0, 0, 0, part, 0, 0, part, part, 0, 0))


def stamp_of(number):
    """At 100 Hz."""
    return rospy.Time(1000 + number // 100, number % 100 * 10000000)


def mesh_robot(path):
    mesh = visual('<mesh filename="file://%s"/>' % path)
    return robot([box_link("base", (1, 2, 3)), '<link name="mast">%s</link>' % mesh],
                 [("base", "mast")])


class Reload(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Recorder(NODE + "/boxes")
        cls.diagnostics = Diagnostics()
        cls.tf = ArmsTf()
        cls.count, cls.delays = 0, None

    def setUp(self):
        load(NODE, ARMS)
        self.check_served()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.mesh = os.path.join(self.folder.name, "mesh.stl")

    def send_next(self):
        """Returns its stamp."""
        Reload.count += 1
        stamp = stamp_of(self.count)
        if self.delays:
            self.delays.record(stamp)
        self.tf.send(stamp)
        return stamp

    def check_served(self):
        """The arms have all their boxes."""
        stamp = self.send_next()
        self.boxes.wait(lambda m: m.header.stamp == stamp and names_of(m) == ALL and
                        not m.incomplete, "all boxes")

    def reload(self):
        return rospy.ServiceProxy(NODE + "/reload", Trigger)()

    def width_of_mast(self):
        """The largest x of the mesh, measured in the mast's own frame."""
        self.boxes.clear()
        load(NODE, links=["mast"], fixed_frame="mast")
        message = self.boxes.wait(lambda m: m.header.frame_id == "mast", "boxes in the mast")
        mast = box_of(message, "mast")
        return mast and mast.max.x

    def test_rosservice_reaches_it(self):
        answer = subprocess.run(["rosservice", "call", NODE + "/reload"], check=True,
                                timeout=DEADLINE, stdout=subprocess.PIPE).stdout.decode()
        self.assertIn("success: True", answer)

    def test_the_answer_has_the_warnings(self):
        self.assertEqual(self.reload().message, "reloaded")
        for parameters, words in (
                ({"links": ["lef"]},
                 ["2 warnings", '~links names link "lef"', "no link is bounded"]),
                ({"paddding": 1}, ["1 warning:", "~paddding"]),
                ({"links": ["a%d" % i for i in range(9)]}, ["10 warnings", '"a3"', "see the log"])):
            self.addCleanup(load, NODE)
            load(NODE)
            for name, value in parameters.items():
                rospy.set_param(NODE + "/" + name, value)
            answer = self.reload()
            self.assertTrue(answer.success)
            for word in words:
                self.assertIn(word, answer.message)
        load(NODE)
        rospy.set_param("/robot_description", mesh_robot("/no/such.stl"))
        answer = self.reload()
        self.assertTrue(answer.success)
        self.assertIn("/no/such.stl", answer.message)

    def test_other_links_and_parameters_take_effect(self):
        self.boxes.clear()
        load(NODE, robot([box_link("base", (1, 2, 3))], []), padding=0.5)
        message = self.boxes.wait(lambda m: names_of(m) == ["base"], "the new robot")
        self.assertLess(difference(corners_of(message.boxes[0]), [-1, -1.5, -2, 1, 1.5, 2]),
                        TOLERANCE)

    def test_a_broken_description_changes_nothing(self):
        for broken in ("", "<robot", "<robot name='r'><link name='a'/><link name='b'/></robot>"):
            rospy.set_param("/robot_description", broken)
            answer = self.reload()
            self.assertFalse(answer.success)
            self.assertNotEqual(answer.message, "")
        self.check_served()

    def test_another_description_waits_for_a_reload(self):
        self.boxes.clear()
        for description in (robot([box_link("other", (1, 2, 3))], []), ""):
            rospy.set_param("/robot_description", description)
            for _ in range(2):
                self.diagnostics.wait_for_new(lambda *_: True, "a status")
            self.check_served()
        self.assertEqual([m for m in self.boxes.messages if names_of(m) != ALL], [])

    def test_a_broken_parameter_changes_nothing(self):
        rospy.set_param(NODE + "/padding", -1.0)
        answer = self.reload()
        self.assertFalse(answer.success)
        self.assertIn("padding", answer.message)
        self.check_served()

    def test_very_small_rates_are_accepted(self):
        for i, rate in enumerate((1e-10, 1e-300, 5e-324)):
            padding = 0.5 + i
            self.boxes.clear()
            load(NODE, ARMS, max_rate=rate, marker_rate=rate, padding=padding)
            self.boxes.wait(lambda m, p=padding: box_of(m, "base").max.x > p, "boxes at once")
            load(NODE, ARMS)

    def test_a_missing_description_changes_nothing(self):
        rospy.delete_param("/robot_description")
        self.assertIn("robot_description", self.reload().message)
        self.check_served()

    def test_a_replaced_mesh_is_read_again(self):
        write_stl(self.mesh, 1.0)
        rospy.set_param("/robot_description", mesh_robot(self.mesh))
        self.assertAlmostEqual(self.width_of_mast(), 1.0, delta=1e-9)
        write_stl(self.mesh + ".new", 3.0)
        os.replace(self.mesh + ".new", self.mesh)
        self.assertAlmostEqual(self.width_of_mast(), 3.0, delta=1e-9)

    def test_a_repaired_mesh_is_read(self):
        with open(self.mesh, "w", encoding="ascii") as file:
            file.write("no mesh")
        rospy.set_param("/robot_description", mesh_robot(self.mesh))
        self.assertIsNone(self.width_of_mast())
        write_stl(self.mesh, 2.0)
        self.assertAlmostEqual(self.width_of_mast(), 2.0, delta=1e-9)

    def measure_delays(self):
        """Of this node and of one beside it that does not reload."""
        other = NodeProcess("beside", timeout=0.0)
        self.addCleanup(other.end)
        Reload.delays = Delays(NODE, other.name)
        self.addCleanup(self.delays.end)
        self.addCleanup(setattr, Reload, "delays", None)
        boxes = Recorder(other.name + "/boxes")
        wait_for(lambda: self.send_next() and boxes.messages and
                 names_of(boxes.messages[-1]) == ALL, "both nodes have tf")
        boxes.subscriber.unregister()
        return other.name

    def check_delays(self, other, reload_time):
        """False if the reload was too short to hold anything up."""
        machine, own = self.delays.longest(other), self.delays.longest(NODE)
        print("a reload of %.0f ms: boxes after at most %.1f ms, those of a node beside it %.1f ms"
              % (1e3 * reload_time, 1e3 * own, 1e3 * machine))
        self.assertLess(own, machine + MAX_DELAY)
        return reload_time > machine + MAX_DELAY

    def test_tf_is_answered_while_a_large_mesh_loads(self):
        """A mesh that loads too fast to hold anything up is followed by a larger one."""
        other = self.measure_delays()
        self.assertTrue(any(self.is_answered_while_loading(other, TRIANGLES << doublings)
                            for doublings in range(DOUBLINGS + 1)))

    def is_answered_while_loading(self, other, triangles):
        """False if they are too few for a test."""
        write_stl(self.mesh, 1.0, triangles)
        large = ARMS.replace('<link name="bare"/>', '<link name="bare">%s</link>' % visual(
            '<mesh filename="file://%s"/>' % self.mesh))
        self.boxes.clear()
        first = self.count + 1
        sender = Repeater(100, self.send_next)
        try:
            start = time.monotonic()
            load(NODE, large)
            reload_time = time.monotonic() - start
            for broken in ("<robot", ""):
                rospy.set_param("/robot_description", broken)
                self.assertFalse(self.reload().success)
        finally:
            sender.stop()
        sent = [stamp_of(i) for i in range(first, self.count + 1)]
        self.boxes.wait(lambda m: m.header.stamp == sent[-1], "the last update")
        answered = {m.header.stamp for m in self.boxes.messages}
        unanswered = [stamp for stamp in sent if stamp not in answered]
        status = self.diagnostics.wait_for_new(lambda *_: True, "a status")
        # A machine that is busy lets messages wait: they have boxes together with a newer one.
        self.assertLessEqual(len(unanswered), self.diagnostics.joined(start), unanswered)
        self.assertLess(float(value_of(status, "longest callback, CPU [ms]")), MAX_CALLBACK)
        return self.check_delays(other, reload_time)


if __name__ == "__main__":
    rospy.init_node("reload_test")
    rostest.rosrun("link_bounds", "reload", Reload)
