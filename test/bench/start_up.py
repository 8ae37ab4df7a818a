#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the start of the node's process to its first boxes that lack nothing, all meshes loaded.
start_up.py [--quick] [--json FILE]"""
import argparse
import json
import os
import statistics
import threading
import time
import xml.etree.ElementTree as ElementTree

import rospy
from geometry_msgs.msg import TransformStamped
from node_process import DEADLINE, Master
from tf2_msgs.msg import TFMessage

from link_bounds.msg import AxisAlignedBoxArray

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.environ.get("LINK_BOUNDS_DATA")
ROBOTS = {"demo": REPOSITORY + "/launch/demo/demo.urdf"}
if DATA:
    ROBOTS["panda"] = DATA + "/robots/franka_description/urdf/panda.urdf"
    ROBOTS["pr2"] = DATA + "/robots/pr2_description/urdf/pr2.urdf"


def transforms_of(description):
    """All joints as static transforms; where they are does not matter here."""
    message = TFMessage()
    for joint in ElementTree.fromstring(description).iterfind("joint"):
        transform = TransformStamped()
        transform.header.frame_id = joint.find("parent").get("link")
        transform.child_frame_id = joint.find("child").get("link")
        transform.transform.rotation.w = 1
        message.transforms.append(transform)
    return message


def seconds_to_first_boxes(master, name_space):
    """Starts the node, and ends it when its boxes are complete."""
    complete = threading.Event()

    def on_boxes(message):
        if message.boxes and not message.incomplete:
            complete.set()

    subscriber = rospy.Subscriber(name_space + "/node/boxes", AxisAlignedBoxArray, on_boxes,
                                  tcp_nodelay=True)
    start = time.monotonic()
    process = master.start_node("link_bounds_publisher", name_space)
    if not complete.wait(DEADLINE):
        raise RuntimeError("no complete boxes within %d s" % DEADLINE)
    seconds = time.monotonic() - start
    subscriber.unregister()
    master.end(process)
    return seconds


def measure(robot, repetitions, master):
    with open(ROBOTS[robot], encoding="utf-8") as file:
        description = file.read()
    master.parameters.setParam("/%s/robot_description" % robot, description)
    publisher = rospy.Publisher("/%s/tf_static" % robot, TFMessage, queue_size=1, latch=True)
    publisher.publish(transforms_of(description))
    return [seconds_to_first_boxes(master, "/" + robot) for _ in range(repetitions)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="3 repetitions")
    parser.add_argument("--json", metavar="FILE", help="the rows as JSON, too")
    options = parser.parse_args()
    if not DATA:
        print("LINK_BOUNDS_DATA is not set: only the demo's robot is measured")
    rows = []
    with Master() as master:
        rospy.init_node("start_up", disable_signals=True)
        for robot in ROBOTS:
            seconds = measure(robot, 3 if options.quick else 11, master)
            rows.append({"robot": robot, "median_ms": round(1e3 * statistics.median(seconds), 1),
                         "shortest_ms": round(1e3 * min(seconds), 1),
                         "longest_ms": round(1e3 * max(seconds), 1)})
            print("%-6s %6.0f ms (from %.0f to %.0f in %d starts)" % (
                robot, rows[-1]["median_ms"], rows[-1]["shortest_ms"], rows[-1]["longest_ms"],
                len(seconds)), flush=True)
        rospy.signal_shutdown("done")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)


if __name__ == "__main__":
    main()
