# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_bounds --out beside a node that gets the same messages one by one."""
import math
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import genpy
import rosbag
import rospy
from bounds_testing import (Pose, Recorder, TfSender, corners_of, executable, transform,
                            wait_for)
from node_testing import Diagnostics, NodeProcess, SimulatedClock, value_of
from object_testing import ObjectSender, deletion, marker
from page_testing import PACKAGE
from tf2_msgs.msg import TFMessage
from urdf_tf import UrdfTf
from visualization_msgs.msg import Marker, MarkerArray

BOXES = '/link_bounds_publisher/boxes'
BEGIN = 1000.0  # s
PERIOD = 0.02  # s
COUNT = 25  # messages before the gap; in all they last less than the timeout of the node
GAP = 3.0  # s, longer than that timeout
STEP = 0.5  # s; longer steps of the clock are awaited
DEADLINE = 60.0  # s


def time_at(index, late=0.0):
    return genpy.Time(nsecs=round((BEGIN + PERIOD * index + late) * 1e9))


def moving(robot, index):
    values = {name: 0.2 * math.sin(0.1 * index + k) for k, name in enumerate(robot.movable)}
    stamp = time_at(index)
    return '/tf', TFMessage(robot.moving(stamp, values)), stamp


def markers_at(index, *markers):
    return '/objects', MarkerArray(list(markers)), time_at(index, 0.005)


def round_of(robot, frame, objects):
    """One round of a looped bag: a robot that moves, and after a gap moves on."""
    messages = [('/tf_static', TFMessage(robot.static()), time_at(0))]
    messages += [moving(robot, index) for index in range(1, COUNT)]
    last = COUNT - 1 + round(GAP / PERIOD)
    messages += [moving(robot, last + index) for index in range(3)]
    other = messages[COUNT - 3][1].transforms[-1]  # a link that gets another parent
    messages[COUNT - 3][1].transforms[-1] = transform(
        frame, other.child_frame_id, other.header.stamp, (1, 2, 3))
    messages.append(messages[-1])  # stamps that tf has already
    if objects:
        messages += objects_around(frame, messages[1][1].transforms[1].child_frame_id)
    return sorted(messages, key=lambda message: message[2])


def objects_around(frame, link):
    mesh = (PACKAGE / 'launch/demo/meshes/wrist.stl').as_uri()
    part = marker('part/1', frame=link, scale=(.1, .2, .3))
    return [markers_at(4, part, marker('part/2', frame=frame)),
            markers_at(6, marker('placed/1', frame=link, stamp=time_at(9))),
            markers_at(11, marker('mesh/1', Marker.MESH_RESOURCE, frame=link, mesh_resource=mesh)),
            markers_at(14, marker('part/1', frame=frame, pose=Pose((1, 2, 3)))),
            markers_at(16, deletion('part/2'))]


def content(message):
    """What must be equal; seq is the publisher's, and rosbag has message types of its own."""
    boxes = [(box.name, box.stamp.to_nsec(), corners_of(box)) for box in message.boxes]
    return message.header.stamp.to_nsec(), message.header.frame_id, boxes, message.incomplete


