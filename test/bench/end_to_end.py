#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a tf message sent to the boxes received, over TCP on this machine: ours, a relay that
computes nothing, and a usual node of tf2. end_to_end.py [--quick] [--json FILE]"""
import argparse
import json
import os
import random
import statistics
import subprocess
import tempfile

from node_process import PROGRAMS, Master, print_target, random_mesh

DEPTH = 10
SHARED_MESHES = 16
SECONDS = 2
METHODS = {"relay": ("end_to_end_relay", "boxes"),
           "ours": ("link_bounds_publisher", "boxes"),
           "usual_tf2": ("end_to_end_usual_tf2", "markers")}
FIGURES = ["p50_us", "p90_us", "p99_us", "cpu_us_per_update"]


def description(links, folder):
    """The robot of tf_robot.cpp; its poses come from tf alone."""
    names = ["branch_%d_joint_%d_link" % (100 + i // DEPTH, 10 + i % DEPTH) for i in range(links)]
    base = "the_base_of_the_robot"
    return '<robot name="bench"><link name="%s"/>%s%s</robot>' % (
        base,
        "".join('<link name="%s"><visual><geometry><mesh filename="file://%s/%d.stl"/></geometry>'
                '</visual></link>' % (name, folder, i % SHARED_MESHES)
                for i, name in enumerate(names)),
        "".join('<joint name="to_%s" type="floating"><parent link="%s"/><child link="%s"/></joint>'
                % (name, base if i % DEPTH == 0 else names[i - 1], name)
                for i, name in enumerate(names)))


def measure(method, process, links, hz):
    """The figures of one run."""
    stopwatch = os.path.join(PROGRAMS, "end_to_end_stopwatch")
    output = subprocess.run(
        [stopwatch, "/" + method, str(process.pid), METHODS[method][1], str(links), str(DEPTH),
         str(hz), str(SECONDS)], check=True, stdout=subprocess.PIPE).stdout
    return json.loads(output)


def run(links, rates, repetitions, folder):
    """{(method, hz): [figures of each repetition]}"""
    runs = {(method, hz): [] for hz in rates for method in METHODS}
    dice = random.Random(links)
    with Master() as master:
        master.parameters.setParam("/ours/robot_description", description(links, folder))
        nodes = {method: master.start_node(program, "/" + method)
                 for method, (program, _) in METHODS.items()}
        for repetition in range(repetitions):
            for hz in rates:
                for method in dice.sample(list(METHODS), len(METHODS)):
                    runs[method, hz].append(measure(method, nodes[method], links, hz))
            print("%d links: %d of %d" % (links, repetition + 1, repetitions), flush=True)
    return runs


def row_of(method, links, hz, runs):
    row = {"method": method, "links": links, "hz": hz}
    row.update((figure, round(statistics.median(run[figure] for run in runs), 1))
               for figure in FIGURES)
    row.update((count, sum(run[count] for run in runs)) for count in ["sent", "received"])
    return row


def print_table(rows):
    head = ["method", "links", "hz", *FIGURES, "sent", "received"]
    print("\n" + "".join("%18s" % title for title in head))
    for row in rows:
        print("".join("%18s" % row[title] for title in head))


def print_targets(runs, links, hz):
    def ratios(figure, method):
        return [ours[figure] / other[figure]
                for ours, other in zip(runs["ours", hz], runs[method, hz])]
    where = ", %d links at %d Hz" % (links, hz)
    if (links, hz) == (200, 1000):
        print_target("p50, ours / relay" + where, 1.25, ratios("p50_us", "relay"))
        print_target("p50, ours / usual_tf2" + where, 0.6, ratios("p50_us", "usual_tf2"))
    print_target("answered / sent" + where, 1, [run["received"] / run["sent"]
                                                for run in runs["ours", hz]], at_most=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="200 links at 1 kHz, 3 repetitions")
    parser.add_argument("--json", metavar="FILE", help="the rows as JSON, too")
    options = parser.parse_args()
    link_counts, rates, repetitions = ([200], [1000], 3) if options.quick else (
        [50, 200, 1000], [100, 1000], 11)
    rows, results = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for i in range(SHARED_MESHES):
            random_mesh("%s/%d.stl" % (folder, i), i)
        for links in link_counts:
            results[links] = run(links, rates, repetitions, folder)
            rows += [row_of(method, links, hz, runs)
                     for (method, hz), runs in results[links].items()]
    print_table(rows)
    print()
    for links in link_counts:
        for hz in rates:
            print_targets(results[links], links, hz)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)


if __name__ == "__main__":
    main()
