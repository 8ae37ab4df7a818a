# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_bounds on a bag of 50 moving links at 100 Hz, beside programs that only read the bag and
deserialise its messages; the memory of each, of a short and of a long bag; 50 bags with --each."""
import os
import statistics
import subprocess
import tempfile
import time

import rosbag
from binary_stl import random_mesh
from end_to_end import description
from node_process import is_built, output_of, program
from report import Table, print_table, print_target

QUICK = "a tenth of the length, 3 repetitions"
LINKS = 50
FEW_LINKS = 10  # of the long bag, which then takes 700 MB on the disk
TIMES_LONGER = 12
BAGS = 50
MANY = 1000  # bags, of which the time is computed
# zones.yaml: one that the links are in now and then, and one that follows a link
ZONES = """
ahead: {min: [0.5, -1, 0], max: [3, 1, 3]}
around: {frame: branch_100_joint_10_link, min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5]}
"""
READERS = {"rosbag": "bag_rosbag", "ours": "bag_ours", "bag_bounds": "bag_bounds",
           "bag_bounds --out": "bag_bounds", "extremes alone": "bag_bounds"}
SPEED = ("rosbag", "ours", "bag_bounds", "extremes alone")
MEMORY = ("rosbag", "ours", "bag_bounds", "bag_bounds --out")


class Bag:
    """A bag with the URDF of its robot, whose links share a mesh."""

    def __init__(self, folder, name, links, minutes):
        self.seconds = round(60 * minutes)
        self.jobs = os.cpu_count()
        self.path = os.path.join(folder, name + ".bag")
        self.urdf = os.path.join(folder, name + ".urdf")
        self.zones = os.path.join(folder, "zones.yaml")
        mesh = os.path.join(folder, "mesh.stl")
        random_mesh(mesh, 1)
        with open(self.zones, "w", encoding="utf-8") as file:
            file.write(ZONES)
        with open(self.urdf, "w", encoding="utf-8") as file:
            file.write(description(links, lambda _: '<mesh filename="file://%s"/>' % mesh))
        output_of("bag_made", self.path, links, self.seconds)

    def command(self, reader):
        options = []
        if READERS[reader] == "bag_bounds":
            options = ["--urdf", self.urdf, "--jobs", str(self.jobs)]
            if reader != "extremes alone":
                options += ["--zones", self.zones]
        if reader.endswith("--out"):
            options += ["--out", self.path + ".boxes"]
        return [*program(READERS[reader]), self.path, *options]

    def read(self, reader):
        """Runs the program. Returns the seconds it took and its peak of memory [MB]."""
        seconds, peak, status = output_of("bench_peak", *self.command(reader)).split()
        if int(status) not in (0, 3):  # 3: a zone was entered
            raise RuntimeError("%s ended with %d" % (reader, int(status)))
        return float(seconds), int(peak) / 1e6

    def counts(self, reader):
        return subprocess.run(self.command(reader), check=True, stdout=subprocess.PIPE).stdout


def measure_speed(bag, readers, repetitions):
    """A row for each reader. They take turns, so that each has the same share of disturbance."""
    if len({bag.counts(reader) for reader in readers if READERS[reader] != "bag_bounds"}) > 1:
        raise RuntimeError("the readers disagree on what is in the bag")
    runs = {reader: [] for reader in readers}
    for _ in range(repetitions):
        for reader in readers:
            runs[reader].append(bag.read(reader))
    table = Table("%d s of %d links" % (bag.seconds, LINKS), {
        "reader": "reader", "median_s": "seconds", "real_time": "times real time",
        "peak_mb": "peak MB", "of_rosbag": "of rosbag's time"}, reader=16)
    rows = []
    for reader in readers:
        seconds = [run[0] for run in runs[reader]]
        ratios = [mine / rosbag[0] for mine, rosbag in zip(seconds, runs.get("rosbag", []))]
        rows.append({"kind": "speed", "reader": reader, "links": LINKS, "bag_s": bag.seconds,
                     "median_s": statistics.median(seconds), "repetitions": repetitions,
                     "times_real_time": [bag.seconds / s for s in seconds], "ratios": ratios,
                     "peak_mb": max(run[1] for run in runs[reader])})
        table.add({**rows[-1], "real_time": statistics.median(rows[-1]["times_real_time"]),
                   "of_rosbag": statistics.median(ratios) if ratios else None})
    return rows


def measure_jobs(bag, repetitions):
    """A row for the bag compressed with bz2, with one thread and with one per core."""
    plain, bag.path = bag.path, bag.path + ".bz2.bag"
    with rosbag.Bag(plain) as source, rosbag.Bag(bag.path, "w", compression="bz2") as target:
        for topic, message, stamp in source.read_messages(raw=True):
            target.write(topic, message, stamp, raw=True)
    runs = {1: [], os.cpu_count(): []}
    for _ in range(repetitions):
        for jobs in runs:
            bag.jobs = jobs
            runs[jobs].append(bag.read("bag_bounds")[0])
    os.remove(bag.path)
    bag.path, bag.jobs = plain, os.cpu_count()
    alone, together = (statistics.median(seconds) for seconds in runs.values())
    print_table("bz2", {"threads": "threads", "seconds": "seconds"}, [
        {"threads": 1, "seconds": alone}, {"threads": os.cpu_count(), "seconds": together}])
    return {"kind": "jobs", "reader": "bag_bounds", "jobs": os.cpu_count(),
            "seconds": list(runs.values()),
            "shares": [a / b / os.cpu_count() for a, b in zip(*runs.values())]}


def measure_memory(short, long, readers):
    """A row for each reader: its peak for a bag, and for one that is longer."""
    table = Table("MB at the peak, %d links" % FEW_LINKS, {
        "reader": "reader", "short": "%d s" % short.seconds, "long": "%d s" % long.seconds},
                  reader=16)
    rows = []
    for reader in readers:
        peaks = [bag.read(reader)[1] for bag in (short, long)]
        rows.append({"kind": "memory", "reader": reader, "links": FEW_LINKS,
                     "bags_s": [short.seconds, long.seconds], "peaks_mb": peaks})
        table.add({"reader": reader, "short": peaks[0], "long": peaks[1]})
    return rows


def timed(command):
    """Seconds of a run of bag_bounds, and what it printed."""
    begin = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if done.returncode not in (0, 3):
        raise RuntimeError("%s ended with %d" % (command[0], done.returncode))
    return time.monotonic() - begin, done.stdout


def measure_each(folder, seconds, repetitions):
    """Rows for 50 bags: with one job and with two, which take turns, and a start per bag."""
    bags = [Bag(folder, "each_%02d" % number, LINKS, seconds / 60) for number in range(BAGS)]
    paths = [bag.path for bag in bags]

    def command(jobs, paths):
        bags[0].jobs = jobs
        program_of_one, _, *options = bags[0].command("bag_bounds")
        return [program_of_one, "--each", *options, *paths]
    runs, lines = {1: [], 2: []}, set()
    for _ in range(repetitions):
        for jobs, times in runs.items():
            took, out = timed(command(jobs, paths))
            times.append(took)
            lines.add(b"".join(sorted(out.splitlines(True))))
    if len(lines) > 1:
        raise RuntimeError("lines depend on the number of jobs")
    starts = sum(timed(command(1, [path]))[0] for path in paths)
    row = {"kind": "each", "bags": BAGS, "bag_s": seconds, "links": LINKS,
           "jobs_1_s": runs[1], "jobs_2_s": runs[2], "starts_s": starts,
           "line_bytes": len(lines.pop()) / BAGS,
           "ratios": [one / two for one, two in zip(runs[1], runs[2])]}
    one, two = statistics.median(runs[1]), statistics.median(runs[2])
    print_table("seconds for bags of %d s of %d links; %d are computed" % (seconds, LINKS, MANY), {
        "bags": "bags", "one": "one job", "two": "two jobs", "starts": "a start per bag",
        "bytes": "bytes of lines"}, [
            {"bags": bags, "one": one * bags / BAGS, "two": two * bags / BAGS,
             "starts": starts * bags / BAGS, "bytes": row["line_bytes"] * bags}
            for bags in (BAGS, MANY)])
    return [row]


def print_targets(rows):
    for row in rows:
        if row["kind"] == "each":
            print_target("%d bags, one job / two jobs" % BAGS, 1.8, row["ratios"], False)
            continue
        if READERS[row["reader"]] != "bag_bounds":
            continue
        if row["kind"] == "memory":
            print_target("%s, memory, %d times longer / short bag" % (row["reader"], TIMES_LONGER),
                         1.1, [row["peaks_mb"][1] / row["peaks_mb"][0]])
        elif row["kind"] == "jobs":
            print_target("bz2, speed of %d threads / %d times that of one" % ((row["jobs"],) * 2),
                         0.8, row["shares"], False)
        elif row["reader"] == "extremes alone":
            print_target("extremes alone, times real time", 1000, row["times_real_time"], False)
        else:
            print_target("bag_bounds, times real time", 500, row["times_real_time"], False)
            if row["ratios"]:
                print_target("bag_bounds / rosbag that only reads and deserialises", 4,
                             row["ratios"])


def add_options(parser):
    parser.add_argument("--minutes", type=float, help="length of the bag, default 10; the long one "
                        "is %d times as long" % TIMES_LONGER)


def measure(options):
    minutes = options.minutes or (1 if options.quick else 10)
    readers = [reader for reader in READERS if reader != "rosbag" or is_built("bag_rosbag")]
    if "rosbag" not in readers:
        print("left out, because this system lacks it: librosbag-storage")
    with tempfile.TemporaryDirectory(prefix="link_bounds_") as folder:
        bag = Bag(folder, "bag", LINKS, minutes)
        rows = measure_speed(bag, [reader for reader in readers if reader in SPEED],
                             3 if options.quick else 7)
        if os.cpu_count() > 1:
            rows.append(measure_jobs(Bag(folder, "bag", LINKS, min(minutes, 1)), 3))
        os.remove(os.path.join(folder, "bag.bag"))
        rows += measure_memory(Bag(folder, "short", FEW_LINKS, minutes),
                               Bag(folder, "long", FEW_LINKS, TIMES_LONGER * minutes),
                               [reader for reader in readers if reader in MEMORY])
        rows += measure_each(folder, 5 if options.quick else 20, 3)
    print("\nTargets")
    print_targets(rows)
    return rows
