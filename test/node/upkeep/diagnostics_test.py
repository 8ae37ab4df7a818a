#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Level, texts, values and period of /diagnostics."""
import math
import re
import unittest

import rospkg
import rospy
import rostest
from bounds_testing import Recorder, TfSender, box_link, load, robot, transform, wait_for
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import Polygon
from link_bounds.msg import AxisAlignedBoxArray, BoxOverlapArray, EarliestContactArray
from node_testing import ARMS, NODE, ArmsTf, Diagnostics, NodeProcess, Repeater, value_of
from object_testing import ObjectSender, deletion, marker
from page_testing import rows_below
from patience import PATIENCE

PAGE = rospkg.RosPack().get_path("link_bounds") + "/doc/deployment.md"
MESH = "package://link_bounds/launch/demo/meshes/finger_ascii.stl"
MESSAGES = 20
MEAN = "time per tf message, mean of the last second [ms]"
MAXIMUM = "time per tf message, maximum of the last second [ms]"
LAG = "longest lag of boxes behind their stamp [ms]"
LONGEST = "time per tf message, longest [ms]"  # since the start
CROWD = 400  # objects that all overlap
GROUPS = 8000  # of the whole crowd, which take fifty times as long as a callback
LONG = 10.0  # ms; finding and sending 80,000 pairs takes longer
PERIODS = 5
PERIOD = 1.0  # wall seconds
LATE = 0.5  # wall seconds by which their mean may be off, more on a slow machine


class DiagnosticsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.diagnostics = Diagnostics()
        cls.tf = ArmsTf()

    def wait_for(self, level, key, value):
        """A status of that level with that value; one from before the reload may still arrive."""
        return self.diagnostics.wait_for_new(
            lambda _, status: status.level == level and value_of(status, key) == value,
            "level %d with %s = %s" % (level, key, value))

    def test_ok_with_all_boxes(self):
        load(NODE, ARMS)
        self.tf.send(rospy.Time(1000))
        status = self.wait_for(DiagnosticStatus.OK, "boxes", "5")
        self.assertEqual(status.name, "link_bounds_publisher: boxes")

    def test_warns_of_an_incomplete_link_and_names_it(self):
        load(NODE, robot([box_link("base", (1, 2, 3)), box_link("lost", (1, 1, 1))],
                         [("base", "lost")]))
        status = self.wait_for(DiagnosticStatus.WARN, "boxes", "1")
        self.assertIn("no transform", value_of(status, "incomplete: lost"))

    def test_error_without_one_box(self):
        load(NODE, ARMS, fixed_frame="nowhere")
        self.wait_for(DiagnosticStatus.ERROR, "boxes", "0")

    def test_warns_where_nothing_is_bounded(self):
        for description, links in (("<robot name='r'><link name='bare'/></robot>", []),
                                   (ARMS, ["lef"])):
            load(NODE, description, links=links)
            status = self.wait_for(DiagnosticStatus.WARN, "bounded links", "0")
            self.assertEqual(status.message, "no link is bounded")
            load(NODE, ARMS)
            self.tf.send(rospy.Time.now())
            self.wait_for(DiagnosticStatus.OK, "bounded links", "5")

    def test_counts_tf_messages_and_takes_their_time(self):
        before = self.diagnostics.wait_for_new(lambda *_: True, "a status")
        for i in range(MESSAGES):
            self.tf.send(rospy.Time(2000 + i))
        count = int(value_of(before, "tf messages")) + MESSAGES
        status = self.diagnostics.wait_for_new(
            lambda _, status: int(value_of(status, "tf messages")) >= count, "%d messages" % count)
        self.assertEqual(int(value_of(status, "tf messages")), count)
        self.assertGreater(float(value_of(status, LONGEST)), 0)

    def test_tells_mean_and_maximum_of_the_last_second(self):
        before = self.diagnostics.wait_for_new(lambda *_: True, "a status")
        sender = Repeater(50, lambda: self.tf.send(rospy.Time.now()))
        self.addCleanup(sender.stop)
        status = self.diagnostics.wait_for_new(
            lambda _, status: int(value_of(status, "tf messages")) >
            int(value_of(before, "tf messages")) + 2 * MESSAGES, "%d messages" % (2 * MESSAGES))
        mean, maximum = [float(value_of(status, key)) for key in (MEAN, MAXIMUM)]
        longest = float(value_of(status, LONGEST))
        self.assertTrue(0 < mean <= maximum <= longest, "%g, %g, %g" % (mean, maximum, longest))
        sender.stop()
        status = self.diagnostics.wait_for_new(
            lambda _, status: value_of(status, MEAN) == "none", "a second without messages")
        self.assertEqual(value_of(status, MAXIMUM), "none")
        self.assertGreaterEqual(float(value_of(status, LONGEST)), longest)

    def test_tells_what_became_of_transforms(self):
        load(NODE, ARMS)
        keys = ["transforms taken", "of those late", "transforms refused, stamp repeated",
                "of those with another pose", "transforms refused, too old",
                "transforms refused, unusable"]

        def counts(status):
            return [int(value_of(status, key)) for key in keys]

        before = counts(self.diagnostics.wait_for_new(lambda *_: True, "a status"))
        start = rospy.Time.now() + rospy.Duration(100)  # later than all that was sent so far
        for seconds in (0, 1, 0.5, 1, -20):  # new, new, late, repeated, too old
            self.tf.send(start + rospy.Duration(seconds), links=["left"])
        broken = self.tf.transform("left", start + rospy.Duration(2), 30)
        broken.transform.rotation.w = math.nan
        self.tf.send_transforms(broken)
        self.tf.send(start + rospy.Duration(1), degrees=31, links=["left"])
        expected = [count + more for count, more in zip(before, [3, 1, 2, 1, 1, 1])]
        self.diagnostics.wait_for_new(lambda _, status: counts(status) == expected, "the counts")

    def test_tells_rate_and_lag(self):
        load(NODE, ARMS)
        late = rospy.Duration(5)
        sender = Repeater(50, lambda: self.tf.send(rospy.Time.now() - late))
        self.addCleanup(sender.stop)

        def is_right(_, status):
            lag = value_of(status, LAG)
            return (lag != "none" and 5000 < float(lag) < 10000 and
                    25 < float(value_of(status, "updates per second")) < 75)

        self.diagnostics.wait_for_new(is_right, "rate and lag")
        sender.stop()
        self.diagnostics.wait_for_new(
            lambda _, status: value_of(status, LAG) == "none" and
            float(value_of(status, "updates per second")) == 0, "silence")

    def test_new_stamps_of_other_bodies_do_not_hide_old_boxes(self):
        """As of a marker, or of an arm whose clock is right."""
        load(NODE, ARMS)
        late = rospy.Duration(5)
        objects = ObjectSender(NODE)

        def send():
            now = rospy.Time.now()
            self.tf.send(now - late, links=["left", "left_tip"])
            self.tf.send(now, links=["right"])
            objects.send(marker("now/1", stamp=now))

        sender = Repeater(30, send)
        self.addCleanup(objects.send, deletion("now/1"))
        self.addCleanup(sender.stop)
        status = self.diagnostics.wait_for_new(
            lambda _, status: status.level == DiagnosticStatus.WARN and re.search(
                r"boxes were up to \d{4} ms old", status.message), "boxes that are old")
        self.assertGreater(float(value_of(status, LAG)), 5000)

    def test_what_was_newest_and_goes_leaves_no_box_that_was_late(self):
        rospy.set_param("/robot_description", robot([box_link("base", (1, 2, 3))], []))
        node = NodeProcess("newest", timeout=0.0)
        self.addCleanup(node.end)
        statuses = Diagnostics(node.name)
        objects = ObjectSender(node.name)

        def wait_for(count):
            return statuses.wait_for_new(
                lambda _, status: value_of(status, "objects") == str(count), "%d objects" % count)

        objects.send(marker("old/1", stamp=rospy.Time.now() - rospy.Duration(30)))
        self.assertGreater(float(value_of(wait_for(1), LAG)), 30000)
        objects.send(marker("new/1", stamp=rospy.Time.now()))
        wait_for(2)
        objects.send(deletion("new/1"))
        lag = value_of(wait_for(1), LAG)
        self.assertTrue(lag == "none" or float(lag) < 20000, lag)

    def start_fresh(self, name="fresh", **parameters):
        """A node of its own: the longest callback counts since its start."""
        rospy.set_param("/robot_description", robot([box_link("base", (1, 2, 3))], []))
        node = NodeProcess(name, timeout=0.0, max_rate=0.5, **parameters)
        self.addCleanup(node.end)
        statuses = Diagnostics(node.name)
        statuses.wait_for_new(lambda _, status: value_of(status, "bounded links") == "1", "a robot")
        return node.name, statuses, self.longest_callback(statuses)

    @staticmethod
    def send_crowd(node):
        objects = ObjectSender(node)
        objects.send(marker("first/1"))  # after this one the next one must wait
        for i in range(0, CROWD, 10):  # one callback for all would be a long one
            objects.send(*[marker("crowd_of_objects/%d" % k) for k in range(i, i + 10)])

    @staticmethod
    def longest_callback(statuses):
        """The CPU time of the longest one so far [ms]."""
        return float(value_of(statuses.wait_for_new(lambda *_: True, "a status"),
                              "longest callback, CPU [ms]"))

    def test_what_a_timer_publishes_counts_as_a_callback(self):
        groups = {"group_%d" % i: ["crowd_of_objects/*"] for i in range(GROUPS)}
        node, statuses, before = self.start_fresh(groups=groups)
        boxes = Recorder(node + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        self.send_crowd(node)
        boxes.wait(lambda m: len(m.boxes) > CROWD, "the crowd")
        after = self.longest_callback(statuses)
        print("longest callback %.1f ms, then %.1f ms" % (before, after))
        self.assertGreater(after, 5 * before)

    def test_what_only_listeners_want_is_no_work_of_callbacks(self):
        """Beside a node to which nobody listens: a sanitizer slows both down."""
        alone, statuses_alone, _ = self.start_fresh("alone")
        self.send_crowd(alone)
        statuses_alone.wait_for_new(
            lambda _, status: int(value_of(status, "objects")) > CROWD, "the crowd")
        node, statuses, before = self.start_fresh()
        overlaps = Recorder(node + "/overlaps", BoxOverlapArray)
        self.addCleanup(overlaps.subscriber.unregister)
        overlaps.wait(lambda m: True, "the welcome")
        self.send_crowd(node)
        overlaps.wait(lambda m: len(m.overlaps) >= CROWD * (CROWD - 1) / 2, "all pairs")
        other, after = self.longest_callback(statuses_alone), self.longest_callback(statuses)
        print("longest callback %.1f ms, then %.1f ms; alone %.1f ms" % (before, after, other))
        self.assertLess(after, max(before, 2 * other) + LONG)

    def test_keys_are_those_of_the_page(self):
        """Words in capitals in a key of the page stand for a name."""
        mesh = '<link name="%s"><visual><geometry><mesh filename="%s"/></geometry></visual></link>'
        load(NODE, robot([mesh % ("base", MESH), mesh % ("lost", MESH)], [("base", "lost")]))
        for topic, kind in (("stopping", AxisAlignedBoxArray), ("earliest", EarliestContactArray)):
            self.addCleanup(Recorder(NODE + "/" + topic, kind).subscriber.unregister)
        sender = TfSender()  # of a frame that no other test has
        self.addCleanup(sender.end)
        sender.wait_for_listener()
        for seconds in (1002, 1000):
            sender.send(transform("base", "late", rospy.Time(seconds)))
        self.diagnostics.wait_for_new(
            lambda _, status: value_of(status, "publishers behind") == "1", "who is late")
        status = self.diagnostics.wait_for_new(
            lambda _, s: value_of(s, "boxes") == "1" and value_of(s, "stopping") and
            value_of(s, "earliest"), "boxes that are missing in all topics")
        with open(PAGE, encoding="utf-8") as page:
            rows = rows_below(page.read(), ["key", "value"])
        patterns = [re.sub(r"[A-Z]{4,}", ".+", re.escape(key)) for key, _ in rows]
        keys = [pair.key for pair in status.values]
        for key in keys:
            self.assertTrue(any(re.fullmatch(p, key) for p in patterns), "no row for " + key)
        for pattern in patterns:
            self.assertTrue(any(re.fullmatch(pattern, k) for k in keys), "no value for " + pattern)

    def test_tells_why_there_is_no_footprint(self):
        def wait_for_footprint(text):
            self.diagnostics.wait_for_new(lambda _, s: value_of(s, "footprint") == text, text)

        load(NODE, ARMS)
        self.tf.send(rospy.Time.now() + rospy.Duration(200))  # later than all that was sent
        wait_for_footprint("silent: nobody subscribes")
        footprints = Recorder(NODE + "/footprint", Polygon)
        self.addCleanup(footprints.subscriber.unregister)
        wait_for_footprint("published")
        load(NODE, robot([box_link("base", (1, 2, 3)), box_link("lost", (1, 1, 1))],
                         [("base", "lost")]))
        wait_for_footprint("silent: group robot is incomplete")
        load(NODE, ARMS, fixed_frame="nowhere")
        wait_for_footprint("silent: no link has a box")

    def test_comes_every_second(self):
        start = len(self.diagnostics.received)
        wait_for(lambda: len(self.diagnostics.received) > start + PERIODS, "some periods")
        times = [stamp.to_sec() for stamp, _, _ in self.diagnostics.received[start:]]
        mean = (times[PERIODS] - times[0]) / PERIODS
        self.assertGreater(mean, PERIOD - LATE)
        self.assertLess(mean, PERIOD + LATE * PATIENCE)


if __name__ == "__main__":
    rospy.init_node("diagnostics_test")
    rostest.rosrun("link_bounds", "diagnostics", DiagnosticsTest)
