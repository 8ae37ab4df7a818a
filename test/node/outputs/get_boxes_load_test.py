#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spans of ~get_boxes that would take minutes: they are answered after ten seconds with what is
there, and nobody else waits for them: neither requests at one time, nor short spans, nor ~swept,
nor the end of the node."""
import itertools
import os
import signal
import threading
import time

import rospy
import rostest
from bounds_testing import (DEADLINE, Recorder, TfSender, box_link, box_of, names_of, robot,
                            transform, turn, wait_for)
from dying_client import DyingClient
from link_bounds.srv import GetBoxes, GetBoxesRequest
from node_testing import SANITIZED, OwnNodes, Repeater, resident_bytes
from tf2_msgs.msg import TFMessage

# A link takes 0.2 s or more where a processor is free: all of them take ten times the deadline.
LINKS = ["far_%d" % i for i in range(600)]
NAMES = ["base", "near"] + LINKS
SPINNER = robot([box_link(name, (1, 1, 1)) for name in NAMES],
                [("base", name) for name in NAMES[1:]])
FAR = 10.0 if SANITIZED else 100.0  # m
HZ = 100
SPAN = 5  # s
TOO_LONG = 10 * 10.0  # s, ten times the deadline of a request
NEAR_HZ = 20.0
GONE = 60  # clients
CHAIN = 200  # edges
COPIED_LINKS = 100
COPY = COPIED_LINKS * HZ * SPAN * 80  # bytes of a copy of their transforms
CLIENTS = 60


def cpu_seconds(pid):
    """What all threads of a process have taken so far."""
    with open("/proc/%d/stat" % pid, encoding="ascii") as file:
        user, system = file.read().rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


class GetBoxesLoad(OwnNodes):
    def start(self, description, **parameters):
        """The node, and a function that calls its service."""
        node = super().start(description, **parameters)
        rospy.wait_for_service(node.name + "/get_boxes", DEADLINE)
        return node, rospy.ServiceProxy(node.name + "/get_boxes", GetBoxes)

    def send_spins(self, edges, seconds, x=0.1):
        """Each edge turns by 170 degrees from sample to sample."""
        for i in range(int(seconds * HZ) + 1):
            stamp = rospy.Time(0, 10**12 + i * 10**9 // HZ)
            self.tf.publish(TFMessage([
                transform(parent, child, stamp, (x, 0, 0), turn((0, 0, 1), 170.0 * i))
                for parent, child in edges]))
        return stamp

    def start_spinner(self):
        """A node whose links are far from an axis about which they turn, but for one nearby."""
        node, call = self.start(SPINNER, swept_span=1e-4)
        static = TfSender(is_static=True)
        self.addCleanup(static.end)
        static.wait_for_listener()
        static.send(*(transform("spinner", name, rospy.Time(), (FAR + i, 0, 0))
                      for i, name in enumerate(LINKS)))
        newest = self.send_spins([("base", "spinner"), ("base", "near")], SPAN)
        self.boxes.wait_newest(lambda m: names_of(m) == NAMES and m.header.stamp == newest,
                               "all boxes")
        stamps = (newest + rospy.Duration(0, i * 10**6) for i in itertools.count(1))
        mover = Repeater(NEAR_HZ, lambda: self.tf.send(transform("base", "near", next(stamps))))
        self.addCleanup(mover.stop)
        return node, call, GetBoxesRequest(stamp=newest, span=rospy.Duration(SPAN))

    def answers_of(self, call, request, count):
        """The answers to so many clients at once, as a list that fills."""
        answers = []
        threads = [threading.Thread(target=lambda: answers.append(call(request)), daemon=True)
                   for _ in range(count)]
        for thread in threads:
            thread.start()
        return answers

    def check_partial(self, answer):
        """Each link has its whole box, or is named."""
        self.assertTrue(answer.success, answer.message)
        boxes = answer.boxes
        self.assertGreater(len(boxes.incomplete), 0)
        self.assertEqual(sorted(names_of(boxes) + boxes.incomplete), sorted(NAMES))
        self.assertTrue(answer.message.startswith(boxes.incomplete[0] + ": there was no time"),
                        answer.message)
        self.assertIn("; %d boxes were not computed within 10 s" % len(boxes.incomplete),
                      answer.message)

    def test_nobody_waits_for_long_spans(self):
        node, call, long_span = self.start_spinner()
        swept = Recorder(node.name + "/swept")
        swept.wait(lambda m: True, "~swept")
        begin = time.monotonic()
        swept.clear()
        answers = self.answers_of(call, long_span, 2)
        moments, short_spans = [], []
        short_span = GetBoxesRequest(span=rospy.Duration(0, 1000000), names=["near"])

        def ask_short_spans():
            while len(answers) < 2:
                short_spans.append(call(short_span))

        thread = threading.Thread(target=ask_short_spans, daemon=True)
        thread.start()
        while len(answers) < 2 and time.monotonic() < begin + TOO_LONG:
            moments.append(call(GetBoxesRequest()))
            time.sleep(0.01)  # leaves processors to the others
        self.assertEqual(len(answers), 2, "after %g s" % TOO_LONG)
        taken, swept_count = time.monotonic() - begin, len(swept.messages)
        thread.join()
        print("two long spans took %.1f s; meanwhile %d requests at one time, %d short spans, "
              "%d messages of ~swept" % (taken, len(moments), len(short_spans), swept_count))
        for answer in answers:
            self.check_partial(answer)
            self.assertGreater(len(names_of(answer.boxes)), len(["base", "near"]))
        link = LINKS[0]
        alone = call(GetBoxesRequest(stamp=long_span.stamp, span=long_span.span, names=[link]))
        self.assertEqual(alone.boxes.boxes, [box_of(answers[0].boxes, link)])
        # None of these waits for the spans, which take their whole ten seconds.
        self.assertGreater(len(moments), 20)
        self.assertTrue(all(names_of(answer.boxes) == NAMES for answer in moments))
        self.assertGreater(len(short_spans), 2)
        self.assertTrue(all(names_of(answer.boxes) == ["near"] for answer in short_spans))
        self.assertGreater(swept_count, 20)

    def test_clients_that_are_gone_cost_nothing(self):
        node, call, long_span = self.start_spinner()
        alone = call(long_span)
        for _ in range(GONE):
            DyingClient(node.name + "/get_boxes", long_span)
        beside = call(long_span)
        counts = [len(names_of(answer.boxes)) for answer in (alone, beside)]
        print("boxes alone, and behind %d clients that are gone: %r" % (GONE, counts))
        for answer in (alone, beside):
            self.check_partial(answer)
        # With turns for all of them it would be a sixtieth.
        self.assertGreater(counts[1], counts[0] / 6)

    def test_the_memory_of_many_spans(self):
        """Few are begun while the copies of tf for others are in memory; all are answered."""
        links = LINKS[:COPIED_LINKS]
        node, call = self.start(robot([box_link(name, (1, 1, 1)) for name in ["base"] + links],
                                      [("base", name) for name in links]))
        newest = self.send_spins([("base", "spinner")] + [("spinner", name) for name in links],
                                 SPAN, 3.0)
        self.boxes.wait_newest(lambda m: m.header.stamp == newest and not m.incomplete, "all boxes")
        request = GetBoxesRequest(stamp=newest, span=rospy.Duration(SPAN))
        before = most = resident_bytes(node.pid)
        answers = self.answers_of(call, request, CLIENTS)
        end = time.monotonic() + TOO_LONG
        while len(answers) < CLIENTS and time.monotonic() < end:
            most = max(most, resident_bytes(node.pid))
            time.sleep(0.01)  # leaves processors to the others
        self.assertEqual(len(answers), CLIENTS)
        begun = [answer for answer in answers if answer.success]
        print("%d of %d spans were begun; %d MB more memory" % (
            len(begun), CLIENTS, (most - before) >> 20))
        for answer in answers:
            self.assertIn("within 10 s", answer.message)
        self.assertGreater(len(begun), 0)
        self.assertLess(len(begun), CLIENTS)
        if SANITIZED:
            print("skipped: memory of many spans, a sanitizer needs more")
        else:
            self.assertLess(most - before, CLIENTS * COPY / 2)

    def test_the_end_of_the_node(self):
        """While one link alone takes long."""
        frames = ["base"] + ["frame_%d" % i for i in range(CHAIN - 1)] + ["tip"]
        node, call = self.start(robot([box_link(name, (1, 1, 1)) for name in ("base", "tip")],
                                      [("base", "tip")]))
        newest = self.send_spins(list(zip(frames, frames[1:])), 1)
        self.boxes.wait_newest(lambda m: m.header.stamp == newest, "the newest boxes")
        answered = threading.Event()

        def ask():
            while True:
                try:
                    call(GetBoxesRequest(span=rospy.Duration(0, 5 * 10**8)))
                except (rospy.ServiceException, rospy.ROSInterruptException):
                    return
                finally:
                    answered.set()

        for _ in range(5):
            threading.Thread(target=ask, daemon=True).start()
        start = cpu_seconds(node.pid)
        wait_for(lambda: cpu_seconds(node.pid) > start + 1.0, "the node computes")
        self.assertFalse(answered.is_set(), "one link takes longer")
        begin = time.monotonic()
        node.interrupt(signal.SIGINT)
        self.assertEqual(node.wait(DEADLINE), 0, node.output)
        taken = time.monotonic() - begin
        print("the node ended within %.2f s" % taken)
        self.assertLess(taken, 5.0)


if __name__ == "__main__":
    rospy.init_node("get_boxes_load_test")
    rostest.rosrun("link_bounds", "get_boxes_load", GetBoxesLoad)
