#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""cloud_filter: which points each parameter makes the robot's, what /diagnostics counts, and robots
of which something is missing."""
import math
import struct
import unittest

import rospy
import rostest
from bounds_testing import Recorder, TfSender, box_link, robot, transform, visual, wait_for
from cloud_testing import cloud, wait_status
from diagnostic_msgs.msg import DiagnosticArray
from page_testing import PACKAGE, rows_below
from sensor_msgs.msg import PointCloud2
from std_srvs.srv import Trigger

BASE = ('<link name="base">%s<collision><geometry><box size="0.4 0.4 0.4"/></geometry></collision>'
        '</link>' % visual('<box size="0.2 0.2 0.2"/>'))
ROBOT = robot([BASE, box_link("left", (0.2, 0.2, 0.2))], [("base", "left")])
MESH = '<mesh filename="file:///there/is/no.stl"/>'
# Points on the x axis, on which base is at 1 m and left at 2 m:
AT_BASE, BY_BASE, IN_COLLISION = 1.105, 1.13, 1.19
AT_LEFT, BY_LEFT = 2.105, 2.13
AT_SENSOR, FAR = 0.2, 5.0
POINTS = [AT_BASE, BY_BASE, IN_COLLISION, AT_LEFT, BY_LEFT, AT_SENSOR, FAR]
OF_ROBOT = {
    "usual": [AT_BASE, AT_LEFT],
    "padded": [AT_BASE, BY_BASE, AT_LEFT, BY_LEFT],
    "link_padded": [AT_LEFT, BY_LEFT],
    "chosen": [AT_LEFT],
    "ignoring": [AT_BASE],
    "colliding": [AT_BASE, BY_BASE, IN_COLLISION],
    "all_geometry": [AT_BASE, BY_BASE, IN_COLLISION, AT_LEFT],
    "distant": [AT_BASE, AT_LEFT, AT_SENSOR],
}


def removed_from(message):
    return [x for i, x in enumerate(POINTS)
            if math.isnan(struct.unpack_from("<f", message.data, 12 * i)[0])]


class CloudParameters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outputs = {name: Recorder("/%s/output" % name, PointCloud2) for name in OF_ROBOT}
        cls.status = Recorder("/diagnostics", DiagnosticArray)
        cls.clouds = rospy.Publisher("/cloud", PointCloud2, queue_size=100)
        cls.tf_static = TfSender(is_static=True)
        rospy.set_param("/robot_description", ROBOT)
        for name in OF_ROBOT:
            wait_status(cls.status, "/" + name, lambda status: "no robot" not in status.message)
        wait_for(lambda: cls.clouds.get_num_connections() >= len(OF_ROBOT), "the filters listen")
        wait_for(lambda: cls.tf_static.listeners() >= len(OF_ROBOT), "the filters listen to tf")
        cls.tf_static.send(transform("sensor", "base", rospy.Time(), (1, 0, 0)),
                           transform("sensor", "left", rospy.Time(), (2, 0, 0)))

    def removed(self, name):
        stamp = rospy.Time.now()
        self.clouds.publish(cloud(stamp, [(x, 0, 0) for x in POINTS]))
        return removed_from(self.outputs[name].wait(lambda m: m.header.stamp == stamp, name))

    def reload_with(self, description):
        rospy.set_param("/robot_description", description)
        answer = rospy.ServiceProxy("/usual/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        return answer.message

    def test_each_parameter_decides(self):
        for name, expected in OF_ROBOT.items():
            self.assertEqual(self.removed(name), expected, name)

    def test_diagnostics_count(self):
        self.status.clear()
        self.assertEqual(self.removed("usual"), OF_ROBOT["usual"])
        values = wait_status(self.status, "/usual", lambda status: status.message == "filtering" or
                             "are sent late" in status.message, is_new=False)
        before = int(values["filtered"])
        for _ in range(3):
            self.removed("usual")
        wait_for(lambda: before + 3 ==
                 int(wait_status(self.status, "/usual", lambda _: True)["filtered"]),
                 "three clouds more are counted")
        self.assertAlmostEqual(float(values["robot points [%]"]), 100 * 2 / 7, delta=0.01)
        self.assertGreater(float(values["points per second"]), 0)
        self.assertLessEqual(float(values["points per second"]), before * len(POINTS) / 0.5)
        self.assertLessEqual(float(values["per cloud, median [ms]"]),
                             float(values["per cloud, max [ms]"]))
        self.assertGreaterEqual(float(values["wait for tf and turn, max [ms]"]), 0)
        self.assertEqual((values["waiting"], values["dropped"], values["passed unfiltered"]),
                         ("0", "0", "0"))
        rows = rows_below((PACKAGE / "doc/clouds.md").read_text("utf-8"), ["key", "value"])
        keys = [key for key, _ in rows]
        for key in values:
            self.assertTrue(key in keys or key.partition(": ")[0] + ": REASON" in keys, key)
        self.assertEqual([key for key in keys if "REASON" not in key and key not in values],
                         ["problem"])
        for name, left_out in ("/usual", "none"), (
                "/colliding", 'left out are links with visual geometry only: "left"'):
            values = wait_status(self.status, name, lambda _: True, is_new=False)
            self.assertEqual(values["left out"], left_out)

    def test_what_has_no_mesh_is_told(self):
        broken = '<link name="base">%s</link>' % visual(MESH)
        answer = self.reload_with(robot([broken, box_link("left", (0.2, 0.2, 0.2))],
                                        [("base", "left")]))
        self.assertIn("no.stl", answer)
        self.assertEqual(self.removed("usual"), [AT_LEFT])
        values = wait_status(self.status, "/usual", lambda status: status.level == 1 and
                             "geometry of the robot is missing" in status.message)
        self.assertIn("no.stl", values["problem"])
        # Nothing is left to filter: clouds pass, and that is an error.
        self.reload_with(robot(['<link name="base"/>'], []))
        self.assertEqual(self.removed("usual"), [])
        wait_status(self.status, "/usual", lambda status: status.level == 2 and
                    "no link of the robot is filtered" in status.message)
        self.reload_with(ROBOT)
        self.assertEqual(self.removed("usual"), OF_ROBOT["usual"])


if __name__ == "__main__":
    rospy.init_node("cloud_parameters_test")
    rostest.rosrun("link_bounds", "cloud_parameters_test", CloudParameters)
