# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the bytes of a tf message to boxes with empty caches: the times of the program bench, and
beside each stage of our update the cache lines that it is the first to touch.

The lines are counted by Callgrind's model of a cache, which is empty when an update begins and
holds all that it touches: so a line is counted once, by its first miss."""
import json
import os
import re
import shutil
import subprocess
import tempfile

from node_process import output_of, program
from report import print_table

QUICK = "fewer repetitions, no 1,000 links"
UPDATES = 14  # of cold_updates.cpp
CALLGRIND = ["valgrind", "--quiet", "--tool=callgrind", "--cache-sim=yes", "--LL=8388608,16,64",
             "--instr-atstart=no"]
STAGES = {"readMessage": "read the message", "insertTransforms": "insert transforms",
          "updatePoses": "poses", "updateBoxes": "boxes", "updateObjects": "objects",
          "fillBoxMessage": "fill ~boxes", "fillGroupMessage": "fill ~groups"}
STAGE = re.compile(r"NodeUpdate::(\w+)\(")


def measured(quick, folder):
    """The rows of bench pipeline --cold."""
    path = os.path.join(folder, "rows.json")
    subprocess.run([*program("bench"), "pipeline", "--cold", "--json", path, *quick], check=True)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def counted(links, path):
    """{stage: (lines of code per update, lines of data per link)} of a dump of Callgrind."""
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


def add_lines(stages, links, lines):
    """Adds the lines to the rows of the stages, and prints them."""
    total = sum(row["ns_per_link"] for row in stages)
    for row in stages:
        row["code_lines"], row["data_lines"] = lines[row["stage"]]
        row["percent"] = 100 * row["ns_per_link"] / total
    names = ("percent", "code_lines", "data_lines")
    in_all = {"stage": "in all", **{name: sum(row[name] for row in stages) for name in names}}
    print_table("cache lines, %d links" % links, {
        "stage": "stage", "percent": "% of the time", "code_lines": "lines of code",
        "data_lines": "lines of data per link"}, [*stages, in_all], stage=20)


def add_options(parser):
    parser.add_argument("--cold", action="store_true", required=True, help="what is measured")


def measure(options):
    quick = ["--quick"] * options.quick
    with tempfile.TemporaryDirectory() as folder:
        rows = measured(quick, folder)
        if not shutil.which("valgrind") or "cold-updates" not in output_of("bench", "--help"):
            print("valgrind is not installed, or was not when this was built: the cache lines are "
                  "not counted")
            return rows
        path = os.path.join(folder, "lines")
        subprocess.run([*CALLGRIND, "--callgrind-out-file=" + path, *program("bench"),
                        "cold-updates", *quick], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        for i, links in enumerate((50,) if options.quick else (50, 200), 1):
            add_lines([row for row in rows if "stage" in row and row["links"] == links], links,
                      counted(links, "%s.%d" % (path, i)))
    return rows
