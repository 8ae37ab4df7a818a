# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many pairs urdf_bounds --pairs decides in which time, and what samples would have said."""
import os
import subprocess

from node_process import print_target

SAMPLED = os.path.join(os.environ["LINK_BOUNDS_BUILD"], "devel/lib/link_bounds/pairs_sampled")
BUDGETS = (0.1, 0.3, 1, 3, 10, 30, 120)  # s
SAMPLES = 10000
VERDICTS = ("NEVER", "ALWAYS", "TOUCHING", "CONTACT_SAMPLED", "SOMETIMES", "UNDECIDED")
TARGET_PERCENT, TARGET_SECONDS = 95, 120


def geometry():
    """Of the robots: those that are made here have no collision geometry."""
    return "collision" if os.environ.get("LINK_BOUNDS_DATA") else "visual"


def verdicts(result):
    """Of the pairs that are examined."""
    return {(pair["first"], pair["second"]): pair["verdict"] for pair in result["pairs"]
            if pair["verdict"] != "ADJACENT"}


def sampled(file):
    """What the samples say of each pair."""
    output = subprocess.run([SAMPLED, file, str(SAMPLES), geometry()], check=True,
                            stdout=subprocess.PIPE, universal_newlines=True).stdout
    rows = (line.split("\t") for line in output.splitlines())
    return {(first, second): verdict for verdict, first, second in rows}


def pair_row(run, robot, file, budget, fixed=()):
    """The verdicts, and the row. `run` gives the JSON of urdf_bounds and the seconds. An accuracy
    of 1 km: verdicts alone."""
    result, seconds = run(file, *fixed, "--pairs", "--geometry", geometry(), "--accuracy", "1000",
                          "--budget", str(budget), "--allow-incomplete")
    found = list(verdicts(result).values())
    counts = {verdict: found.count(verdict) for verdict in VERDICTS}
    return verdicts(result), {"proof": "pairs", "robot": robot, "budget": budget,
                              "seconds": round(seconds, 2), "pairs": len(found), **counts}


def pair_rows(run, robot, file, is_quick):
    """Until all pairs are decided, and what samples say of them."""
    rows = []
    for budget in BUDGETS:
        if is_quick and budget > 10:
            break
        proven, row = pair_row(run, robot, file, budget)
        rows.append(row)
        if not row["UNDECIDED"]:
            break
    seen = sampled(file)
    rows[-1]["wrong_never"] = [pair for pair in proven
                               if proven[pair] == "SOMETIMES" and seen[pair] == "NEVER"]
    rows[-1]["sampled_never"] = [seen[pair] for pair in proven].count("NEVER")
    return rows


def seven_joint_rows(run, robot, file, fixed):
    """Of a robot of which one arm moves."""
    return [pair_row(run, robot, file, budget, fixed)[1] for budget in (10, TARGET_SECONDS)]


def report_pairs(rows):
    print("\n--pairs\n\n| robot | budget [s] | time [s] | decided | of pairs | never | always | "
          "sometimes |\n|---|---:|---:|---:|---:|---:|---:|---:|")
    for row in rows:
        print("| %s | %g | %.2f | %d | %d | %d | %d | %d |" % (
            row["robot"], row["budget"], row["seconds"], row["pairs"] - row["UNDECIDED"],
            row["pairs"], row["NEVER"], row["ALWAYS"], row["SOMETIMES"]))
    print()
    for row in rows:
        if "wrong_never" not in row:
            continue
        print("%d random poses of %s: %d pairs never seen to collide, of which %d can collide%s" % (
            SAMPLES, row["robot"], row["sampled_never"], len(row["wrong_never"]),
            "".join("; %s and %s" % pair for pair in row["wrong_never"])))
        assert row["seconds"] <= TARGET_SECONDS + 10, row
        decided = 1 - row["UNDECIDED"] / row["pairs"]
        print_target("%% of pairs that --pairs decides in 120 s, %s" % row["robot"], TARGET_PERCENT,
                     [100 * decided], False)
