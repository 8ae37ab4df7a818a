# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of assert_box and assert_distance: loading and running them."""
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from xml.etree import ElementTree

import rospy
from bounds_testing import DEADLINE, executable, wait_for
from catkin.test_results import read_junit
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from node_testing import Repeater
from patience import PATIENCE
from rosunit import junitxml

# Wall seconds, for what has to fail and until then has to have seen a message.
EXPIRES = 5.0 * PATIENCE
AT_ONCE = 3.0 * PATIENCE  # s; the default deadline is 10


def load_script(path):
    """A program whose name does not end in .py, as a module."""
    sys.dont_write_bytecode = True
    name = os.path.basename(path)
    loader = SourceFileLoader(name, path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class Talker:
    """A topic as a node publishes it."""

    def __init__(self, topic, message_type):
        self._publisher = rospy.Publisher(topic, message_type, queue_size=10, latch=True)

    def send(self, message):
        self._publisher.publish(message)

    def wait_for_listener(self):
        """Until the latched message has been sent, which is later than the connection."""
        wait_for(lambda: any(connection.stat_num_msg
                             for connection in self._publisher.impl.connections),
                 "the test listens")

    def end(self):
        self._publisher.unregister()


class Statuses:
    """In /diagnostics, as a node publishes them, until stop()."""

    def __init__(self):
        publisher = rospy.Publisher("/diagnostics", DiagnosticArray, queue_size=10)
        status = DiagnosticStatus(name=rospy.get_name()[1:] + ": boxes")
        self._repeater = Repeater(1.0, lambda: publisher.publish(DiagnosticArray(status=[status])))
        self.stop = self._repeater.stop


class Run:
    """A program with these parameters."""

    def __init__(self, folder, program, name, parameters, *arguments):
        self.name = name
        self.path = os.path.join(folder, "results", name + ".xml")
        rospy.set_param("/" + name, dict({"deadline": EXPIRES}, **parameters))
        self.process = subprocess.Popen(
            [executable("link_bounds", program), "__name:=" + name,
             "--gtest_output=xml:" + self.path, *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def finish(self):
        """Exit status and output."""
        try:
            output, _ = self.process.communicate(timeout=DEADLINE + EXPIRES)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        return self.process.returncode, output.decode()


class AssertionTest(unittest.TestCase):
    """Starts a program, and reads its report."""

    PROGRAM = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.statuses = Statuses()
        cls.addClassCleanup(lambda: cls.statuses.stop())

    def silence(self):
        """No status until the test ends."""
        self.statuses.stop()
        self.addCleanup(lambda: setattr(type(self), "statuses", Statuses()))

    def start(self, name, parameters, *arguments):
        run = Run(self.folder, self.PROGRAM, name, parameters, *arguments)
        self.addCleanup(run.process.stdout.close)
        self.addCleanup(run.process.wait)
        self.addCleanup(run.process.kill)
        return run

    def check_failure(self, run, *texts):
        status, output = run.finish()
        self.assertEqual(status, 1, output)
        result = junitxml.read(run.path, run.name)
        self.assertEqual((result.num_tests, result.num_errors, result.num_failures), (1, 0, 1))
        failure = result.test_case_results[0].failures[0].text
        for text in texts:
            self.assertIn(text, output)
            self.assertIn(text, failure)
        self.assertEqual(read_junit(run.path), (1, 0, 1))

    def check_passed(self, run):
        status, output = run.finish()
        self.assertEqual(status, 0, output)
        self.assertEqual(read_junit(run.path), (1, 0, 0))
        self.assertEqual(len(junitxml.read(run.path, run.name).test_case_results), 1)

    def check_at_once(self, path):
        """By the test's own clock, which knows nothing of how long the process took to start."""
        seconds = float(ElementTree.parse(path).getroot().find("testcase").get("time"))
        self.assertLess(seconds, AT_ONCE)


class FaultsTest(AssertionTest):
    """What both programs have to do. A test has start_held(name), which starts a run that waits for
    the end of its hold."""

    passing = {}  # {name: parameters}
    failing = {}  # {name: (parameters, texts of the failure)}
    invalid = {}  # {name: (parameters, text of the failure)}

    def test_conditions_that_are_true(self):
        """Side by side."""
        runs = [self.start(name, dict(parameters, deadline=DEADLINE))
                for name, parameters in self.passing.items()]
        for run in runs:
            with self.subTest(run.name):
                self.check_passed(run)

    def test_conditions_that_are_not_true(self):
        """Side by side."""
        runs = [self.start(name, parameters) for name, (parameters, _) in self.failing.items()]
        for run in runs:
            with self.subTest(run.name):
                self.check_failure(run, *self.failing[run.name][1])

    def test_parameters_that_mean_nothing_fail_at_once(self):
        for name, (parameters, text) in self.invalid.items():
            with self.subTest(name):
                run = self.start(name, dict({"deadline": 1000}, **parameters))
                self.check_failure(run, text)
                self.check_at_once(run.path)

    def test_who_is_interrupted_fails(self):
        run = self.start_held("interrupted")
        run.process.send_signal(signal.SIGTERM)
        self.check_failure(run, "interrupted")
