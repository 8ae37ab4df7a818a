# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How old ~boxes are when they come: with 200 links at 100 Hz and 300 objects while nobody else
listens, and while every optional topic has a listener; and then at twice the rate that this machine
can serve.

With --stopping only what is ahead is heard: ~stopping, its markers and overlaps, and ~earliest, of
links on slides. Otherwise a third row is a node that computes nothing and sends as many boxes, and
as many bytes on as many topics as often: what roscpp, the listeners and the machine cost alone.

The age of a tf message is the time from sending it until boxes come that are as new. The rows take
turns, and the verdict is the median of their ratios: so neither the load nor the speed of the
machine at one time decides."""
import json
import os
import statistics

import rospy
from bounds_testing import box_link
from link_bounds.msg import AxisAlignedBoxArray
from load_testing import LINK_SIZE, description, link_names, touching_cubes
from node_process import Master, output_of, wait_for
from raw_subscriber import Reader
from report import print_table, print_target
from visualization_msgs.msg import MarkerArray

QUICK = "fewer and shorter repetitions"
LINKS, OBJECTS, HZ = 200, 300, 100
NODE, TALKER = "/ours/node", "/talker/node"
OPTIONAL = ["markers", "parts", "footprint", "overlaps", "distances", "nearest",
            "distance_markers", "swept", "swept_markers", "stopping", "stopping_markers",
            "stopping_overlaps", "earliest"]
PARAMETERS = {"timeout": 0.0, "swept_span": 1.0, "parts_per_link": 4}
SERVED_MS = 20  # median of the age in the first second, while the node keeps up
SERVED = 0.95  # part of the messages that have boxes of their own then
HIGHEST = 12800  # Hz; load_driver sends no faster
BISECTIONS = 3
TRIALS = 3
LIMIT_RATIO, LIMIT_MS = 1.5, 100
AHEAD = ["stopping", "stopping_markers", "stopping_overlaps", "earliest"]
LIMIT_RATIO_AHEAD = 1.1
FIGURES = ["p50_ms", "p99_ms", "max_ms"]


def slides():
    """The links that load_driver moves with --slides."""
    joint = ('<joint name="to_%s" type="prismatic"><parent link="base"/><child link="%s"/>'
             '<origin xyz="%g 0 0"/><axis xyz="0 1 0"/>'
             '<limit lower="-0.05" upper="0.05" effort="1" velocity="0.5"/></joint>')
    names = link_names(LINKS)
    return '<robot name="slides">%s</robot>' % "".join(
        [box_link(name, LINK_SIZE) for name in ["base"] + names] +
        [joint % (name, name, 0.1 * i) for i, name in enumerate(names)])


def start(master, robot, parameters):
    """The node with its scene."""
    master.parameters.setParam("/ours/robot_description", robot)
    for name, value in parameters.items():
        master.parameters.setParam("%s/%s" % (NODE, name), value)
    master.start_node("link_bounds_publisher", "/ours")
    rospy.init_node("overload", disable_signals=True)
    objects = rospy.Publisher(NODE + "/objects", MarkerArray, queue_size=10)
    wait_for(lambda: objects.get_num_connections() > 0, "node")
    objects.publish(MarkerArray(touching_cubes(OBJECTS)))


def drive(hz, seconds, *options, node=NODE):
    """What load_driver measures."""
    return json.loads(output_of("bench_load", *options, LINKS, hz, seconds, node,
                                "/tf:=%s/tf" % os.path.dirname(node)))


def boxes_now():
    return len(rospy.wait_for_message(NODE + "/boxes", AxisAlignedBoxArray).boxes)


def with_listeners(function, topics=tuple(OPTIONAL), node=NODE):
    """What it returns while each of these topics has a listener."""
    listeners = [Reader(node, "%s/%s" % (node, topic)) for topic in topics]
    for topic, listener in zip(topics, listeners):
        wait_for(lambda listener=listener: listener.count, "message on ~" + topic)
    result = function()
    for listener in listeners:
        listener.end()
    return result


def traffic(seconds):
    """For each optional topic its name, the bytes of a message, and messages per second."""
    listeners = [Reader(NODE, "%s/%s" % (NODE, topic)) for topic in OPTIONAL]
    wait_for(lambda: all(listener.count for listener in listeners), "message on each topic")
    before = [(listener.count, listener.bytes) for listener in listeners]
    drive(HZ, seconds)
    words = []
    for topic, listener, (count, sent) in zip(OPTIONAL, listeners, before):
        messages = max(1, listener.count - count)
        words += [topic, str((listener.bytes - sent) // messages), str(messages / seconds)]
        listener.end()
    return words


def is_served(hz):
    """Whether the machine can serve that rate. Other programs may disturb one trial."""
    return any(is_served_now(hz) for _ in range(TRIALS))


def is_served_now(hz):
    """Whether nearly each message has boxes of its own, soon."""
    result = drive(hz, 1)
    print("%6.0f Hz: %d sent, %d updates, p50 %.1f ms" % (
        result["hz"], result["sent"], result["updates"], result["p50_ms"]), flush=True)
    return (result["updates"] > SERVED * result["sent"] and result["p50_ms"] < SERVED_MS and
            result["hz"] > SERVED * hz)


def rate_not_served():
    """The lowest rate that the machine cannot serve, up to an eighth [Hz]."""
    high = HZ
    while high < HIGHEST and is_served(high):
        high *= 2
    low = high / 2
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if is_served(middle) else (low, middle)
    return high


def measure_all(repetitions, seconds):
    """{row: [figures of each repetition]}"""
    runs = {"nobody": [], "every topic": [], "bytes alone": [], "every topic, overload": []}
    with Master() as master:
        start(master, description(LINKS), PARAMETERS)
        drive(HZ, 1)
        wait_for(lambda: boxes_now() == 1 + LINKS + OBJECTS, "boxes of the scene")
        master.start_node("relay", "/talker", str(1 + LINKS + OBJECTS), *traffic(seconds))
        for repetition in range(repetitions):
            runs["nobody"].append(drive(HZ, seconds))
            runs["every topic"].append(with_listeners(lambda: drive(HZ, seconds)))
            runs["bytes alone"].append(
                with_listeners(lambda: drive(HZ, seconds, node=TALKER), node=TALKER))
            print("%d of %d" % (repetition + 1, repetitions), flush=True)
        rate = 2 * with_listeners(rate_not_served)
        for _ in range(3):
            runs["every topic, overload"].append(
                with_listeners(lambda: drive(rate, seconds)))
        rospy.signal_shutdown("done")
    return runs


def measure_ahead(repetitions, seconds):
    """{row: [figures of each repetition]} of what is ahead."""
    runs = {"nobody": [], "stopping topics": []}
    parameters = {"timeout": 0.0, "deceleration": {"to_" + name: 2.0 for name in link_names(LINKS)}}
    with Master() as master:
        start(master, slides(), parameters)
        drive(HZ, 1, "--slides")
        wait_for(lambda: boxes_now() == 1 + LINKS + OBJECTS, "boxes of the scene")
        for repetition in range(repetitions):
            runs["nobody"].append(drive(HZ, seconds, "--slides"))
            runs["stopping topics"].append(
                with_listeners(lambda: drive(HZ, seconds, "--slides"), AHEAD))
            print("%d of %d" % (repetition + 1, repetitions), flush=True)
        check_ahead()
        rospy.signal_shutdown("done")
    return runs


def check_ahead():
    """What was heard has all boxes."""
    message = rospy.wait_for_message(NODE + "/stopping", AxisAlignedBoxArray)
    assert len(message.boxes) == 1 + LINKS + OBJECTS and not message.incomplete, message.incomplete


def ratios(runs, row):
    """Of the p99 to that of the same repetition while nobody listens."""
    return [heard["p99_ms"] / alone["p99_ms"] for heard, alone in zip(runs[row], runs["nobody"])]


def row_of(listeners, runs):
    row = {"listeners": listeners, "links": LINKS, "objects": OBJECTS,
           "hz": round(statistics.median(run["hz"] for run in runs))}
    row.update((figure, round(statistics.median(run[figure] for run in runs), 2))
               for figure in FIGURES)
    row.update((count, sum(run[count] for run in runs)) for count in ["sent", "updates"])
    return row


def add_options(parser):
    parser.add_argument("--stopping", action="store_true", help="only the topics of what is ahead")


def measure(options):
    size = (3, 2) if options.quick else (11, 5)
    runs = measure_ahead(*size) if options.stopping else measure_all(*size)
    rows = [row_of(*entry) for entry in runs.items()]
    print_table("The age of ~boxes", {name: name for name in rows[0]}, rows, listeners=21)
    print("\nTargets")
    if options.stopping:
        print_target("p99 of the age, stopping topics heard / nobody", LIMIT_RATIO_AHEAD,
                     ratios(runs, "stopping topics"))
    else:
        print_target("p99 of the age, every optional topic heard / nobody", LIMIT_RATIO,
                     ratios(runs, "every topic"))
        print_target("ms, oldest boxes at twice the rate that can be served", LIMIT_MS,
                     [run["max_ms"] for run in runs["every topic, overload"]])
    return rows
