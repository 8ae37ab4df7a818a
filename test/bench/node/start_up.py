# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the start of the node's process to its first boxes that lack nothing, all meshes loaded; and
the memory of the node then, and of its tables."""
import re
import statistics
import subprocess
import threading
import time
import xml.etree.ElementTree as ElementTree

import rospy
from geometry_msgs.msg import TransformStamped
from node_process import DEADLINE, Master, megabytes, program
from report import Table
from robots import DEMO, public
from tf2_msgs.msg import TFMessage

from link_bounds.msg import AxisAlignedBoxArray

QUICK = "3 repetitions"


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


def start_once(master, name_space):
    """Starts the node, and ends it when its boxes are complete. Returns the seconds it took, and
    the memory of the node: its peak and at the end [MB]."""
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
    memory = {"peak_mb": megabytes(process.pid, "VmHWM"),
              "resident_mb": megabytes(process.pid, "VmRSS")}
    subscriber.unregister()
    master.end(process)
    return {"median_ms": 1e3 * seconds, **memory}


def tables_of(path):
    """The memory of the robot's meshes, and the peak of the program that loads them [MB]."""
    text = subprocess.run([*program("urdf_bounds"), "--verbose", path], check=True,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE).stderr.decode()
    tables = re.search(r"(\d+) bytes in (\d+) mesh files", text)
    peak = re.search(r"(\d+) kB of memory at the peak", text)
    return {"tables_mb": round(int(tables.group(1)) / 1e6, 2), "files": int(tables.group(2)),
            "loading_mb": round(int(peak.group(1)) * 1024 / 1e6, 1)}


def row_of(robot, path, repetitions, master):
    with open(path, encoding="utf-8") as file:
        description = file.read()
    master.parameters.setParam("/%s/robot_description" % robot, description)
    publisher = rospy.Publisher("/%s/tf_static" % robot, TFMessage, queue_size=1, latch=True)
    publisher.publish(transforms_of(description))
    starts = [start_once(master, "/" + robot) for _ in range(repetitions)]
    row = {"robot": robot, "starts": repetitions, **tables_of(path)}
    for figure in starts[0]:
        row[figure] = round(statistics.median(start[figure] for start in starts), 1)
    row["shortest_ms"] = round(min(start["median_ms"] for start in starts), 1)
    row["longest_ms"] = round(max(start["median_ms"] for start in starts), 1)
    return row


def measure(options):
    robots = {"demo": DEMO, **public("panda", "pr2")}
    table = Table("From the start to complete boxes", {
        "robot": "robot", "median_ms": "ms", "shortest_ms": "shortest", "longest_ms": "longest",
        "starts": "starts", "resident_mb": "node MB", "peak_mb": "peak MB", "files": "mesh files",
        "tables_mb": "tables MB", "loading_mb": "loading MB"}, robot=6)
    rows = []
    with Master() as master:
        rospy.init_node("start_up", disable_signals=True)
        for robot, path in robots.items():
            rows.append(row_of(robot, path, 3 if options.quick else 11, master))
            table.add(rows[-1])
        rospy.signal_shutdown("done")
    return rows
