# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hosts that are network namespaces joined by a switch. All of them end with the process."""
import ctypes
import os
import signal
import subprocess

PR_SET_PDEATHSIG = 1
SUBNET = "10.77.0."
MASTER_PORT = 11311  # nobody else is in these namespaces
NEIGHBOURS = {"base_reachable": 1000, "retrans": 250, "delay_probe": 0}  # ms
DELAY, LOSS = "20ms", "5%"
# What not every kernel allows, and ip does not do under emulation.
TRIAL = ("ip link add switch type bridge && "
         "ip ntable change name arp_cache dev lo retrans %d" % NEIGHBOURS["retrans"])


def die_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def unshare_command():
    """A command that runs a program with a network of its own; None if that is not possible."""
    rights = [] if os.geteuid() == 0 else ["--map-root-user"]
    command = ["unshare", "--net", *rights]
    try:
        tried = subprocess.run([*command, "sh", "-c", TRIAL], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    except FileNotFoundError:
        return None
    return command if tried.returncode == 0 else None


def run(*command):
    subprocess.run(command, check=True)


class Host:
    """A namespace with one interface and its address. A sleeping process keeps it alive."""

    def __init__(self, number):
        self.address = SUBNET + str(number)
        self.port = "port%d" % number  # the switch's end of the cable
        self._keeper = subprocess.Popen(
            ["unshare", "--net", "sh", "-c", "echo ready; exec sleep infinity"],
            stdout=subprocess.PIPE, preexec_fn=die_with_parent)
        self._keeper.stdout.readline()
        run("ip", "link", "add", self.port, "type", "veth", "peer", "name", "eth0",
            "netns", str(self._keeper.pid))
        run("ip", "link", "set", self.port, "master", "switch", "up")
        self.run("ip", "link", "set", "lo", "up")
        self.run("ip", "address", "add", self.address + "/24", "dev", "eth0")
        self.run("ip", "link", "set", "eth0", "up")

    def _inside(self, command):
        return ["nsenter", "--net", "--target", str(self._keeper.pid), *command]

    def run(self, *command):
        run(*self._inside(command))

    def start(self, *command, **options):
        environment = dict(os.environ, ROS_IP=self.address, PYTHONUNBUFFERED="1",
                           ROS_MASTER_URI="http://%s1:%d" % (SUBNET, MASTER_PORT))
        environment.pop("ROS_HOSTNAME", None)
        return subprocess.Popen(self._inside(command), env=environment,
                                preexec_fn=die_with_parent, **options)

    def watch_neighbours(self):
        """Lets the kernel notice soon that a host is gone. TCP then does not double the pause
        before each retransmission (RFC 6069)."""
        settings = [word for name, value in NEIGHBOURS.items() for word in (name, str(value))]
        self.run("ip", "ntable", "change", "name", "arp_cache", "dev", "eth0", *settings)

    def cut(self):
        """Pulls the cable at the switch. The host's end of the cable sees that, too."""
        run("ip", "link", "set", self.port, "down")

    def restore(self):
        run("ip", "link", "set", self.port, "up")

    def make_bad(self):
        """Delay and loss on the way to this host; False if the kernel has no netem."""
        return subprocess.run(["tc", "qdisc", "add", "dev", self.port, "root", "netem", "delay",
                               DELAY, "loss", LOSS], stderr=subprocess.DEVNULL).returncode == 0

    def end(self):
        self._keeper.kill()
        self._keeper.wait()
        self._keeper.stdout.close()


def hosts(count):
    """Numbered from 1. The ROS master must run on host 1."""
    run("ip", "link", "add", "switch", "type", "bridge")
    run("ip", "link", "set", "switch", "up")
    return [Host(number) for number in range(1, count + 1)]
