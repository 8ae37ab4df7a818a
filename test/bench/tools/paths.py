# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How fast urdf_bounds goes through tables of joint values, on one core, beyond what loading takes:
rows per second, with all pairs within 5 cm, and with --path the time for an edge of 0.3 rad among
20 objects. With LINK_BOUNDS_DATA a humanoid of 29 joints with collision meshes, made of the robots
there, and the Panda; else the robot of the demo."""
import json
import math
import os
import pathlib
import random
import re
import subprocess
import tempfile

import humanoid
from node_process import program
from report import print_table, print_target
from robots import DATA, DEMO

QUICK = "2,000 rows instead of 20,000"
LIMIT = "0.05"  # m
STEPS = (0.02, 0.2)  # of each joint from row to row [rad]: a motion at 50 Hz, and a scattered one
TARGET = 2000  # rows per second
EDGE = 0.3  # length of an edge in the space of the joints [rad]
OBJECTS = 20
EDGE_TARGET = 5  # ms, the median
DECIDED_TARGET = 0.99  # of the edges without a collision


def robot():
    """Its name, URDF, and the options for its geometry."""
    if DATA:
        return "humanoid, 29 joints", humanoid.humanoid(), "collision"
    print("LINK_BOUNDS_DATA is not set: the robot of the demo stands in for a humanoid")
    return "demo", pathlib.Path(DEMO).read_text(), "visual"


def seconds(arguments):
    """Of the processor, for a run on one thread; what it prints, and says."""
    with tempfile.TemporaryFile() as said:
        run = subprocess.Popen([*program("urdf_bounds"), *arguments, "--jobs", "1"],
                               stdout=subprocess.PIPE, stderr=said)
        out = run.stdout.read()
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.WEXITSTATUS(status)
        said.seek(0)
        text = said.read().decode()
    result = json.loads(out) if run.returncode in (0, 3, 4) else {"incomplete": text}
    if result["incomplete"]:
        raise SystemExit("nothing is measured of a robot without its meshes: %s; %s"
                         % (result["incomplete"], "is ROS_PACKAGE_PATH right?"))
    return usage.ru_utime + usage.ru_stime, result, text


def measured(name, urdf, geometry, folder, count):
    for step in STEPS:
        for is_series in (False, True):
            times = []
            for rows in (1, count):
                table = os.path.join(folder, "table.csv")
                pathlib.Path(table).write_text(humanoid.rows(urdf.read_text(), rows, step))
                series = ["--series", os.path.join(folder, "series.csv")] if is_series else []
                took, result, _ = seconds([str(urdf), "--geometry", geometry, "--poses", table,
                                           "--distances", LIMIT, "--format", "json", *series])
                times.append(took)
            pairs = None
            if is_series:
                lines = pathlib.Path(folder, "series.csv").read_text().count("\n") - 1
                pairs = round(lines / count, 1)
            yield {"robot": name, "step": step, "series": is_series, "pairs_per_row": pairs,
                   "with_contact": result["rows"]["with_contact"] / count,
                   "rows_per_second": round((count - 1) / max(times[1] - times[0], 1e-9))}


def way_points(urdf, count):
    """A csv table: a random walk within the limits, around the middle of the ranges."""
    joints, chance = list(humanoid.joints_of(urdf)), random.Random(2)
    middles = [(lower + upper) / 2 for _, lower, upper in joints]
    ranges = [(max(lower, middle - 0.6), min(upper, middle + 0.6))
              for (_, lower, upper), middle in zip(joints, middles)]
    lines, values = [",".join(name for name, _, _ in joints)], middles
    for _ in range(count):
        lines.append(",".join("%.6f" % value for value in values))
        moved = [math.inf]
        while not all(low <= value <= high for value, (low, high) in zip(moved, ranges)):
            step = [chance.gauss(0, 1) for _ in values]
            length = math.sqrt(sum(x * x for x in step))
            moved = [value + EDGE * x / length for value, x in zip(values, step)]
        values = moved
    return "\n".join(lines) + "\n"


def objects():
    """Boxes of 6 to 20 cm around the robot, as YAML."""
    chance, text = random.Random(3), ""
    for i in range(OBJECTS):
        angle, radius = chance.uniform(0, 2 * math.pi), chance.uniform(0.5, 0.9)
        sizes = tuple(chance.uniform(0.06, 0.2) for _ in range(3))
        text += ("o%d: {type: CUBE, pose: {position: {x: %g, y: %g, z: %g}}, "
                 "scale: {x: %g, y: %g, z: %g}}\n"
                 % ((i, radius * math.cos(angle), radius * math.sin(angle), chance.uniform(0, 1))
                    + sizes))
    return text


def edge_row(folder, urdf, geometry, count):
    table, scene = os.path.join(folder, "path.csv"), os.path.join(folder, "objects.yaml")
    pathlib.Path(scene).write_text(objects())
    pathlib.Path(table).write_text(way_points(urdf.read_text(), count + 1))
    _, result, text = seconds([str(urdf), "--geometry", geometry, "--poses", table, "--path",
                               "--objects", scene, "--format", "json", "--verbose"])
    times = re.search(r"a segment took (\S+) ms in the middle of \d+, (\S+) ms at most", text)
    verdicts = [segment["verdict"] for segment in result["segments"]]
    counts = {verdict: verdicts.count(verdict) for verdict in ("SAFE", "COLLIDES", "UNDECIDED")}
    return {"robot": urdf.stem, "edges": count, "median": float(times.group(1)),
            "longest": float(times.group(2)), **counts,
            "decided": counts["SAFE"] / max(1, counts["SAFE"] + counts["UNDECIDED"])}


def report(rows, edges):
    print_table("table of joint values, pairs within 5 cm, one core", {
        "robot": "robot", "step": "step [rad]", "series": "series is written",
        "pairs_per_row": "pairs a row", "with_contact": "share with contact",
        "rows_per_second": "rows/s"}, rows, robot=20)
    slowest = min(row["rows_per_second"] for row in rows if row["step"] == STEPS[0])
    print_table("--path, edges of %g rad among %d objects, one core" % (EDGE, OBJECTS), {
        "robot": "robot", "edges": "edges", "SAFE": "SAFE", "COLLIDES": "COLLIDES",
        "UNDECIDED": "UNDECIDED", "median": "median [ms]", "longest": "longest [ms]"}, [edges],
                robot=20)
    print("\nTargets")
    print_target("rows per second of a slow motion", TARGET, [slowest], at_most=False)
    print_target("milliseconds for an edge, median", EDGE_TARGET, [edges["median"]])
    print_target("share of edges without a collision that is decided", DECIDED_TARGET,
                 [edges["decided"]], at_most=False)


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        name, text, geometry = robot()
        # Beside the meshes that it names, for those of the demo.
        urdf = pathlib.Path(folder, "robot.urdf")
        urdf.write_text(text)
        rows = list(measured(name, urdf, geometry, folder, 2000 if options.quick else 20000))
        arm = pathlib.Path(folder, "panda.urdf") if DATA else urdf
        if DATA:
            arm.write_text(humanoid.arm())
        edges = edge_row(folder, arm, geometry, 100 if options.quick else 1000)
    report(rows, edges)
    return rows + [edges]
