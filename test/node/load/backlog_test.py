#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node that gets tf faster than it can serve: the newest message counts, and nothing else waits."""
import signal
import time
import unittest

import rospy
from bounds_testing import Recorder, TfSender, names_of, transform, wait_for
from diagnostic_msgs.msg import DiagnosticStatus
from load_testing import LoadTest, carried_cubes, cube, link_names, overlapping_cubes
from node_testing import NODE, SKIPPED, value_of
from patience import PATIENCE
from visualization_msgs.msg import Marker

HZ, SECONDS = 500, 10
TIMEOUT = 1.0  # s, of the node
LATE = 5 * PATIENCE  # s, that a busy machine may add to a second
OBJECTS = 500  # far more than a node can answer at 500 Hz, with their overlaps
MANY, SLOW = 3000, 250  # links, Hz: more tf in LONG_STOP than can be read in time
WAITED, MAY_WAIT = "most messages that waited, last second", 1000
READ = 64  # so many of the newest messages are always read
AGE = 1000 * PATIENCE  # ms; 100 are promised
BURST = 500  # messages while the node is stopped
CARRIED = 2000  # objects that move with links
MARKERS = 5000  # the same, with one object each
STOP, LONG_STOP = 0.5, 3.0  # s
FEW = BURST / 2  # boxes that a burst may cause; one or two are usual


class Backlog(LoadTest):
    def test_each_message_has_its_boxes_while_the_node_keeps_up(self):
        self.start_node()
        self.add([])
        self.statuses.wait_until_counted()
        start = time.monotonic()
        result = self.drive(100, 5)
        self.statuses.wait_until_counted()
        self.assertEqual(result["unanswered"], 0)
        self.assertEqual(result["updates"] + self.statuses.joined(start), result["sent"])
        self.assertEqual(self.statuses.skipped(start), 0)
        self.assertGreater(result["updates"], 0.9 * result["sent"])

    def test_a_listener_of_overlaps_makes_no_boxes_old(self):
        self.start_node(timeout=TIMEOUT)
        self.add(overlapping_cubes(OBJECTS))
        self.listen("overlaps")
        start = time.monotonic()
        driver = self.start_drive(HZ, SECONDS)
        time.sleep(SECONDS - 2)  # most of the load, no wait for a condition
        reload_seconds = self.reload_seconds()
        result = self.end_drive(driver)[0]
        self.statuses.wait_for_new(lambda _, status: "%d links incomplete" % self.LINKS in
                                   status.message, "stale links", 60)
        stale_after = time.monotonic() - start - SECONDS
        gap = self.statuses.longest_gap(start, time.monotonic())
        print("reload %.2f s, stale after %.2f s, diagnostics silent for %.2f s" % (
            reload_seconds, stale_after, gap))
        self.check_age(result, AGE)
        self.assertLess(reload_seconds, LATE)
        self.assertLess(stale_after, TIMEOUT + LATE)
        self.assertLess(gap, 1 + LATE)

    def test_what_waited_is_joined_and_counted(self):
        self.start_node()
        # With them an update takes far longer than to read a message, so that messages must wait.
        self.add(carried_cubes(CARRIED, link_names(self.LINKS)))
        tf = TfSender()
        tf.wait_for_listener()
        boxes = Recorder(NODE + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        boxes.wait_newest(lambda message: message.boxes, "boxes")
        self.statuses.wait_until_counted()
        before = self.statuses.newest("publications")
        start = time.monotonic()
        last = self.send_while_stopped(tf)
        newest = boxes.wait(lambda message: message.header.stamp == last, "the newest")
        self.statuses.wait_until_counted()
        count = self.statuses.newest("publications") - before
        print("%d messages, %d boxes, %d joined" % (BURST, count, self.statuses.joined(start)))
        self.assertLess(count, FEW)
        self.assertEqual(self.statuses.joined(start), BURST - count)
        self.assertEqual(len(names_of(newest)), self.LINKS + 1 + CARRIED)

    def test_no_single_marker_of_a_burst_is_lost(self):
        self.start_node()
        self.add([])
        boxes = Recorder(NODE + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)
        objects = rospy.Publisher(NODE + "/object", Marker, queue_size=2 * MARKERS)
        self.addCleanup(objects.unregister)
        wait_for(lambda: objects.get_num_connections() > 0, "the node takes objects")
        self.node.interrupt(signal.SIGSTOP)
        for i in range(MARKERS):
            objects.publish(cube(i, (0.2 * i, 1, 0)))
        self.node.interrupt(signal.SIGCONT)
        boxes.wait_newest(lambda message: "cube/%d" % (MARKERS - 1) in names_of(message),
                          "the last marker")
        self.assertEqual(len(names_of(boxes.messages[-1])), self.LINKS + 1 + MARKERS)

    def send_while_stopped(self, tf):
        """The stamp of the newest message."""
        self.node.interrupt(signal.SIGSTOP)
        end = time.monotonic() + STOP
        for i in range(BURST):
            stamp = rospy.Time.now() + rospy.Duration(nsecs=1000 * i)
            tf.send(*(transform("base", name, stamp, (0.001 * i, 0, 0))
                      for name in link_names(self.LINKS)))
        while time.monotonic() < end:
            time.sleep(0.01)  # the rest of the stop
        self.node.interrupt(signal.SIGCONT)
        return stamp

    def test_what_cannot_be_read_in_time_is_skipped_and_told(self):
        self.LINKS = MANY
        self.start_node()
        self.add([])
        self.statuses.wait_until_counted()
        before = self.statuses.newest("publications")
        start = time.monotonic()
        driver = self.start_drive(SLOW, SECONDS)
        wait_for(lambda: self.statuses.newest("tf messages") > SLOW, "a second of tf")
        self.node.interrupt(signal.SIGSTOP)
        time.sleep(LONG_STOP)
        self.node.interrupt(signal.SIGCONT)
        result = self.end_drive(driver)[0]
        self.statuses.wait_until_counted()
        skipped = self.statuses.skipped(start)
        self.assertGreater(skipped, 0)
        self.assertEqual(result["unanswered"], 0, "the newest has boxes")
        published = self.statuses.newest("publications") - before
        lost = result["sent"] - published - self.statuses.joined(start) - skipped
        waited = max(float(value_of(status, WAITED)) for _, status, _ in self.statuses.since(start))
        print("%d of %d messages skipped, %d lost; %d waited at once; %d boxes sent, %d received" % (
            skipped, result["sent"], lost, waited, published, result["updates"]))
        self.assertEqual(lost, 0)
        # Of those that wait for a slow subscriber, the oldest may be dropped: 8 MB are 15 messages.
        self.assertLessEqual(result["updates"], published)
        for _, status, _ in self.statuses.since(start):
            if value_of(status, SKIPPED) != "0":
                self.assertGreater(float(value_of(status, WAITED)), READ)
        self.assertEqual(waited >= MAY_WAIT, any(
            "may have been dropped" in status.message for _, status, _ in self.statuses.since(start)))
        self.assertTrue(any(status.level == DiagnosticStatus.WARN and "faster" in status.message
                            for _, status, _ in self.statuses.since(start)))
        calm = self.statuses.wait_for_new(
            lambda _, status: value_of(status, SKIPPED) == "0", "nothing skipped")
        self.assertNotIn("faster", calm.message)


if __name__ == "__main__":
    unittest.main()
