#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""rosbag, rostopic and rviz understand what the node sends."""
import contextlib
import fcntl
import os
import pty
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import unittest

import rosbag
import rospkg
import rospy
import rostest
import yaml
from bounds_testing import (DEADLINE, Recorder, corners_of, executable, latched, load,
                            wait_for)
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from node_testing import ALL, ARMS, NODE, ArmsTf, Repeater
from raw_messages import serialized
from std_msgs.msg import Header
from visualization_msgs.msg import MarkerArray

TOPICS = {NODE + "/boxes": None, NODE + "/markers": MarkerArray}  # None: an array of boxes
PLAYED = "/played"
COUNT = 20  # messages of each topic that are recorded
RATE = 50  # Hz
LAUNCH = rospkg.RosPack().get_path("link_bounds") + "/launch/"
PROGRAMS = ["assert_box", "assert_distance", "link_bounds_publisher", "urdf_bounds"]
SCRIPTS = ["arm_slower.py", "box_table.py", "depth_camera.py", "joint_mover.py", "overlap_colors.py",
           "scene_objects.py", "zone_events.py"]
UNITS = {"B": 1, "KB": 1e3, "MB": 1e6}


def record(topic, message_type):
    return Recorder(topic, message_type) if message_type else Recorder(topic)


class Tool:
    """A program that runs until it is stopped, and the lines that it prints."""

    def __init__(self, *command, terminal_size=None):
        """The size is that of a terminal to which the program prints: rows and columns."""
        self._lines = []
        reading_end, writing_end = pty.openpty() if terminal_size else os.pipe()
        if terminal_size:
            fcntl.ioctl(writing_end, termios.TIOCSWINSZ, struct.pack("4H", *terminal_size, 0, 0))
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("LINES", "COLUMNS")}
        self._process = subprocess.Popen(command, stdout=writing_end, stderr=subprocess.STDOUT,
                                         stdin=subprocess.DEVNULL,
                                         env=dict(environment, PYTHONUNBUFFERED="1"))
        os.close(writing_end)
        self._output = open(reading_end, encoding="utf-8")
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        with contextlib.suppress(OSError):  # the end of a terminal is an error
            for line in self._output:
                self._lines.append(line)

    def wait_for_match(self, pattern):
        def match():
            return re.search(pattern, "".join(self._lines))
        return wait_for(match, "%s in %s" % (pattern, self._lines))

    def stop(self):
        self._process.kill()
        self._process.wait()
        self._reader.join()
        self._output.close()


