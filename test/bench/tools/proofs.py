# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long the proofs of urdf_bounds take: accuracy of --reach and decided pairs of --pairs against
time, from the start of the program to its end, meshes included. With LINK_BOUNDS_DATA on the robots
there, else on arms that are made here."""
import json
import os
import subprocess
import tempfile
import time
import xml.etree.ElementTree

from node_process import program
from proof_pairs import (joint, large_robot_rows, link, made_rows, pair_rows, report_made,
                         report_pairs)
from report import print_table, print_target
from robots import DATA, public

QUICK = "no accuracies below 1 mm, 10 s for pairs"
ACCURACIES = (0.1, 0.03, 0.01, 0.003, 0.001, 0.0003)  # m
TARGET_ACCURACY, TARGET_SECONDS = 0.01, 60


def made_arm(joints, limit):
    """A robot of boxes whose joints turn about z and y in turn, each by at most the limit."""
    return '<robot name="made">%s</robot>' % "".join(
        [link("l%d" % i, "0.1 0.08 0.2", "0 0 0.1") for i in range(joints + 1)] +
        [joint("j%d" % i, "l%d" % i, "l%d" % (i + 1), "0.02 0.03 0.2",
               "0 1 0" if i % 2 else "0 0 1", -limit, limit) for i in range(joints)])


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def robots(folder):
    """The URDF files of the robots, by name."""
    found = public("ur5e", "panda")
    if found:
        return {"UR5e": found["ur5e"], "Panda": found["panda"]}
    files = {}
    for name, joints, limit in (("made, 6 joints", 6, 6.28), ("made, 7 joints", 7, 2.8)):
        files[name] = write(folder, "%d.urdf" % joints, made_arm(joints, limit))
    return files


def all_but(prefix, file):
    """Arguments that keep each joint at rest whose name does not begin so."""
    arguments = []
    for element in xml.etree.ElementTree.parse(file).getroot().findall("joint"):
        name, limit, mimic = element.get("name"), element.find("limit"), element.find("mimic")
        kind = element.get("type")
        if name.startswith(prefix) or mimic is not None or kind in ("fixed", "floating", "planar"):
            continue
        value = 0.0
        if kind != "continuous":
            value = min(max(value, float(limit.get("lower", 0))), float(limit.get("upper", 0)))
        arguments.append("%s:=%.17g" % (name, value))
    return arguments


class Run:
    """Calls urdf_bounds: the JSON that it prints, and the seconds that it takes."""

    megabytes = 0.0  # most memory of the last call

    def __call__(self, *arguments):
        start = time.monotonic()
        with tempfile.TemporaryFile() as out:
            process = subprocess.Popen([*program("urdf_bounds"), *arguments, "--format", "json",
                                        "--allow-incomplete"], stdout=out)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
            assert status == 0, arguments
            self.megabytes = usage.ru_maxrss / 1000
            out.seek(0)
            return json.load(out), time.monotonic() - start


run = Run()


def reach_row(robot, file, accuracy):
    result, seconds = run(file, "--reach", "--accuracy", str(accuracy))
    gap = max(gap for box in result["reach"].values() for gap in box["gap"])
    return {"proof": "reach", "robot": robot, "accuracy": accuracy, "gap": gap,
            "seconds": round(seconds, 2)}


def report_reach(rows):
    print_table("--reach", {"robot": "robot", "accuracy": "accuracy [m]",
                            "gap": "largest gap [m]", "seconds": "time [s]"},
                [{**row, "accuracy": "%g" % row["accuracy"], "gap": "%.2g" % row["gap"]}
                 for row in rows], robot=16)
    print("\nTargets")
    for row in rows:
        if row["accuracy"] == TARGET_ACCURACY:
            assert row["gap"] <= TARGET_ACCURACY, row
            print_target("seconds of --reach to 1 cm, %s" % row["robot"], TARGET_SECONDS,
                         [row["seconds"]])


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        files = robots(folder)
        rows = [reach_row(name, file, accuracy) for name, file in files.items()
                for accuracy in ACCURACIES if accuracy >= 0.001 or not options.quick]
        report_reach(rows)
        pairs = [row for name, file in files.items()
                 for row in pair_rows(run, name, file, options.quick)]
        if DATA:
            file = public("pr2")["pr2"]
            pairs += large_robot_rows(run, "PR2", file, options.quick)
            pairs += large_robot_rows(run, "PR2, right arm", file, options.quick,
                                      all_but("r_", file))
        report_pairs(pairs)
        made = made_rows(run, lambda name, text: write(folder, name, text))
        report_made(*made)
    return rows + pairs + made
