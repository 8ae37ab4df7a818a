#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""~get_boxes before there is a robot, under many large requests, with clients that die, beside
reloads and clock jumps, and at the end of the node. ~boxes go on undisturbed beside a node that
nobody asks."""
import itertools
import os
import signal
import threading

import rospy
import rostest
from bounds_testing import (DEADLINE, Recorder, box_link, box_of, corners_of, load, names_of,
                            robot, transform, wait_for)
from dying_client import DyingClient
from link_bounds.srv import GetBoxes, GetBoxesRequest
from node_testing import (SANITIZED, Delays, Diagnostics, NodeProcess, OwnNodes, Repeater,
                          SimulatedClock)
from patience import PATIENCE
from tf2_msgs.msg import TFMessage

LINKS = 20
SAMPLES = 200 if SANITIZED else 1000  # per link, in 10 s
REQUESTS = 30 if SANITIZED else 100
MAX_DELAY = 0.3 * PATIENCE  # wall seconds beyond what the machine takes
PROMPT = 10.0 * PATIENCE  # s, for the end of a node
NAMES = ["arm_%d" % i for i in range(LINKS)]
MANY = robot([box_link(name, (1, 1, 1)) for name in ["base"] + NAMES],
             [("base", name) for name in NAMES])
WHOLE = GetBoxesRequest(span=rospy.Duration(9))


def rests_of_long_work(pid):
    """How often the threads that let others go first have had nothing to do any more."""
    count = 0
    for thread in os.listdir("/proc/%d/task" % pid):
        if os.getpriority(os.PRIO_PROCESS, int(thread)) == 0:
            continue
        with open("/proc/%d/task/%s/status" % (pid, thread), encoding="ascii") as file:
            count += next(int(line.split()[1]) for line in file
                          if line.startswith("voluntary_ctxt_switches:"))
    return count


class GetBoxesFaults(OwnNodes):
    @staticmethod
    def service(node):
        rospy.wait_for_service(node.name + "/get_boxes", DEADLINE)
        return rospy.ServiceProxy(node.name + "/get_boxes", GetBoxes)

    def send(self, stamp, x=0.0, names=tuple(NAMES)):
        self.tf.send(*(transform("base", name, stamp, (x, 0, 0)) for name in names))

    def fill_history(self, *nodes):
        """Ten seconds of all links; returns the newest stamp."""
        begin = next(self.stamps) * 100
        for first in range(0, SAMPLES, 50):
            stamps = [rospy.Time(0, begin * 10**9 + i * (10**10 // SAMPLES))
                      for i in range(first, first + 50)]
            self.tf.publish(TFMessage([transform("base", name, stamp, (0.1, 0, 0))
                                       for stamp in stamps for name in NAMES]))
        for node in nodes:
            Recorder(node.name + "/boxes").wait(lambda m: m.header.stamp >= stamps[-1], "history")
        return stamps[-1]

    def test_before_there_is_a_robot(self):
        if rospy.has_param("/robot_description"):
            rospy.delete_param("/robot_description")
        node = NodeProcess(next(self.names))
        self.addCleanup(node.end)
        answer = self.service(node)()
        self.assertFalse(answer.success)
        self.assertIn("no robot was loaded", answer.message)

    def test_spans_whose_nanoseconds_are_more_than_a_second(self):
        """They count as spans, which are long work; negative spans are refused."""
        node = self.start(MANY)
        call = self.service(node)
        request = GetBoxesRequest()
        self.assertTrue(call(request).success)
        before = rests_of_long_work(node.pid)
        request.span.secs, request.span.nsecs = -1, 2 * 10**9
        self.assertTrue(call(request).success)
        wait_for(lambda: rests_of_long_work(node.pid) > before, "it was long work")
        request.span.secs, request.span.nsecs = 1, -2 * 10**9
        answer = call(request)
        self.assertFalse(answer.success)
        self.assertIn("0 or more", answer.message)
        request = GetBoxesRequest()
        request.stamp.secs = 2**32 - 1
        self.assertIn("stamp is no time that tf can handle", call(request).message)

    def test_many_large_requests_at_once_beside_boxes(self):
        """And clients that die. Every other client gets its right answer."""
        node, other = self.start(MANY), self.start(MANY)
        wait_for(lambda: self.tf.listeners() == 2, "both listen to tf")
        self.service(node)
        newest = self.fill_history(node, other)
        delays = Delays(node.name, other.name)
        self.addCleanup(delays.end)
        ticks = itertools.count(1)

        def move():
            stamp = newest + rospy.Duration(0, 10**6 * next(ticks))
            delays.record(stamp)
            self.send(stamp, 0.1)

        mover = Repeater(50.0, move)
        self.addCleanup(mover.stop)
        for name in (node.name, other.name):
            wait_for(lambda n=name: Recorder(n + "/boxes").messages, name)
        answers, failures = [], []

        def ask():
            try:
                answers.append(self.service(node)(WHOLE))
            except rospy.ServiceException as error:
                failures.append(error)

        threads = [threading.Thread(target=ask, daemon=True) for _ in range(REQUESTS)]
        for i, thread in enumerate(threads):
            thread.start()
            if i % 10 == 0:
                DyingClient(node.name + "/get_boxes", WHOLE)
        wait_for(lambda: len(answers) + len(failures) == REQUESTS, "all answers",
                 120.0 * PATIENCE)
        mover.stop()
        self.assertEqual(failures, [])
        for answer in answers:
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(names_of(answer.boxes), ["base"] + NAMES, answer.message)
            self.assertTrue(all(abs(c) < 0.602 for box in answer.boxes.boxes
                                for c in corners_of(box)))
        self.assertLess(delays.longest(node.name), delays.longest(other.name) + MAX_DELAY)
        self.assertTrue(node.is_running)

    def test_reload_between_requests(self):
        """Each answer belongs to one robot."""
        first, second = (robot([box_link(name, (size,) * 3) for name in names], [tuple(names)])
                         for names, size in ((["base", "arm"], 1.0), (["base", "leg"], 2.0)))
        node = self.start(first)
        call = self.service(node)
        robots = {("base", "arm"): 1.0, ("base", "leg"): 2.0}
        stop = threading.Event()
        wrong, seen = [], []

        def ask():
            while not stop.is_set():
                answer = call()
                names = tuple(names_of(answer.boxes)) + tuple(answer.boxes.incomplete)
                box = corners_of(box_of(answer.boxes, "base"))
                seen.append(names)
                if abs(box[3] * 2 - robots.get(names, 0.0)) > 1e-9:
                    wrong.append(answer)

        thread = threading.Thread(target=ask, daemon=True)
        thread.start()
        for description, names in ((second, ("base", "leg")), (first, ("base", "arm"))) * 3:
            load(node.name, description)
            count = len(seen)
            wait_for(lambda n=names, c=count: n in seen[c:], "an answer of the new robot")
        stop.set()
        thread.join()
        self.assertEqual(wrong, [])

    def test_a_clock_jump(self):
        """After a clock jump no request gets a box of the time before it."""
        rospy.set_param("/use_sim_time", True)
        self.addCleanup(rospy.delete_param, "/use_sim_time")
        node = self.start(robot([box_link(name, (1, 1, 1)) for name in ("base", "arm")],
                                [("base", "arm")]))
        boxes = Recorder(node.name + "/boxes")
        clock = SimulatedClock(Diagnostics(node.name))
        call = self.service(node)
        at_99 = GetBoxesRequest(stamp=rospy.Time(99))
        clock.set(100)
        for stamp in (98, 100):
            self.send(rospy.Time(stamp), stamp, ["arm"])
        boxes.wait(lambda m: m.header.stamp == rospy.Time(100), "before")
        answer = call(at_99)
        self.assertAlmostEqual(box_of(answer.boxes, "arm").max.x, 99.5)
        clock.set(99)
        boxes.wait_newest(lambda m: m.incomplete == ["arm"], "the jump")
        answer = call(at_99)
        self.assertEqual((answer.success, answer.boxes.incomplete), (True, ["arm"]))
        for stamp in (98.5, 99.5):
            self.send(rospy.Time(stamp), 1, ["arm"])
        boxes.wait_newest(lambda m: m.header.stamp == rospy.Time(99.5), "after")
        self.assertAlmostEqual(box_of(call(at_99).boxes, "arm").max.x, 1.5)
        self.assertEqual(call(stamp=rospy.Time(98)).boxes.incomplete, ["arm"])

    def test_end_while_requests_are_answered_and_wait(self):
        for end in (signal.SIGINT, signal.SIGTERM):
            node = self.start(MANY)
            service = self.service(node)
            self.fill_history(node)
            answers = []

            def ask(call=service, result=answers):
                while True:
                    try:
                        result.append(call(WHOLE))
                    except (rospy.ServiceException, rospy.ROSInterruptException):
                        return

            threads = [threading.Thread(target=ask, daemon=True) for _ in range(5)]
            for thread in threads:
                thread.start()
            wait_for(lambda result=answers: result, "an answer")
            node.interrupt(end)
            self.assertEqual(node.wait(PROMPT), 0, node.output)
            node.end()


if __name__ == "__main__":
    rospy.init_node("get_boxes_faults_test")
    rostest.rosrun("link_bounds", "get_boxes_faults", GetBoxesFaults)
