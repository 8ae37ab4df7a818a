#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of doc/scene.md scales a speed, and stops it whenever distances are missing."""
import os
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from bounds_testing import Pose, Recorder, TfSender, box_link, load, robot, transform
from node_testing import NODE, NodeProcess, Repeater
from object_testing import ObjectSender, deletion, marker
from page_testing import code_block
from std_msgs.msg import Float64

STOP, SLOW = 0.03, 0.1  # m, as in the example
RATE = 50  # Hz, of tf
TOLERANCE = 2e-3  # distance_accuracy, divided by SLOW - STOP
MESSAGES = 20  # in a row
BLOCKS = robot([box_link("base", (0.2, 0.2, 0.2)), box_link("post", (0.1, 0.1, 0.1)),
                box_link("tool", (0.2, 0.2, 0.2))], [("base", "post"), ("post", "tool")])


class SpeedScaling(unittest.TestCase):
    """The tool is 1 m above the base; a ball comes near the base from the side."""

    def setUp(self):
        example = code_block("doc/scene.md", "### Scaling a speed", "python")
        self.script = tempfile.NamedTemporaryFile("w", suffix=".py", encoding="utf-8")
        self.script.write(example)
        self.script.flush()
        self.addCleanup(self.script.close)
        self.tf = TfSender()
        self.factors = Recorder("/speed_scaling/speed_factor", Float64)
        consumer = subprocess.Popen([sys.executable, self.script.name], env=os.environ)
        self.addCleanup(consumer.wait)
        self.addCleanup(consumer.kill)
        rospy.set_param("/robot_description", BLOCKS)
        rospy.set_param(NODE + "/timeout", 0.2)
        self.node = NodeProcess("link_bounds_publisher")
        self.addCleanup(self.node.end)
        self.tf.wait_for_listener()
        self.objects = ObjectSender(NODE)

    def start_tf(self):
        sender = Repeater(RATE, lambda: self.tf.send(
            transform("base", "post", rospy.Time.now(), (0, 0, 0.5), (0, 0, 0, 1)),
            transform("post", "tool", rospy.Time.now(), (0, 0, 0.5), (0, 0, 0, 1))))
        self.addCleanup(sender.stop)
        return sender

    def put_ball(self, gap):
        self.objects.send(marker("ball/0", 2, (0.1, 0.1, 0.1), Pose((0.15 + gap, 0, 0))))

    def wait_for_factor(self, factor, what):
        """Until this factor is published."""
        self.factors.clear()
        self.factors.wait(lambda m: abs(m.data - factor) < TOLERANCE, what)

    def wait_for_stop(self, what):
        """Until so many messages in a row say 0: one alone may come from a busy machine."""
        self.factors.clear()
        self.factors.wait(lambda _: len(self.factors.messages) >= MESSAGES and not any(
            m.data for m in self.factors.messages[-MESSAGES:]), what)

    def test_speed_follows_the_distance(self):
        self.wait_for_stop("no motion without tf")
        sender = self.start_tf()
        self.wait_for_factor(1, "full speed while nothing is near")
        for gap in (0.08, 0.05):
            self.put_ball(gap)
            self.wait_for_factor((gap - STOP) / (SLOW - STOP), "slow at %g m" % gap)
        self.put_ball(0.02)
        self.wait_for_stop("no motion near the ball")
        self.objects.send(deletion("ball/0"))
        self.wait_for_factor(1, "full speed after the ball")
        self.objects.send(marker("lost/0", frame="nowhere", frame_locked=True))
        self.wait_for_stop("no motion while an object is incomplete")
        self.objects.send(deletion("lost/0"))
        self.wait_for_factor(1, "full speed when all is complete")
        other = Repeater(RATE, lambda: self.objects.send(marker(
            "far/0", 2, (0.1, 0.1, 0.1), Pose((9, 0, 0)), stamp=rospy.Time.now())))
        self.addCleanup(other.stop)
        self.wait_for_factor(1, "full speed while an object is sent anew")
        sender.stop()
        self.wait_for_stop("no motion with old distances, though stamps of others are new")
        other.stop()
        self.start_tf()
        self.wait_for_factor(1, "full speed with new distances")
        self.node.end()
        self.wait_for_stop("no motion without the node")

    def test_without_its_links_the_speed_is_zero(self):
        """An object stands near nothing, so no distance is listed, and nothing is incomplete."""
        self.start_tf()
        self.wait_for_factor(1, "full speed while nothing is near")
        load(NODE, BLOCKS, links=["base"])
        self.wait_for_stop("no motion while the tool is not watched")
        load(NODE, BLOCKS)
        self.wait_for_factor(1, "full speed once it is")

    def test_what_the_arm_holds_does_not_stop_it(self):
        """The two recipes together: what is held touches the tool, as it does the gripper."""
        self.start_tf()
        self.wait_for_factor(1, "full speed while nothing is near")
        self.objects.send(marker("held/1", 1, (0.1, 0.1, 0.2), Pose((0, 0, 0.2)), frame="tool",
                                 frame_locked=True))
        self.wait_for_stop("no motion while something touches the tool")
        load(NODE, BLOCKS, attached={"tool": ["held/*"]})
        self.wait_for_factor(1, "full speed with what is held")
        self.objects.send(marker("ball/0", 2, (0.1, 0.1, 0.1), Pose((0.15, 0, 1.2))))
        self.wait_for_factor((0.05 - STOP) / (SLOW - STOP), "slow near what is held")


if __name__ == "__main__":
    rospy.init_node("speed_scaling_test")
    rostest.rosrun("link_bounds", "speed_scaling_example", SpeedScaling)
