# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long a request for the boxes of 50 links takes beside an empty service of roscpp, over TCP on
this machine, while all links move at 100 Hz.

The kinds of calls take turns, and the verdict is the median of their ratios: so neither the load
nor the speed of the machine at one time decides."""
import statistics
import tempfile

from binary_stl import random_mesh
from end_to_end import DEPTH, SHARED_MESHES, description
from node_process import Master, rows_of
from report import print_table, print_target

QUICK = "fewer repetitions"
LINKS, HZ = 50, 100
EMPTY, EMPTY_FRESH = "empty", "empty, fresh connection"


def runs_of(repetitions, calls):
    """One dict per repetition: the median time of each kind of call [us]."""
    with tempfile.TemporaryDirectory() as folder, Master() as master:
        for i in range(SHARED_MESHES):
            random_mesh("%s/%d.stl" % (folder, i), i)
        master.parameters.setParam("/ours/robot_description", description(
            LINKS, lambda i: '<mesh filename="file://%s/%d.stl"/>' % (folder, i % SHARED_MESHES)))
        master.start_node("link_bounds_publisher", "/ours")
        master.start_node("empty_service", "/empty")
        return rows_of("service_client", LINKS, DEPTH, HZ, repetitions, calls)


def measure(options):
    runs = runs_of(*((5, 200) if options.quick else (11, 1000)))
    rows = [{"call": kind, "p50_us": round(statistics.median(run[kind] for run in runs), 1)}
            for kind in runs[0]]
    print_table("%d links" % LINKS, {"call": "call", "p50_us": "p50_us"}, rows, call=28)
    print("\nTargets")
    for kind in runs[0]:
        empty = EMPTY_FRESH if "fresh" in kind else EMPTY
        if kind != empty and "span" not in kind:
            print_target("p50, ~get_boxes / an empty service, %s" % kind, 2.0,
                         [run[kind] / run[empty] for run in runs])
    return rows
