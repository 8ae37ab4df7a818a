#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts that build name a full disk: full_disk_test.py FOLDER_OF_THE_PACKAGE

df and du, which say how much is free and taken, and cmake are stand-ins.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path()
DF = '#!/bin/sh\nprintf "Filesystem 1M-blocks Used Available Capacity Mounted on\\n"\n' \
     'printf "tmpfs 1000 1000 $(cat {free}) 100%% /the/disk\\n"\n'
DU = '#!/bin/sh\nprintf "$(cat {taken})\\t$2\\n"\n'
FILLS = '#!/bin/sh\necho 3 >{free}\necho "error: No space left on device" >&2\nexit {status}\n'


class FullDiskTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.build = self.root / 'build'
        self.free = self.root / 'free'
        self.taken = self.root / 'taken'
        self.taken.write_text('1')
        self.write('df', DF.format(free=self.free))
        self.write('du', DU.format(taken=self.taken))

    def write(self, name, text):
        path = self.root / name
        path.write_text(text)
        path.chmod(0o755)

    def answer(self, command, free, cmake=FILLS, status=1):
        """What a function of the scripts prints on standard error where so many MB are free. This
        cmake fills the disk."""
        self.free.write_text(str(free))
        self.write('cmake', cmake.format(free=self.free, status=status))
        done = subprocess.run(
            ['bash', '-euo', 'pipefail', '-c', f'. {PACKAGE}/scripts/common.sh; {command}'],
            env=dict(os.environ, PATH=f'{self.root}:/usr/bin:/bin'), check=False,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1, done.stderr)
        return done.stderr

    def check_named(self, text, free, needed):
        self.assertRegex(
            text.splitlines()[-1],
            f'^bash: the disk of {self.build}, mounted on /the/disk, is full: {free} MB '
            f'are free, about {needed} MB are needed; make room there and start again$')

    def test_before_the_first_build(self):
        self.check_named(self.answer(f'configure {self.build}', 500), 500, 599)
        self.assertFalse((self.build / 'configure.log').exists())

    def test_while_configuring_also_if_cmake_overlooks_it(self):
        for status in (1, 0):
            text = self.answer(f'configure {self.build}', 9000, status=status)
            self.check_named(text, 3, 599)
            self.assertIn('No space left on device', text)

    def test_while_building(self):
        self.build.mkdir()
        text = self.answer(f'build {self.build} all', 9000)
        self.check_named(text, 3, 599)

    def test_a_failure_beside_free_space_is_no_full_disk(self):
        self.build.mkdir()
        for command in (f'configure {self.build}', f'build {self.build} all'):
            self.assertNotIn('disk', self.answer(command, 9000, '#!/bin/sh\nexit 1\n'))

    def test_a_complete_build_needs_no_more_than_new_results(self):
        self.build.mkdir()
        self.taken.write_text('700')
        self.check_named(self.answer(f'build {self.build} all', 9000), 3, 200)


if __name__ == '__main__':
    PACKAGE = sys.argv.pop()
    unittest.main()
