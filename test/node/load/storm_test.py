#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Everything at once, and boxes stay young: tf at 100 Hz, 500 objects, lists that change, meshes that
load, spans without a pause, reloads, clock jumps, and for each topic one subscriber that reads
slowly and one that does not read. storm_test.py [--seconds SECONDS] [--csv FILE]

scripts/soak --storm lets it last longer. With a sanitizer it is short, and times do not count."""
import argparse
import json
import os
import socket
import subprocess
import tempfile
import time

import rospy
from binary_stl import random_mesh
from bounds_testing import executable, wait_for
from load_testing import PATIENT, description
from node_testing import NODE, SANITIZED, NodeProcess, resident_bytes
from own_master import OwnMaster
from patience import PATIENCE
from raw_subscriber import RawSubscriber, SlowReader

FRESH = "/fresh_publisher"
LINKS = 30
SECONDS, SANITIZED_SECONDS = 60, 20
MESHES, VERTICES = 24, 3000
TOPICS = ["boxes", "groups", "markers", "parts", "footprint", "overlaps", "distances", "nearest",
          "distance_markers", "swept", "swept_markers", "stopping", "stopping_markers",
          "stopping_overlaps", "earliest"]
PARAMETERS = {"timeout": 0.0, "swept_span": 0.5, "parts_per_link": 4, "distance_limit": 0.05}
SLOW = 200000  # bytes per second; what a slow subscriber reads
MAX_AGE = 250 * PATIENCE  # ms
MAX_MEMORY = 200  # MB
MAX_SILENCE = 2 * PATIENCE  # s without diagnostics


def faults_of(result):
    """What went wrong, in words. How long the machine let nothing run does not count."""
    faults = []

    def check(is_right, text):
        if not is_right:
            faults.append(text)
    check(result["difference"] == "", "after the storm it differs from a fresh node: " +
          result["difference"])
    check(result["unanswered"] == 0, "tf messages without boxes")
    check(result["failed_spans"] + result["refused_reloads"] == 0, "requests failed")
    check(result["reloads"] > 0 and result["spans"] > 0 and result["jumps"] > 0, "no real storm")
    if SANITIZED:
        print("skipped: ages, diagnostics and memory in the storm, a sanitizer makes it slow")
        return faults
    check(result["max_ms"] - result["stall_ms"] < MAX_AGE, "boxes older than %d ms" % MAX_AGE)
    check(result["silence_s"] - 1e-3 * result["stall_ms"] < MAX_SILENCE,
          "no diagnostics for %g s" % MAX_SILENCE)
    check(result["resident_mb"] < MAX_MEMORY, "more than %d MB" % MAX_MEMORY)
    return faults


def start_node(name):
    return NodeProcess(name[1:], **PARAMETERS)


def blow(seconds, csv, folder):
    """What storm_driver printed at its end."""
    meshes = [os.path.join(folder, "%d.stl" % i) for i in range(MESHES)]
    for seed, path in enumerate(meshes):
        random_mesh(path, seed, VERTICES, (0.3, 0.3, 0.3))
    with start_node(NODE) as node:
        wait_for(lambda: {"%s/%s" % (NODE, topic) for topic in TOPICS} <=
                 set(dict(rospy.get_published_topics())) or not node.is_running, "all topics")
        if not node.is_running:
            raise AssertionError("the node does not start: " + node.output)
        # Those that never read, and those that read slowly.
        stopped = [RawSubscriber(NODE, "%s/%s" % (NODE, topic)) for topic in TOPICS]
        slow = SlowReader([RawSubscriber(NODE, "%s/%s" % (NODE, topic)) for topic in TOPICS], SLOW)
        print("memory before the storm: %.1f MB" % (resident_bytes(node.pid) / 1e6), flush=True)
        driver = subprocess.Popen(
            [executable("link_bounds", "storm_driver"), NODE, str(node.pid), FRESH, str(LINKS),
             str(seconds), csv, *("file://" + path for path in meshes)], stdout=subprocess.PIPE)
        try:
            driver.stdout.readline()  # the storm is over, or the driver has ended
            with start_node(FRESH):
                output = driver.communicate(timeout=2 * PATIENT)[0]
        finally:
            driver.kill()
            driver.wait()
            slow.end()
            for subscriber in stopped:
                subscriber.end()
    return json.loads(output) if driver.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=SANITIZED_SECONDS if SANITIZED else SECONDS)
    parser.add_argument("--csv", default=os.devnull, help="the age of boxes over time")
    options = parser.parse_args()
    socket.setdefaulttimeout(PATIENT)  # of calls of a node or a master
    master = OwnMaster()
    rospy.set_param("/use_sim_time", True)
    rospy.set_param("/robot_description", description(LINKS))
    start = time.monotonic()
    try:
        with tempfile.TemporaryDirectory() as folder:
            result = blow(options.seconds, options.csv, folder)
    finally:
        master.kill()
    faults = faults_of(result) if result else ["storm_driver failed, see above"]
    print("%s\n%.0f s; %s" % (result, time.monotonic() - start,
                              "FAILED: " + "; ".join(faults) if faults else "passed"))
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
