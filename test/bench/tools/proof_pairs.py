# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many pairs urdf_bounds --pairs decides in which time and memory, and what samples would have
said."""
from node_process import output_of
from report import print_table, print_target
from robots import DATA

BUDGETS = (0.1, 0.3, 1, 3, 10, 30, 120)  # s
SAMPLES = 10000
VERDICTS = ("NEVER", "ALWAYS", "TOUCHING", "CONTACT_SAMPLED", "SOMETIMES", "UNDECIDED")
TARGET_PERCENT, TARGET_SECONDS = 99, 120
TARGET_SECONDS_OF_ARM = 1  # all pairs of an arm
TARGET_SECONDS_OF_GAP, TARGET_MEGABYTES = 10, 300
GAP = 6e-5  # m


def geometry():
    """Of the robots: those that are made here have no collision geometry."""
    return "collision" if DATA else "visual"


def verdicts(result):
    """Of the pairs that are examined."""
    return {(pair["first"], pair["second"]): pair["verdict"] for pair in result["pairs"]
            if pair["verdict"] != "ADJACENT"}


def sampled(file):
    """What the samples say of each pair."""
    output = output_of("pairs_sampled", file, SAMPLES, geometry())
    rows = (line.split("\t") for line in output.splitlines())
    return {(first, second): verdict for verdict, first, second in rows}


def pair_row(run, robot, file, budget, fixed=()):
    """The verdicts, and the row. `run` gives the JSON of urdf_bounds and the seconds. An accuracy
    of 1 km: verdicts alone."""
    result, seconds = run(file, *fixed, "--pairs", "--geometry", geometry(), "--accuracy", "1000",
                          "--budget", str(budget))
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


def large_robot_rows(run, robot, file, is_quick, fixed=()):
    """Of a robot with so many joints that not all pairs are decided."""
    budgets = (10,) if is_quick else (10, TARGET_SECONDS)
    return [pair_row(run, robot, file, budget, fixed)[1] for budget in budgets]


def link(name, size, xyz="0 0 0"):
    return ('<link name="%s"><visual><origin xyz="%s"/><geometry><box size="%s"/></geometry>'
            '</visual></link>' % (name, xyz, size))


def joint(name, parent, child, xyz, axis, lower, upper):
    return ('<joint name="%s" type="revolute"><parent link="%s"/><child link="%s"/>'
            '<origin xyz="%s"/><axis xyz="%s"/>'
            '<limit lower="%g" upper="%g" effort="1" velocity="1"/></joint>'
            % (name, parent, child, xyz, axis, lower, upper))


def narrow_gap():
    """A leg of three joints: its shank swings past the trunk at 0.06 mm, and spreads from there."""
    return '<robot name="gap">%s</robot>' % "".join((
        link("trunk", "0.4 0.2 0.1"), link("hip", "0.02 0.02 0.02", "0 0.1 0"),
        link("thigh", "0.03 0.03 0.03", "0 0.1 -0.1"), link("shank", "0.03 0.04 0.2", "0 0 -0.1"),
        joint("spread", "trunk", "hip", "0.15 %r 0" % (0.12 + GAP), "1 0 0", 0, 0.8),
        joint("swing", "hip", "thigh", "0 0 0", "0 1 0", -1, 1),
        joint("knee", "thigh", "shank", "0 0 -0.2", "0 1 0", -1, 1)))


def many_links(count):
    """A tree of boxes with that many links, each branch of ten joints."""
    text = link("l0", "0.1 0.1 0.1")
    for i in range(1, count):
        parent = 0 if i % 10 == 1 else i - 1
        place = "%g %g 0" % (i // 10 % 10, i // 100) if parent == 0 else "0.02 0.03 0.2"
        text += link("l%d" % i, "0.1 0.08 0.2", "0 0 0.1")
        axis = "0 1 0" if i % 2 else "0 0 1"
        text += joint("j%d" % i, "l%d" % parent, "l%d" % i, place, axis, -2, 2)
    return '<robot name="many">%s</robot>' % text


def made_rows(run, write):
    """Robots that are made for one question each: a narrow gap, and memory."""
    result, seconds = run(write("gap.urdf", narrow_gap()), "--pairs", "--accuracy", "1000",
                          "--budget", str(2 * TARGET_SECONDS_OF_GAP))
    verdict = verdicts(result)["trunk", "shank"]
    rows = [{"proof": "gap", "verdict": verdict, "seconds": round(seconds, 2)}]
    result, seconds = run(write("many.urdf", many_links(1000)), "--pairs", "--budget", "2")
    return rows + [{"proof": "memory", "pairs": len(verdicts(result)), "seconds": round(seconds, 2),
                    "megabytes": run.megabytes}]


def report_made(gap, memory):
    print("\na shank that swings past a trunk at 0.06 mm: %s" % gap["verdict"])
    print_target("seconds of --pairs to NEVER, a gap of 0.06 mm", TARGET_SECONDS_OF_GAP,
                 [gap["seconds"] if gap["verdict"] == "NEVER" else float("inf")])
    print_target("megabytes of --pairs, 1,000 links, %d pairs" % memory["pairs"], TARGET_MEGABYTES,
                 [memory["megabytes"]])


def report_pairs(rows):
    print_table("--pairs", {
        "robot": "robot", "budget": "budget [s]", "seconds": "time [s]", "decided": "decided",
        "pairs": "of pairs", "NEVER": "never", "ALWAYS": "always", "TOUCHING": "touching",
        "CONTACT_SAMPLED": "sampled", "SOMETIMES": "sometimes"},
                [{**row, "decided": row["pairs"] - row["UNDECIDED"]} for row in rows], robot=16)
    print()
    for row in rows:
        assert row["seconds"] <= row["budget"] + 10, row
        if "wrong_never" not in row:
            continue
        print("%d random poses of %s: %d pairs never seen to collide, of which %d can collide%s" % (
            SAMPLES, row["robot"], row["sampled_never"], len(row["wrong_never"]),
            "".join("; %s and %s" % pair for pair in row["wrong_never"])))
    for robot in dict.fromkeys(row["robot"] for row in rows):
        last = [row for row in rows if row["robot"] == robot][-1]
        decided = 100 * (1 - last["UNDECIDED"] / last["pairs"])
        if "wrong_never" in last:
            seconds = last["seconds"] if decided == 100 else float("inf")
            print_target("seconds of --pairs until all are decided, %s" % robot,
                         TARGET_SECONDS_OF_ARM, [seconds])
        else:
            print_target("%% of pairs that --pairs decides in %g s, %s" % (last["budget"], robot),
                         TARGET_PERCENT, [decided], False)