class RosTools(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        load(NODE, ARMS, marker_labels=True)
        cls.boxes = Recorder(NODE + "/boxes")
        tf = ArmsTf()
        sender = Repeater(RATE, lambda: tf.send(rospy.Time.now(), degrees=30))
        cls.addClassCleanup(sender.stop)
        cls.boxes.wait(lambda m: not m.incomplete, "all boxes")

    def start(self, *command, **options):
        tool = Tool(*command, **options)
        self.addCleanup(tool.stop)
        return tool

    def test_a_bag_holds_what_was_sent_and_plays_it_again(self):
        live = [record(topic, kind) for topic, kind in TOPICS.items()]
        bag = os.path.join(self.recorded_in_folder(), "boxes.bag")
        subprocess.run(["rosbag", "record", "--quiet", "--limit=%d" % COUNT, "--output-name", bag,
                        *TOPICS], check=True, timeout=DEADLINE, stdin=subprocess.DEVNULL)
        with rosbag.Bag(bag) as file:
            # As bytes: message types of a bag never equal those of rospy.
            recorded = {topic: [serialized(m) for _, m, _ in file.read_messages([topic])]
                        for topic in TOPICS}
        for recorder in live:
            self.assertEqual(len(recorded[recorder.topic]), COUNT)
            sent = {serialized(message) for message in recorder.messages}
            # The first may be one that was latched before this test listened.
            self.assertEqual(set(recorded[recorder.topic][1:]) - sent, set())
            recorder.subscriber.unregister()
        self.play(bag, recorded)

    def recorded_in_folder(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        return folder

    def play(self, bag, recorded):
        played = {topic: record(PLAYED + topic, kind) for topic, kind in TOPICS.items()}
        subprocess.run(["rosbag", "play", "--quiet", "--wait-for-subscribers", bag,
                        *("%s:=%s" % (topic, PLAYED + topic) for topic in TOPICS)],
                       check=True, timeout=DEADLINE, stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL)
        for topic, recorder in played.items():
            wait_for(lambda r=recorder: len(r.messages) >= COUNT, "all of " + recorder.topic)
            self.assertEqual([serialized(m) for m in recorder.messages], recorded[topic])

    def help_of(self, program):
        return subprocess.run([executable("link_bounds", program), "--help"], check=True,
                              timeout=DEADLINE, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE).stdout.decode()

    def check_ends_quietly(self, process):
        self.addCleanup(process.kill)
        err = process.communicate(timeout=DEADLINE)[1]
        self.assertEqual(process.returncode, 1, err)
        self.assertNotIn("Traceback", err)
        return err

    def started(self, script, stdout, **environment):
        return subprocess.Popen(
            [executable("link_bounds", script)], stdout=stdout, stderr=subprocess.PIPE,
            stdin=subprocess.DEVNULL, encoding="utf-8", env=dict(os.environ, **environment))

    def test_a_table_that_nobody_reads_ends(self):
        process = self.started("box_table.py", subprocess.PIPE)
        process.stdout.readline()
        process.stdout.close()
        process.stdout = None
        self.check_ends_quietly(process)
        with open("/dev/full", "wb") as full:
            err = self.check_ends_quietly(self.started("box_table.py", full))
        self.assertIn("box_table.py: [Errno 28]", err)

    def test_ctrl_c_before_there_is_a_master(self):
        for script in ("box_table.py", "joint_mover.py", "zone_events.py"):
            with self.subTest(script):
                process = self.started(script, subprocess.PIPE, PYTHONUNBUFFERED="1",
                                       ROS_MASTER_URI="http://localhost:1")
                self.assertIn("Unable to register with master", process.stdout.readline())
                process.send_signal(signal.SIGINT)
                self.check_ends_quietly(process)

    def test_every_program_explains_itself(self):
        for program in PROGRAMS + SCRIPTS + ["rviz_in_fixed_frame.py"]:
            with self.subTest(program):
                self.assertRegex(self.help_of(program), "^usage: .*%s|^usage, in" % program)
                self.assertNotRegex(self.help_of(program), r"ALONE|PERIOD")  # names of its source

    def test_scripts_explain_every_parameter(self):
        for script in SCRIPTS:
            with open(LAUNCH + "demo/" + script, encoding="utf-8") as file:
                text = file.read()
            read = re.findall(r"get_param\('(~\w+)'", text)
            read += ["~" + name for name in re.findall(r"number_parameter\('(\w+)'", text)]
            read += ["~rate"] * text.count(" run_regularly(")
            with self.subTest(script):
                if script != "arm_slower.py":  # which has none
                    self.assertGreater(len(read), 0)
                self.assertEqual([name for name in read if name not in self.help_of(script)], [])

    def test_a_parameter_that_means_nothing_ends_a_script_with_a_line(self):
        for script, value, rule in (("zone_events.py", "zones:=7", "a namespace, as text"),
                                    ("overlap_colors.py", "rate:=0", "a finite number > 0"),
                                    ("scene_objects.py", "rate:=fast", "a finite number > 0"),
                                    ("scene_objects.py", "mesh_scale:=.nan", "a finite number")):
            with self.subTest(script):
                done = subprocess.run([sys.executable, LAUNCH + "demo/" + script,
                                       "__name:=wrong", "_" + value],
                                      stderr=subprocess.PIPE, timeout=DEADLINE)
                name = value.split(":")[0]
                self.assertRegex(done.stderr.decode(), r"^%s: parameter ~%s is .*, but must be %s\n$" %
                                 (script, name, rule))
                self.assertEqual(done.returncode, 1)
                rospy.delete_param("/wrong/" + name)

    def test_a_description_that_is_none_ends_joint_mover_with_a_line(self):
        limits = ["<robot><joint name='j' type='revolute'><limit lower='%s' upper='1'/></joint></robot>" %
                  lower for lower in ("x", "nan", "-1e400")]
        for description in (5, "<robot", *limits):
            with self.subTest(description):
                rospy.set_param("/wrong/robot_description", description)
                done = subprocess.run([sys.executable, LAUNCH + "demo/joint_mover.py",
                                       "__name:=wrong"], stderr=subprocess.PIPE, timeout=DEADLINE)
                self.assertRegex(done.stderr.decode(),
                                 r"^\S*\[FATAL\][^\n]*robot_description cannot be used: [^\n]+\n$")
                self.assertEqual(done.returncode, 1)
                rospy.delete_param("/wrong/robot_description")

    def test_rostopic_echo_prints_a_message(self):
        text = subprocess.run(["rostopic", "echo", "-n1", NODE + "/boxes"], check=True,
                              timeout=DEADLINE, stdout=subprocess.PIPE).stdout.decode()
        message = next(yaml.safe_load_all(text))
        expected = latched(NODE + "/boxes")
        self.assertEqual(message["header"]["frame_id"], "base")
        self.assertEqual([box["name"] for box in message["boxes"]], ALL)
        for box, wanted in zip(message["boxes"], expected.boxes):
            self.assertEqual(box["name"], wanted.name)
            corners = [box[corner][axis] for corner in ("min", "max") for axis in "xyz"]
            self.assertEqual(corners, corners_of(wanted))

    def test_rostopic_hz_sees_the_rate(self):
        found = self.start("rostopic", "hz", NODE + "/boxes").wait_for_match(
            r"average rate: ([\d.]+)\s.*\swindow: (?!\d\d?\b)")  # of a hundred messages or more
        self.assertAlmostEqual(float(found.group(1)), RATE, delta=RATE / 5)

    def test_rostopic_bw_sees_the_bytes(self):
        found = self.start("rostopic", "bw", NODE + "/boxes").wait_for_match(
            r"mean: ([\d.]+)(B|KB|MB)")
        mean = float(found.group(1)) * UNITS[found.group(2)]
        size = len(serialized(self.boxes.messages[-1]))
        self.assertAlmostEqual(mean, size, delta=size / 4)

    def test_box_table_keeps_control_characters_from_the_terminal(self):
        publisher = rospy.Publisher("/odd/boxes", AxisAlignedBoxArray, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(AxisAlignedBoxArray(
            header=Header(frame_id="world\x1b[2J"), boxes=[
                AxisAlignedBox(name="odd\x1b[2J"),
                AxisAlignedBox(name="flat", min=Point(-6e-15, -1, -0.0), max=Point(1, -0.0, 2))],
            incomplete=["lost\nlink"]))
        table = self.start(executable("link_bounds", "box_table.py"), "_topic:=/odd/boxes")
        table.wait_for_match(r"frame world \[2J at [^\x1b\n]*\nincomplete: lost link\n"
                             r"[^\x1b\n]*\nodd \[2J ")
        table.wait_for_match(r"\nflat +0\.000  -1\.000   0\.000 +1\.000   0\.000   2\.000 ")

    def test_box_table_tells_in_a_small_terminal_what_is_incomplete_and_that_nobody_sends(self):
        publisher = rospy.Publisher("/many/boxes", AxisAlignedBoxArray, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(AxisAlignedBoxArray(
            header=Header(frame_id="base"),
            boxes=[AxisAlignedBox(name="link%d" % i) for i in range(20)],
            incomplete=["gripper", "link1", "left_finger", "right_finger"]))
        table = self.start(executable("link_bounds", "box_table.py"), "_topic:=/many/boxes",
                           terminal_size=(9, 40))
        table.wait_for_match(r"[^\n]*\x1b\[K\n".join([
            "20 boxes, 4 incomplete, in frame base at",
            "incomplete: gripper, link1, left_finger,", "right_finger", "link  ", r"link0   +0\.0",
            r"link1 +\* +0\.0", r"link2   +0\.0", "and 17 more lines"]))
        publisher.unregister()
        table.wait_for_match(r"\x1b\[Hno publisher, no message for [1-9]\d* s, ")

    def test_rviz_is_set_to_topics_that_exist(self):
        published = dict(rospy.get_published_topics())
        for name in ("link_bounds.rviz", "demo.rviz"):
            with open(LAUNCH + name, encoding="utf-8") as file:
                displays = yaml.safe_load(file)["Visualization Manager"]["Displays"]
            self.assertIn("rviz/RobotModel", [display["Class"] for display in displays])
            topics = [display["Marker Topic"] for display in displays
                      if display["Class"] == "rviz/MarkerArray"]
            self.assertTrue(topics)
            for topic in topics:
                self.assertEqual(published[topic], "visualization_msgs/MarkerArray", name)


if __name__ == "__main__":
    rospy.init_node("ros_tools_test")
    rostest.rosrun("link_bounds", "ros_tools", RosTools)
