#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unusable input ends the node at once, with a reason; a signal ends it with exit status 0."""
import itertools
import os
import signal
import unittest

import rospy
import rostest
from bad_inputs import bad_robots
from bounds_testing import Recorder, wait_for
from node_testing import ARMS, NodeProcess

BAD_DESCRIPTIONS = {**bad_robots.UNUSABLE, "number": (5, "is 5, not a string")}
BAD_PARAMETERS = {
    "fixed_frame": [1, ["base"]],
    "geometry": ["mesh", 1],
    "links": ["base", [1], {"a": 1}],
    "ignore_links": ["base"],
    "padding": [-0.1, "0.1", float("nan"), float("inf"), 1e308],
    "link_padding": [[0.1], {"base": "wide"}, {"base": -1.0}, {"base": 1.1e6}],
    "attached": [["held/1"], {"base": "held/1"}, {"base": ["held"]}],
    "groups": [["base"], {"arm": "base"}, {"robot": ["base"]}],
    "max_rate": [-1.0, "fast"],
    "timeout": [-1, float("nan"), True],
    "tf_prefix": [1],
    "marker_rate": [0, -1.0, "30"],
    "marker_style": ["lines", True],
    "marker_color": [[1, 1, 1], [1, 1, 1, 2.0], "red"],
    "marker_labels": ["yes", 1],
    "overlap_margin": [-1.0, 1.1e6, float("nan")],
    "distance_limit": [-1.0, 1e308, float("inf")],
    "distance_accuracy": [0, 1.1e6],
    "distance_relative_accuracy": [-0.1, 0.51, float("nan")],
    "distance_warning": [-1.0, 1.1e6],
    "mesh_timeout": [0, -1.0, "30", float("inf")],
    "max_mesh_bytes": [0, -1, 1e6, "1000"],
}
QUOTED = {  # as messages quote them
    "['base']": '["base"]', "{'a': 1}": "{a: 1}", "{'base': 'wide'}": '{base: "wide"}',
    "{'base': -1.0}": "{base: -1.0}", "{'arm': 'base'}": '{arm: "base"}', "True": "true",
    "['held/1']": '["held/1"]', "{'base': 'held/1'}": '{base: "held/1"}',
    "{'base': ['held']}": '{base: ["held"]}', "{'robot': ['base']}": '{robot: ["base"]}', "1000000.0": "1e+06",
    "1100000.0": "1.1e+06",
    "{'base': 1100000.0}": "{base: 1.1e+06}",
    **{repr(text): '"%s"' % text for text in ("base", "mesh", "0.1", "fast", "30", "lines", "red",
                                              "yes", "1000")}}
BAD_NAMES = ["__name:=a/b", "__ns:=a b", "~boxes:=a b", "boxes:=a//b!"]


class StartUp(unittest.TestCase):
    names = ("node_%d" % i for i in itertools.count())

    def start(self, description, **parameters):
        rospy.set_param("/robot_description", description)
        node = NodeProcess(next(self.names), **parameters)
        self.addCleanup(node.end)
        return node

    def check_refused(self, node, text):
        self.assertEqual(node.wait(), 1)
        self.assertEqual(node.output.count("FATAL"), 1, node.output)
        self.assertIn(text, node.output)

    def test_bad_descriptions(self):
        for name, (description, text) in BAD_DESCRIPTIONS.items():
            with self.subTest(description=name):
                self.check_refused(self.start(description), text)

    def test_bad_parameters_are_named(self):
        for name, values in BAD_PARAMETERS.items():
            for value in values:
                with self.subTest(name=name, value=value):
                    node = self.start(ARMS, **{name: value})
                    self.check_refused(node, "parameter ~%s is " % name)
                    self.assertIn(" is %s, but must" % QUOTED.get(repr(value), value), node.output)

    def test_what_is_wrong_within_a_value_is_told(self):
        for name, value, text in (
                ("groups", {"arm": "base"}, 'must be a map of which "arm" is a list of strings'),
                ("link_padding", {"base": "2cm"}, 'must be a map of which "base" is a number'),
                ("padding", "1e-2", "a number, and is text: YAML wants a point and a sign in 1.0e-2")):
            with self.subTest(name=name):
                self.check_refused(self.start(ARMS, **{name: value}), text)

    def test_a_list_on_the_command_line_is_told_where_lists_belong(self):
        rospy.set_param("/robot_description", ARMS)
        for argument in ("_links:=[base]", "_links:=base", "_groups:={arm: [left]}",
                         "_marker_color:=[1, 0, 0, 1]"):
            with self.subTest(argument=argument):
                node = NodeProcess(next(self.names), [argument])
                self.addCleanup(node.end)
                name, _, value = argument.partition(":=")
                self.check_refused(
                    node, 'parameter ~%s is "%s", but must be a ' % (name[1:], value))
                self.assertIn("{a: b}" if "{" in argument else "[a, b]", node.output)
                self.assertIn(", by rosparam, or by <rosparam> in a launch file", node.output)

    def test_whole_numbers_are_accepted(self):
        node = self.start(ARMS, padding=1, marker_color=[1, 0, 0, 1], link_padding={"base": 2})
        boxes = Recorder(node.name + "/boxes")
        message = boxes.wait(lambda m: m.boxes, "the static base")
        self.assertAlmostEqual(message.boxes[0].max.x, 2.2, delta=1e-9)

    def test_an_unknown_parameter_is_only_warned_about(self):
        node = self.start(ARMS, paddding=1.0)
        Recorder(node.name + "/boxes").wait(lambda m: True, "boxes")
        self.assertIn("~paddding, which is 1.0, is unknown", node.output)

    def test_signals_end_it_with_status_0(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            node = self.start(ARMS)
            Recorder(node.name + "/boxes").wait(lambda m: True, "boxes")
            node.interrupt(number)
            self.assertEqual(node.wait(), 0)

    def test_names_that_ros_refuses(self):
        for argument in BAD_NAMES:
            with self.subTest(argument=argument):
                node = NodeProcess(next(self.names), [argument])
                self.addCleanup(node.end)
                self.check_refused(node, argument.partition("=")[2])

    def test_a_master_uri_that_ros_refuses(self):
        for uri in ("localhost", "http://", "http://localhost", ""):
            with self.subTest(uri=uri):
                node = NodeProcess(next(self.names), environment=dict(
                    os.environ, ROS_MASTER_URI=uri))
                self.addCleanup(node.end)
                self.check_refused(node, "ROS_MASTER_URI")

    def test_a_master_argument_that_ros_refuses(self):
        """The last one counts."""
        for uri in ("localhost", "http://", "http://localhost", ""):
            with self.subTest(uri=uri):
                node = NodeProcess(next(self.names), [
                    "__master:=" + os.environ["ROS_MASTER_URI"], "__master:=" + uri])
                self.addCleanup(node.end)
                self.check_refused(node, '__master is "%s"; it must be http://HOST:PORT' % uri)

    def test_help_needs_no_master(self):
        node = NodeProcess(next(self.names), ["--help"], {"ROS_MASTER_URI": "http://localhost:1"})
        self.addCleanup(node.end)
        self.assertEqual(node.wait(), 0)
        wait_for(lambda: all(name in node.output for name in BAD_PARAMETERS), "all parameters")


if __name__ == "__main__":
    rospy.init_node("start_up_test")
    rostest.rosrun("link_bounds", "start_up", StartUp)
