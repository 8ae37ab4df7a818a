#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module for Python: a single call of boxes and of distances [us], and rows per second of boxes and
distances beside urdf_bounds --poses, each on one thread. With LINK_BOUNDS_DATA the robots there, else
that of the demo. python.py [--quick] [--json FILE]"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile
import time

import numpy

import link_bounds
from node_process import print_target

PROGRAM = os.path.join(os.environ["LINK_BOUNDS_BUILD"], "devel/lib/link_bounds/urdf_bounds")
DEMO = pathlib.Path(__file__).resolve().parents[3] / "launch/demo/demo.urdf"
ROBOTS = {"panda": "franka_description/urdf/panda.urdf", "ur5e": "ur_description/urdf/ur5e.urdf"}
LIMIT = 0.05  # m
REPETITIONS = 5
MAX_CALL = 20  # us, a single call of boxes
MIN_SHARE = 0.8  # of the rows per second of urdf_bounds


def robots():
    data = os.environ.get("LINK_BOUNDS_DATA")
    found = {name: pathlib.Path(data, "robots", path) for name, path in ROBOTS.items()} if data else {}
    return {name: path for name, path in found.items() if path.exists()} or {"demo": DEMO}


def cpu(work):
    """Processor seconds of all threads of this process."""
    start = time.process_time()
    work()
    return time.process_time() - start


def of_program(arguments):
    """Processor seconds of a run of urdf_bounds."""
    program = subprocess.Popen([PROGRAM, *arguments, "--jobs", "1"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(program.pid, 0)
    program.returncode = os.WEXITSTATUS(status)
    assert program.returncode in (0, 3), program.returncode
    return usage.ru_utime + usage.ru_stime


def write(path, joints, rows):
    numpy.savetxt(path, rows, fmt="%.17g", delimiter=",", header=",".join(joints), comments="")


def rows_per_second(robot, urdf, count, folder):
    """Of the module and of urdf_bounds, for distances; the largest of some runs in turn."""
    rows = numpy.random.default_rng(1).uniform(-1, 1, (count, len(robot.joints)))
    tables = [os.path.join(folder, name) for name in ("one.csv", "all.csv")]
    write(tables[0], robot.joints, rows[:1])
    write(tables[1], robot.joints, rows)
    series = os.path.join(folder, "series.csv")
    ours, theirs = [], []
    for _ in range(REPETITIONS):
        ours.append(count / cpu(lambda: robot.distances(rows, LIMIT, jobs=1)))
        one, many = (of_program([str(urdf), "--poses", table, "--distances", str(LIMIT),
                                 "--series", series]) for table in tables)
        theirs.append((count - 1) / max(many - one, 1e-9))
    return max(ours), max(theirs)


def measured(name, urdf, count, folder):
    robot = link_bounds.Robot(str(urdf))
    pose = numpy.zeros(len(robot.joints))
    calls = 10 * count

    def boxes():
        for _ in range(calls):
            robot.boxes(pose)

    call = min(cpu(boxes) for _ in range(REPETITIONS)) / calls * 1e6
    rows = numpy.random.default_rng(1).uniform(-1, 1, (50 * count, len(robot.joints)))
    of_boxes = len(rows) / min(cpu(lambda: robot.boxes(rows, jobs=1)) for _ in range(REPETITIONS))
    ours, theirs = rows_per_second(robot, urdf, count, folder)
    return {"robot": name, "links": len(robot.links), "boxes_call_us": round(call, 2),
            "boxes_rows_per_second": round(of_boxes), "distances_rows_per_second": round(ours),
            "urdf_bounds_rows_per_second": round(theirs), "share": round(ours / theirs, 2)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="300 rows instead of 3,000")
    parser.add_argument("--json", metavar="FILE", help="the rows as JSON, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [measured(name, urdf, 300 if options.quick else 3000, folder)
                for name, urdf in robots().items()]
    print("\nthe module for Python, pairs within 5 cm, one thread\n")
    print("| robot | links | call of boxes [us] | boxes, rows/s | distances, rows/s "
          "| urdf_bounds, rows/s | share |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for row in rows:
        print("| %s |" % " | ".join(str(value) for value in row.values()))
    print_target("a call of boxes [us]", MAX_CALL, [max(row["boxes_call_us"] for row in rows)])
    print_target("rows per second, of those of urdf_bounds", MIN_SHARE,
                 [min(row["share"] for row in rows)], at_most=False)
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