class Player:
    """Sends the messages of a bag to a node, each when the node has answered the one before."""

    def __init__(self, name, expected):
        self._expected = expected
        self._boxes = Recorder('/%s/boxes' % name)
        self._diagnostics = Diagnostics('/' + name)
        self._clock = SimulatedClock(self._diagnostics)
        self._senders = {topic: TfSender(topic == '/tf_static') for topic in ('/tf', '/tf_static')}
        for sender in self._senders.values():
            sender.wait_for_listener()
        self._objects = ObjectSender('/' + name)
        self._answers = 1  # the first message comes with the model
        self._sent_tf = 0
        self._now = None
        self._wait()

    def play(self, messages):
        """Returns what the node published."""
        for topic, message, time in messages:
            self._pass_to(time)
            if topic == '/objects':
                self._objects.send(*message.markers)
            else:
                self._senders[topic].publish(message)
                self._sent_tf += 1
            before = self._answers
            while self._is_expected(time):
                self._answers += 1
            self._wait()
            if topic == '/tf_static' and self._answers == before:
                self._wait_for_static()
        return self._boxes.messages

    def end(self):
        for sender in self._senders.values():
            sender.end()

    def _is_expected(self, time):
        return self._answers < len(self._expected) and self._expected[self._answers][0] == time

    def _pass_to(self, time):
        """Ticks of the node that are expected to change something come first; where the clock goes
        back, it alone changes something."""
        goes_back = self._now is not None and time < self._now
        while not goes_back and self._is_tick(time):
            self._set_clock(self._expected[self._answers][0])
            self._answers += 1
            self._wait()
        self._set_clock(time)
        if goes_back:
            self._answers += 1
            self._wait()

    def _is_tick(self, end):
        """Whether the next answer is expected before that time, and before the clock goes back."""
        return (self._now is not None and self._answers < len(self._expected) and
                self._now < self._expected[self._answers][0] < end)

    def _set_clock(self, time):
        seconds = time.to_sec()
        is_far = self._now is None or abs(seconds - self._now.to_sec()) > STEP
        (self._clock.set if is_far else self._clock.publish)(seconds)
        self._now = time

    def _wait_for_static(self):
        """Without an answer, the next message, on another connection, could overtake it."""
        self._diagnostics.wait_for_new(
            lambda _, status: int(value_of(status, 'tf messages')) == self._sent_tf,
            '%d tf messages' % self._sent_tf, DEADLINE)

    def _wait(self):
        wait_for(lambda: len(self._boxes.messages) >= self._answers,
                 '%d messages of boxes' % self._answers, DEADLINE)


class BagBesideNode(unittest.TestCase):
    """Its subclasses choose the robots."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def boxes_of(self, urdf, messages):
        """What bag_bounds writes, with the record times."""
        bag, out = self.folder / 'in.bag', self.folder / 'out.bag'
        with rosbag.Bag(str(bag), 'w') as file:
            for message in messages:
                file.write(*message)
        subprocess.run([executable('link_bounds', 'bag_bounds'), bag, '--urdf', urdf, '--out', out,
                        '--objects', '/objects', '--allow-incomplete'], check=True,
                       stdout=subprocess.DEVNULL)
        with rosbag.Bag(str(out)) as file:
            self.assertEqual(list(file.get_type_and_topic_info().topics), [BOXES])
        return self.in_file_order(out)

    @staticmethod
    def in_file_order(path):
        """rosbag's own order is that of record times, which go back where the bag was looped."""
        with rosbag.Bag(str(path)) as file:
            entries = [entry for index in file._connection_indexes.values() for entry in index]
            entries.sort(key=lambda entry: (entry.chunk_pos, entry.offset))
            return [(entry.time, file._read_message((entry.chunk_pos, entry.offset)).message)
                    for entry in entries]

    def check(self, name, urdf, objects, frame):
        robot = UrdfTf(urdf.read_text('utf-8'))
        messages = round_of(robot, frame, objects)
        messages += [message for message in messages if message[2] < time_at(COUNT)]  # a loop
        expected = self.boxes_of(urdf, messages)
        rospy.set_param('/robot_description', urdf.read_text('utf-8'))
        with NodeProcess(name, timeout=2.0):
            player = Player(name, expected)
            found = player.play(messages)
            player.end()
        self.assertGreater(len(expected), 2 * COUNT)
        for index, (one, (_, other)) in enumerate(zip(found, expected)):
            self.assertEqual(content(one), content(other), 'message %d' % index)
        self.assertEqual(len(found), len(expected))
        self.check_variety(expected, 4 if objects else 2)

    def check_variety(self, expected, kinds):
        """The bag has what the test is about."""
        counts = [len(message.boxes) for _, message in expected]
        times = [time for time, _ in expected]
        self.assertGreaterEqual(len(set(counts)), kinds)
        self.assertEqual(sum(b < a for a, b in zip(times, times[1:])), 1)
