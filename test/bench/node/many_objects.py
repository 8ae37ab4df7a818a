# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What many objects cost the running node: a thousand that move at 100 Hz, and the memory of ten
thousand that come and go."""
import io
import statistics
import time

import rospy
from node_process import Master, cpu_seconds, megabytes, wait_for
from report import print_table
from visualization_msgs.msg import Marker, MarkerArray

from link_bounds.msg import AxisAlignedBoxArray

QUICK = "5 seconds instead of 20"
MOVING, HZ = 1000, 100
MANY = 10000
STEPS = 50  # messages made beforehand, used in turn


class Prepared(MarkerArray):
    """Serialized beforehand, so that sending takes little time of this process."""
    __slots__ = ["prepared"]

    def serialize(self, buff):
        buff.write(self.prepared)


def message(count, step=0, action=Marker.ADD):
    """Cubes in a row, which move a little with each step."""
    array = MarkerArray()
    for i in range(count):
        marker = Marker(ns="many", id=i, type=Marker.CUBE, action=action)
        marker.header.frame_id = "map"
        marker.pose.position.x, marker.pose.position.y = 0.1 * i, 0.001 * step
        marker.pose.orientation.z, marker.pose.orientation.w = 0.6, 0.8
        marker.scale.x, marker.scale.y, marker.scale.z = 0.1, 0.2, 0.3
        array.markers.append(marker)
    buffer = io.BytesIO()
    array.serialize(buffer)
    result = Prepared()
    result.prepared = buffer.getvalue()
    return result


class Boxes:
    """The newest ~boxes, when it came, and how many came before."""

    def __init__(self, topic):
        self.newest, self.time, self.count = None, 0, 0
        rospy.Subscriber(topic, rospy.AnyMsg, self._receive, tcp_nodelay=True)

    def _receive(self, raw):
        self.newest, self.time = raw, time.monotonic()
        self.count += 1

    def wait(self, number):
        """Until that many boxes have come."""
        wait_for(lambda: self.newest and self._number() == number, "%d boxes" % number)

    def _number(self):
        array = AxisAlignedBoxArray()
        array.deserialize(self.newest._buff)  # pylint: disable=protected-access
        return len(array.boxes)


def move(publisher, boxes, pid, seconds):
    """The node's share of a core, and how old the boxes of a message are when they come."""
    messages = [message(MOVING, step) for step in range(STEPS)]
    publisher.publish(messages[0])
    boxes.wait(MOVING)
    ages = []
    start, cpu = time.monotonic(), cpu_seconds(pid)
    for i in range(int(seconds * HZ)):
        count, sent = boxes.count, time.monotonic()
        publisher.publish(messages[(i + 1) % STEPS])
        time.sleep(max(0, start + (i + 1) / HZ - time.monotonic()))
        if boxes.count > count:
            ages.append(1e3 * (boxes.time - sent))
    share = (cpu_seconds(pid) - cpu) / (time.monotonic() - start)
    publisher.publish(message(MOVING, action=Marker.DELETE))
    boxes.wait(0)
    return {"objects": MOVING, "hz": HZ, "core_percent": round(100 * share, 1),
            "p50_ms": round(statistics.median(ages), 2)}


def fill(publisher, boxes, pid):
    """The memory of very many, most of which must go back to the system with them."""
    before = megabytes(pid, "VmRSS")
    publisher.publish(message(MANY))
    boxes.wait(MANY)
    full = megabytes(pid, "VmRSS")
    publisher.publish(message(MANY, action=Marker.DELETE))
    boxes.wait(0)
    wait_for(lambda: megabytes(pid, "VmRSS") < (before + full) / 2, "memory given back")
    return {"objects": MANY, "resident_mb": round(full - before, 1),
            "kept_mb": round(megabytes(pid, "VmRSS") - before, 1)}


def measure(options):
    with Master() as master:
        rospy.init_node("many_objects", disable_signals=True)
        master.parameters.setParam("/many/node/fixed_frame", "map")
        node = master.start_node("link_bounds_publisher", "/many")
        boxes = Boxes("/many/node/boxes")
        publisher = rospy.Publisher("/many/node/objects", Prepared, queue_size=10)
        wait_for(lambda: publisher.get_num_connections() == 1 and boxes.count, "connection")
        rows = [move(publisher, boxes, node.pid, 5 if options.quick else 20),
                fill(publisher, boxes, node.pid)]
        rospy.signal_shutdown("done")
    names = ["objects", "hz", "core_percent", "p50_ms", "resident_mb", "kept_mb"]
    print_table("Objects that move, and that come and go", {name: name for name in names}, rows)
    return rows
