#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C ends bag_bounds at once, whatever it reads, with a report of what is known by then.

Run as: bag_interrupts_test.py PATH_OF_bag_bounds
"""
import bz2
import contextlib
import functools
import json
import os
import pty
import re
import signal
import struct
import subprocess
import threading
import time

import bag_bounds_testing
from bag_bounds_testing import (BEGIN, COUNT, PARTLY_READ, BagBoundsTest, arms, main, moving_arms,
                                raw, time_of)
from bounds_testing import wait_for
from emulation import is_emulated
from object_testing import marker
from patience import PATIENCE
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

PROMPT = 10.0 * PATIENCE  # s; it takes a tenth of that at most
BEGINS = 60.0 * PATIENCE  # s; chunks of 300 MB take a few seconds before the bar shows them
YEARS = 1e9  # s
MEBIBYTE = 1 << 20
UNPACKED = 20000 * MEBIBYTE  # of a bomb; minutes to decompress


def field(name, value):
    return struct.pack('<I', len(name) + 1 + len(value)) + name + b'=' + value


def record(data, **fields):
    header = b''.join(field(name.encode(), value) for name, value in fields.items())
    return struct.pack('<I', len(header)) + header + struct.pack('<I', len(data)) + data


@functools.lru_cache(None)
def bomb(chunk_size):
    """Small chunks that unpack to much, of a topic that nobody reads."""
    kind, data, md5, _ = raw(String('0' * chunk_size))
    number = struct.pack('<I', 99)
    connection = record(field(b'topic', b'/bomb') + field(b'type', kind.encode()) +
                        field(b'md5sum', md5.encode()) + field(b'message_definition', b''),
                        op=b'\x07', conn=number, topic=b'/bomb')
    message = record(data, op=b'\x02', conn=number, time=struct.pack('<II', int(BEGIN), 0))
    chunk = record(bz2.compress(connection + message), op=b'\x05', compression=b'bz2',
                   size=struct.pack('<I', len(connection) + len(message)))
    return chunk * (UNPACKED // chunk_size)


class Terminal:
    """Keeps what programs show on a terminal."""

    def __init__(self, master):
        self.shown = b''
        self._master = master
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        with contextlib.suppress(OSError):  # EIO: the last program has ended
            while True:
                self.shown += os.read(self._master, 1 << 16)

    def all(self):
        """To be called when the last program has ended."""
        self._thread.join()
        return self.shown


class BagInterruptsTest(BagBoundsTest):
    def bag_beside(self, data, is_first=False):
        """A bag of the arms, not closed by its recorder, after or before that data; and after how
        many percent the second of them begins."""
        with open(self.bag(arms(COUNT)), 'rb') as file:
            bag = bytearray(file.read())
        place = bag.index(b'index_pos=') + len(b'index_pos=')
        index = struct.unpack_from('<Q', bag, place)[0]
        bag[place:place + 8] = bytes(8)
        chunks = bag.index(b'op=\x05') - 8  # where the first record of a chunk may begin
        chunks = bag.rindex(b' ', 0, chunks) + 1  # behind the blanks of the bag's header
        first, second = (data, bag[chunks:index]) if is_first else (bag[chunks:index], data)
        path = self.path('bomb.bag')
        with open(path, 'wb') as file:
            file.write(bag[:chunks] + first + second)
        return path, 100 * (chunks + len(first)) // os.path.getsize(path)

    def interrupted(self, bag, *arguments, after=0, signal_number=signal.SIGINT):
        """The report of a run that is interrupted when its bar shows more percent."""
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        process = subprocess.Popen(
            [bag_bounds_testing.BAG_BOUNDS, bag, '--urdf', self.urdf, '--format', 'json',
             '--allow-incomplete', *arguments], stdout=subprocess.PIPE, stderr=slave)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        os.close(slave)
        if is_emulated(process.pid):
            self.skipTest('skipped: an emulator catches all signals before the program does')
        terminal = Terminal(master)

        def shows_work():
            self.assertIsNone(process.poll(), terminal.shown)
            return any(int(percent) > after
                       for percent in re.findall(rb'(\d+)/100 %', terminal.shown))

        wait_for(shows_work, 'the bar shows that it works', BEGINS)
        begin = time.monotonic()
        process.send_signal(signal_number)
        out = process.communicate(timeout=60 * PATIENCE)[0]
        self.assertLess(time.monotonic() - begin, PROMPT)
        shown = terminal.all()
        self.assertRegex(shown.decode(), r'interrupted [\d.]+ s after the begin, \d+ % of the bags')
        self.assertEqual(process.returncode, PARTLY_READ, shown)
        found = json.loads(out)
        self.assertIn('interrupted before the end', found['losses'])
        return found

    def test_chunks_that_unpack_to_much(self):
        expected = self.report(self.bag(arms(COUNT)))
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            bag, begin = self.bag_beside(bomb(50 * MEBIBYTE))
            found = self.interrupted(bag, after=begin, signal_number=signal_number)
            for key in ('messages', 'extremes', 'to'):
                self.assertEqual(found[key], expected[key], key)

    def test_chunks_that_are_too_large(self):
        bag, begin = self.bag_beside(bomb(300 * MEBIBYTE))
        found = self.interrupted(bag, after=begin)
        self.assertEqual(found['messages'], COUNT + 1)

    def test_nothing_is_known_yet(self):
        bag, _ = self.bag_beside(bomb(50 * MEBIBYTE), is_first=True)
        self.assertEqual(self.interrupted(bag)['messages'], 0)

    def test_record_times_that_alternate(self):
        cubes = MarkerArray([marker('part/%d' % i, scale=(.1, .1, .1)) for i in range(5000)])
        messages = arms(5) + [('/objects', cubes, time_of(BEGIN + 1))]
        for index in range(1000):
            messages.append(moving_arms(index, BEGIN + 2 + YEARS * (index % 2)))
        found = self.interrupted(self.bag(messages), '--objects', '/objects')
        self.assertGreater(found['messages'], 6)
        self.assertLess(found['messages'], 1000)


if __name__ == '__main__':
    main()
