#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the bytes of a tf message to boxes with empty caches: the times of pipeline_bench --cold,
and beside each stage of our update the cache lines that it is the first to touch.
pipeline_cold.py --cold [--quick] [--json FILE]

The lines are counted by Callgrind's model of a cache, which is empty when an update begins and
holds all that it touches: so a line is counted once, by its first miss."""
import argparse
import json
import os
import re
import shutil
import subprocess
import tempfile

PROGRAMS = os.path.join(os.environ["LINK_BOUNDS_BUILD"], "devel", "lib", "link_bounds")
COUNTED = os.path.join(PROGRAMS, "cold_update")
UPDATES = 14  # twice as many as a block of a history has samples
CALLGRIND = ["valgrind", "--quiet", "--tool=callgrind", "--cache-sim=yes", "--LL=8388608,16,64",
             "--instr-atstart=no"]
STAGES = {"readMessage": "read the message", "insertTransforms": "insert transforms",
          "updatePoses": "poses", "updateBoxes": "boxes", "updateObjects": "objects",
          "fillBoxMessage": "fill ~boxes", "fillGroupMessage": "fill ~groups"}
STAGE = re.compile(r"NodeUpdate::(\w+)\(")


def measured(options, folder):
    """The rows of pipeline_bench."""
    path = os.path.join(folder, "rows.json")
    subprocess.run([os.path.join(PROGRAMS, "pipeline_bench"), "--cold", "--json", path] +
                   ["--quick"] * options.quick, check=True)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def counted(links, folder):
    """{stage: (lines of code per update, lines of data per link)}"""
    path = os.path.join(folder, "lines")
    subprocess.run([*CALLGRIND, "--callgrind-out-file=" + path,
                    COUNTED, str(links), str(UPDATES)], check=True,
                   stderr=subprocess.DEVNULL)
    text = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100",
                           "--show=ILmr,DLmr,DLmw", path], check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout
    result = {}
    for line in text.splitlines():
        found = STAGE.search(line)
        if found and found.group(1) in STAGES:
            numbers = re.sub(r"\([^)]*%\)", "", line).replace(",", "").split()[:3]
            code, read, written = (0 if number == "." else int(number) for number in numbers)
            result[STAGES[found.group(1)]] = (code / UPDATES, (read + written) / UPDATES / links)
    if len(result) != len(STAGES):
        raise RuntimeError("callgrind_annotate does not show all stages:\n" + text)
    return result


def add_lines(stages, links, folder):
    """Adds the lines to the rows of the stages, and prints them."""
    lines = counted(links, folder)
    total = sum(row["ns_per_link"] for row in stages)
    print("\n%d links %19s %18s %22s" % (links, "share of time", "lines of code",
                                         "lines of data per link"))
    for row in stages:
        row["code_lines"], row["data_lines"] = lines[row["stage"]]
        row["percent"] = 100 * row["ns_per_link"] / total
        print("%-20s %6.0f %% %18.0f %22.1f" % (row["stage"], row["percent"], row["code_lines"],
                                               row["data_lines"]))
    print("%-20s %6.0f %% %18.0f %22.1f" % ("in all", 100, sum(row["code_lines"] for row in stages),
                                           sum(row["data_lines"] for row in stages)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cold", action="store_true", required=True, help="what is measured")
    parser.add_argument("--quick", action="store_true", help="fewer repetitions, no 1,000 links")
    parser.add_argument("--json", metavar="FILE", help="the rows as JSON, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = measured(options, folder)
        for links in (50,) if options.quick else (50, 200):
            if os.path.exists(COUNTED) and shutil.which("valgrind"):
                add_lines([row for row in rows if "stage" in row and row["links"] == links], links,
                          folder)
            else:
                print("valgrind is not installed: the cache lines of %d links are not counted"
                      % links)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)


if __name__ == "__main__":
    main()
