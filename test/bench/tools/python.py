# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module for Python: a single call of boxes [us], and rows of boxes and of distances per second
beside a program in C++ that computes the same rows, each on one thread. With LINK_BOUNDS_DATA the
robots there, else that of the demo."""
import os
import tempfile
import time

import numpy

import link_bounds
from node_process import output_of
from report import print_table, print_target
from robots import DEMO, public

QUICK = "300 rows instead of 3,000"
LIMIT = 0.05  # m
BOXES = 50  # rows of boxes for each row of distances
REPETITIONS = 5
MAX_CALL = 20  # us, a single call of boxes
MIN_SHARE = 0.8  # of the rows per second of C++


def cpu(work):
    """Processor seconds of all threads of this process."""
    start = time.process_time()
    work()
    return time.process_time() - start


def of_program(urdf, values, *numbers):
    """Processor seconds of the boxes and of the distances in C++."""
    return [float(seconds) for seconds in output_of("rows_posed", urdf, values, *numbers).split()]


def measured(name, urdf, count, folder):
    robot = link_bounds.Robot(urdf)
    pose = numpy.zeros(len(robot.joints))
    calls = 10 * count

    def boxes():
        for _ in range(calls):
            robot.boxes(pose)

    rows = numpy.random.default_rng(1).uniform(-1, 1, (BOXES * count, len(robot.joints)))
    values = os.path.join(folder, name)
    rows.tofile(values)
    call, ours, theirs = [], [], []
    for _ in range(REPETITIONS):  # in turn, so that each has the same share of disturbance
        call.append(cpu(boxes) / calls * 1e6)
        ours.append([cpu(lambda: robot.boxes(rows, jobs=1)),
                     cpu(lambda: robot.distances(rows[:count], LIMIT, jobs=1))])
        theirs.append(of_program(urdf, values, len(rows), count, LIMIT))
    counts = numpy.array([len(rows), count])
    ours, theirs = (counts / numpy.min(seconds, axis=0) for seconds in (ours, theirs))
    return {"robot": name, "links": len(robot.links), "boxes_call_us": round(min(call), 2),
            "boxes": [round(ours[0]), round(theirs[0])],
            "boxes_share": round(ours[0] / theirs[0], 2),
            "distances": [round(ours[1]), round(theirs[1])],
            "distances_share": round(ours[1] / theirs[1], 2)}


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        rows = [measured(name, urdf, 300 if options.quick else 3000, folder)
                for name, urdf in (public("panda", "ur5e") or {"demo": DEMO}).items()]
    columns = {"robot": "robot", "links": "links", "boxes_call_us": "a call of boxes [us]"}
    for what in ("boxes", "distances"):
        columns.update({what + "_python": what + ", Python", what + "_cpp": "C++",
                        what + "_share": "share"})
    print_table("the module for Python beside C++: rows per second, pairs within 5 cm, one thread",
                columns, [{**row, **{what + end: row[what][i] for what in ("boxes", "distances")
                                     for i, end in enumerate(("_python", "_cpp"))}}
                          for row in rows], robot=6)
    print("\nTargets")
    print_target("a call of boxes [us]", MAX_CALL, [max(row["boxes_call_us"] for row in rows)])
    for what in ("boxes", "distances"):
        print_target("rows of %s per second, of those of C++" % what, MIN_SHARE,
                     [min(row[what + "_share"] for row in rows)], at_most=False)
    return rows
