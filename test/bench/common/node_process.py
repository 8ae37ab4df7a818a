# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""For benchmarks: a ROS master and nodes of one's own, and other programs; to be run in the build's
environment."""
import json
import os
import subprocess
import time

import rosgraph
from free_port import free_port

PROGRAMS = os.path.join(os.environ["LINK_BOUNDS_BUILD"], "devel", "lib", "link_bounds")
PROCESSES = ("relay", "stopwatch", "usual_tf2", "service_client", "empty_service", "bag_made",
             "pairs_sampled", "rows_posed")  # of the program bench_process
DEADLINE = 30  # seconds


def is_built(name):
    return os.path.exists(os.path.join(PROGRAMS, name))


def program(name):
    """The command of a program of the build, or of one of the names of bench_process."""
    words = ["bench_process", name] if name in PROCESSES else [name]
    return [os.path.join(PROGRAMS, words[0]), *words[1:]]


def output_of(name, *words):
    """What a program prints."""
    return subprocess.run([*program(name), *map(str, words)], check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout


def rows_of(name, *words):
    """The rows that a program prints, below what ROS may say."""
    text = output_of(name, *words)
    return json.loads(text[text.index("[\n{"):])


def wait_for(condition, what):
    end = time.monotonic() + DEADLINE
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError("no %s within %d s" % (what, DEADLINE))
        time.sleep(0.01)


class Master:
    """A master on a port that nobody else uses; all processes started by it end with it."""

    def __enter__(self):
        port = free_port()
        os.environ["ROS_MASTER_URI"] = "http://localhost:%d" % port
        self._processes = []
        self.start("rosmaster", "--core", "-p", str(port), stdout=subprocess.DEVNULL)
        wait_for(rosgraph.is_master_online, "master")
        self.parameters = rosgraph.Master("/bench")
        return self

    def __exit__(self, *_):
        for process in reversed(self._processes):
            self.end(process)

    def start(self, *command, **options):
        process = subprocess.Popen(command, **options)
        self._processes.append(process)
        return process

    def start_node(self, name, name_space, *arguments):
        """The node NAMESPACE/node, which listens to NAMESPACE/tf."""
        with open(os.path.join(os.environ["ROS_HOME"], "bench.log"), "ab") as log:
            return self.start(
                *program(name), "__ns:=" + name_space, "__name:=node",
                "/tf:=%s/tf" % name_space, "/tf_static:=%s/tf_static" % name_space, *arguments,
                stdout=log, stderr=log)

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.terminate()
            process.wait()


def megabytes(pid, entry):
    """An entry of /proc/PID/status, such as VmRSS."""
    with open("/proc/%d/status" % pid, encoding="ascii") as file:
        line = next(line for line in file if line.startswith(entry + ":"))
    return int(line.split()[1]) * 1024 / 1e6


def cpu_seconds(pid):
    """Of all threads of the process so far."""
    return time.clock_gettime(~pid << 3 | 2)  # CLOCK_PROCESS_CPUTIME_ID of another process
