# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A port for a server that starts later. Run as a program, it prints one."""
import random
import socket

# Linux gives ports from 32768 on to whoever asks for any, also between the choice and the start.
PORTS = range(20000, 32000)


def free_port():
    """On which nobody listens."""
    while True:
        port = random.choice(PORTS)
        with socket.socket() as probe:
            try:
                probe.bind(("localhost", port))
            except OSError:
                continue
            return port


if __name__ == "__main__":
    print(free_port())
