# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a tf message sent to the boxes received, over TCP on this machine: ours, a relay that
computes nothing, and a usual node of tf2 that sends the same message, or markers; with 200 links
also ours with spheres for meshes, and ours with one bounded link, which show the parts of the cost,
and ours while somebody listens to ~distances, too.

Ours and the relay run one right after the other, for a short time each, and the verdict is the
median of their ratios: so neither the load nor the speed of the machine at one time decides."""
import statistics
import subprocess
import tempfile
import time

from binary_stl import random_mesh
from node_process import Master, cpu_seconds, rows_of, wait_for
from report import print_table, print_target

QUICK = "fewer repetitions"
DEPTH = 10
SHARED_MESHES = 16
REPETITIONS = 11
QUICK_REPETITIONS = 3
MESSAGES = 500  # of one run, but at least
SHORTEST = 0.5  # seconds, and at most
LONGEST = 1.5
IDLE = 3
RATES = [100, 1000]  # Hz
# Program, what it sends, and its arguments.
METHODS = {"relay": ("relay", "boxes"),
           "ours": ("link_bounds_publisher", "boxes"),
           "usual_tf2": ("usual_tf2", "boxes", "boxes"),
           "usual_markers": ("usual_tf2", "markers", "markers"),
           "ours_spheres": ("link_bounds_publisher", "boxes"),
           "ours_one_link": ("link_bounds_publisher", "boxes"),
           "ours_distances": ("link_bounds_publisher", "boxes")}
LINKS_OF_ALL = 200  # with others only the first four methods
# Reads ~distances without time that the others need.
LISTENER = ["nice", "-n", "19", "rostopic", "hz", "/ours_distances/node/distances"]
# At 100 Hz: of the processor time of an update above the relay's [us], and of the medians' ratio.
MAX_ABOVE_RELAY = {50: 15, 200: 40, 1000: 130}
MAX_RATIO = {50: 1.15, 200: 1.2, 1000: 1.2}
FIGURES = ["p50_us", "p90_us", "p99_us", "cpu_us_per_update"]
CPU = FIGURES[-1]


def link_name(i):
    return "branch_%d_joint_%d_link" % (100 + i // DEPTH, 10 + i % DEPTH)


def description(links, shape):
    """The robot of tf_robot.cpp; its poses come from tf alone. `shape` makes the geometry of a
    link from its number."""
    names = [link_name(i) for i in range(links)]
    base = "the_base_of_the_robot"
    return '<robot name="bench"><link name="%s"/>%s%s</robot>' % (
        base,
        "".join('<link name="%s"><visual><geometry>%s</geometry></visual></link>' % (
            name, shape(i)) for i, name in enumerate(names)),
        "".join('<joint name="to_%s" type="floating"><parent link="%s"/><child link="%s"/></joint>'
                % (name, base if i % DEPTH == 0 else names[i - 1], name)
                for i, name in enumerate(names)))


def set_parameters(parameters, links, folder):
    def mesh(i):
        return '<mesh filename="file://%s/%d.stl"/>' % (folder, i % SHARED_MESHES)

    def sphere(_):
        return '<sphere radius="0.1"/>'
    parameters.setParam("/ours/robot_description", description(links, mesh))
    parameters.setParam("/ours_distances/robot_description", description(links, mesh))
    parameters.setParam("/ours_spheres/robot_description", description(links, sphere))
    parameters.setParam("/ours_one_link/robot_description", description(links, mesh))
    parameters.setParam("/ours_one_link/node/links", [link_name(0)])


def start_listener(master):
    """Subscribes to ~distances of one node."""
    master.start(*LISTENER, stdout=subprocess.DEVNULL)
    wait_for(lambda: LISTENER[-1] in dict(master.parameters.getSystemState()[1]), "listener")


def time_of(method, process, links, hz):
    """The figures of one run."""
    seconds = min(LONGEST, max(SHORTEST, MESSAGES / hz))
    return rows_of("stopwatch", "/" + method, process.pid, METHODS[method][1], links, DEPTH, hz,
                   seconds)[0]


def print_idle(nodes, links):
    """What nodes cost that receive nothing: timers, and looking for an end."""
    start = {method: cpu_seconds(node.pid) for method, node in nodes.items()}
    time.sleep(IDLE)
    print("idle, %d links, us of processor time per second: " % links + ", ".join(
        "%s %.0f" % (method, 1e6 * (cpu_seconds(node.pid) - start[method]) / IDLE)
        for method, node in nodes.items()), flush=True)


def run(links, repetitions, folder):
    """{(method, hz): [figures of each repetition]}"""
    methods = list(METHODS) if links == LINKS_OF_ALL else list(METHODS)[:4]
    # Two pairs of ours and the relay, each of them first in one.
    order = [*methods, "ours", "relay"]
    runs = {(method, hz): [] for hz in RATES for method in methods}
    with Master() as master:
        set_parameters(master.parameters, links, folder)
        nodes = {method: master.start_node(METHODS[method][0], "/" + method, *METHODS[method][2:])
                 for method in methods}
        for method in methods:  # from here on ours has its robot
            time_of(method, nodes[method], links, RATES[0])
        print_idle(nodes, links)
        if "ours_distances" in methods:
            start_listener(master)
        for repetition in range(repetitions):
            for hz in RATES:
                for method in order:
                    runs[method, hz].append(time_of(method, nodes[method], links, hz))
            print("%d links: %d of %d" % (links, repetition + 1, repetitions), flush=True)
    return runs


def row_of(method, links, hz, runs):
    row = {"method": method, "links": links, "hz": hz}
    row.update((figure, round(statistics.median(run[figure] for run in runs), 1))
               for figure in FIGURES)
    row.update(cpu_min=min(run[CPU] for run in runs), cpu_max=max(run[CPU] for run in runs),
               repetitions=len(runs), bytes=runs[-1]["bytes"])
    row.update((count, sum(run[count] for run in runs)) for count in ["sent", "received"])
    return row


def print_targets(runs, links, hz):
    def ratios(figure, method):
        ours = runs["ours", hz]
        step = len(ours) // len(runs[method, hz])
        return [own[figure] / other[figure] for own, other in zip(ours[::step], runs[method, hz])]
    where = ", %d links at %d Hz" % (links, hz)
    if links == LINKS_OF_ALL:
        # Of the two runs of ours in a repetition, the one right after that with distances.
        pairs = zip(runs["ours_distances", hz], runs["ours", hz][1::2])
        print_target("p50, ours with ~distances / without" + where, 1.1,
                     [listened["p50_us"] / alone["p50_us"] for listened, alone in pairs])
    def median(method, figure):
        return statistics.median(run[figure] for run in runs[method, hz])
    if hz == 100:
        print_target("us above the relay" + where, MAX_ABOVE_RELAY[links],
                     [own[CPU] - other[CPU]
                      for own, other in zip(runs["ours", hz], runs["relay", hz])])
    if hz == 100 or links == LINKS_OF_ALL:
        print_target("p50, ours / relay, medians" + where, MAX_RATIO[links],
                     [median("ours", "p50_us") / median("relay", "p50_us")])
    if (links, hz) == (200, 1000):
        print_target("p50, ours / relay" + where, 1.25, ratios("p50_us", "relay"))
        for usual in ["usual_tf2", "usual_markers"]:
            print_target("p50, ours / %s" % usual + where, 0.6, ratios("p50_us", usual))
    print_target("answered / sent" + where, 1, [run["received"] / run["sent"]
                                                for run in runs["ours", hz]], at_most=False)


def add_options(parser):
    parser.add_argument("--links", type=int, nargs="+", default=[LINKS_OF_ALL],
                        choices=sorted(MAX_RATIO), help="numbers of links (default: %(default)s)")


def measure(options):
    repetitions = QUICK_REPETITIONS if options.quick else REPETITIONS
    rows, results = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for i in range(SHARED_MESHES):
            random_mesh("%s/%d.stl" % (folder, i), i)
        for links in options.links:
            results[links] = run(links, repetitions, folder)
            rows += [row_of(method, links, hz, runs)
                     for (method, hz), runs in results[links].items()]
    columns = ["links", "hz", *FIGURES, "cpu_min", "cpu_max", "bytes", "sent", "received"]
    print_table("Medians of %d repetitions" % repetitions,
                {"method": "method", **{name: name for name in columns}}, rows, method=14)
    print("\nTargets")
    for links in options.links:
        for hz in RATES:
            print_targets(results[links], links, hz)
    return rows
