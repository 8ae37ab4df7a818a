# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a program is run by an emulator of its processor, such as qemu-user."""
import signal


def catches(pid, number):
    """Whether a process has a handler for a signal."""
    with open('/proc/%d/status' % pid, encoding='ascii') as file:
        mask = next(line for line in file if line.startswith('SigCgt:')).split()[1]
    return bool(int(mask, 16) >> (number - 1) & 1)


def is_emulated(pid):
    """An emulator catches all signals before the program does. Ours do not catch this one."""
    return catches(pid, signal.SIGUSR1)
