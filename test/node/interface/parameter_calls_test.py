#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A failed call of the parameter server is repeated; a failure never counts as "not set"."""
import http.client
import http.server
import itertools
import os
import threading
import time
import unittest
import xmlrpc.client

import rospy
from bounds_testing import Recorder, box_link, box_of, robot, wait_for
from node_testing import NodeProcess
from own_master import OwnMasterTest
from patience import PATIENCE
from std_srvs.srv import Trigger

ANSWERS = 15.0 * PATIENCE  # wall seconds until ~reload answers, on a busy machine
CLOSED, ERROR_500, SILENT = "closed", "error 500", "silent"
PADDING = 0.5  # m
NODE = "/cell/publisher"
PREFIX = "/cell/tf_prefix"
DESCRIPTION = "/cell/robot_description"
# Each call that the node makes for its parameters: method and name.
CALLS = [("getParam", NODE), ("searchParam", "tf_prefix"), ("getParam", PREFIX),
         ("searchParam", "robot_description"), ("getParam", DESCRIPTION)]


class Proxy:
    """A master that forwards calls to the real one, but leaves those unanswered that it drops."""

    def __init__(self, port):
        self._port = port
        self.dropped = []  # methods and names of the calls that were dropped
        self._to_drop = None
        self._times = 0
        self._how = CLOSED
        proxy = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self):
                proxy.answer(self)

            def log_message(self, *_):
                pass

        self._server = http.server.ThreadingHTTPServer(("localhost", 0), Handler)
        self._server.daemon_threads = True
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        self.uri = "http://localhost:%d" % self._server.server_port
        self._end = threading.Event()

    def drop(self, call, times=1, how=CLOSED):
        self.dropped = []
        self._to_drop, self._times, self._how = call, times, how

    def answer(self, request):
        body = request.rfile.read(int(request.headers["Content-Length"]))
        arguments, method = xmlrpc.client.loads(body)
        if (method, arguments[-1]) == self._to_drop and len(self.dropped) < self._times:
            self.dropped.append(self._to_drop)
            self._refuse(request)
            return
        master = http.client.HTTPConnection("localhost", self._port)
        master.request("POST", "/RPC2", body, {"Content-Type": "text/xml"})
        answer = master.getresponse().read()
        master.close()
        request.send_response(200)
        request.send_header("Content-Type", "text/xml")
        request.send_header("Content-Length", str(len(answer)))
        request.end_headers()
        request.wfile.write(answer)

    def _refuse(self, request):
        if self._how == ERROR_500:
            request.send_error(500)
        elif self._how == SILENT:
            self._end.wait()
        request.close_connection = True

    def end(self):
        self._end.set()
        self._server.shutdown()
        self._server.server_close()


class ParameterCalls(OwnMasterTest):
    def setUp(self):
        self.proxy = Proxy(self.master.port)
        self.addCleanup(self.proxy.end)
        rospy.set_param(NODE, {"padding": PADDING, "timeout": 0.0})
        rospy.set_param(PREFIX, "cell")
        rospy.set_param(DESCRIPTION, robot([box_link("base", (1, 1, 1))], []))

    def start(self):
        """To be used in a with statement, which ends the node."""
        return NodeProcess("publisher", ["__ns:=/cell"],
                           dict(os.environ, ROS_MASTER_URI=self.proxy.uri))

    def check_boxes(self, node, padding=PADDING):
        boxes = Recorder(NODE + "/boxes")
        self.addCleanup(boxes.subscriber.unregister)

        def first():
            self.assertTrue(node.is_running, node.output)
            return boxes.messages
        message = wait_for(first, "boxes")[-1]
        self.assertEqual(message.header.frame_id, "cell/base")
        self.assertAlmostEqual(box_of(message, "base").max.x, 0.5 + padding, delta=1e-9)
        boxes.subscriber.unregister()

    def reload(self):
        rospy.wait_for_service(NODE + "/reload")
        return rospy.ServiceProxy(NODE + "/reload", Trigger)()

    def test_a_call_that_fails_once_is_made_again(self):
        for how in (CLOSED, ERROR_500):
            for call in CALLS:
                with self.subTest(how=how, call=call):
                    self.proxy.drop(call, how=how)
                    with self.start() as node:
                        self.check_boxes(node)
                    self.assertEqual(self.proxy.dropped, [call])

    def test_a_call_that_always_fails_ends_the_start_with_a_reason(self):
        for how, call in zip(itertools.cycle((CLOSED, SILENT)), CALLS[:3]):
            with self.subTest(how=how, call=call):
                self.proxy.drop(call, 10 ** 6, how)
                with self.start() as node:
                    self.assertEqual(node.wait(), 1)
                    self.assertEqual(node.output.count("FATAL"), 1, node.output)
                    self.assertIn("the ROS master does not answer " + call[0], node.output)

    def test_the_description_is_waited_for_while_the_master_is_away(self):
        for call in CALLS[3:]:
            with self.subTest(call=call):
                self.proxy.drop(call, 10 ** 6)
                with self.start() as node:
                    wait_for(lambda n=node: "waiting for parameter robot_description" in n.output,
                             "it says what it waits for")
                    self.proxy.drop(None)
                    self.check_boxes(node)

    def test_a_reload_whose_call_fails_changes_nothing(self):
        node = self.start()
        self.addCleanup(node.end)
        self.check_boxes(node)
        rospy.set_param(NODE + "/padding", 2 * PADDING)
        for how, call in zip(itertools.cycle((CLOSED, SILENT)), CALLS):
            with self.subTest(how=how, call=call):
                self.proxy.drop(call, 10 ** 6, how)
                start = time.monotonic()
                answer = self.reload()
                self.assertLess(time.monotonic() - start, ANSWERS)
                self.assertFalse(answer.success)
                self.assertIn("the ROS master does not answer " + call[0], answer.message)
                self.proxy.drop(None)
                self.check_boxes(node)
        self.assertTrue(self.reload().success)
        self.check_boxes(node, 2 * PADDING)


if __name__ == "__main__":
    unittest.main()
