#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C ends all that scripts/test has started, also while it builds the packages for apt beside
the build of later steps: interrupted_test.py FOLDER_OF_THE_PACKAGE

What is built, and roslaunch, are stand-ins.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from patience import PATIENCE

PACKAGE = pathlib.Path()
LIMIT = 20 * PATIENCE  # s
ENDLESS = '#!/bin/sh\ntouch {started}\nsleep 1000\n'
ENDS_WELL = '''#!/bin/sh
trap 'exit 0' INT
touch {started}
while :; do sleep 0.1; done
'''  # at Ctrl-C


def members(session):
    """The processes of the session that still run."""
    found = []
    for path in pathlib.Path('/proc').glob('[0-9]*/stat'):
        try:
            state, _, _, of = path.read_text().rpartition(') ')[2].split()[:4]
        except OSError:
            continue  # it has ended
        if of == str(session) and state != 'Z':
            found.append(int(path.parent.name))
    return found


class InterruptedTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        scripts = self.root / 'scripts'
        scripts.mkdir()
        for name in ('common.sh', 'packages.sh', 'sanitizers.sh'):
            shutil.copy(PACKAGE / 'scripts' / name, scripts)
        text = (PACKAGE / 'scripts/test').read_text().replace('\nmain "$@"\n', '''
build_geometry() { "$REPO/compiler"; }
build_ahead geometry
check_deb
''')
        self.write('scripts/test', text)
        self.write('scripts/deb', ENDLESS.format(started=self.root / 'deb.started'))
        self.write('compiler', ENDLESS.format(started=self.root / 'compiler.started'))
        self.write('build/devel/env.sh', '#!/bin/sh\n')

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def wait_for(self, condition):
        end = time.monotonic() + LIMIT
        while not condition() and time.monotonic() < end:
            time.sleep(0.02)
        return condition()

    def expect_all_ends(self, *names):
        """Ctrl-C after all of these have started. It may be ignored where this test was started."""
        with subprocess.Popen(['env', '--default-signal=INT', self.root / 'scripts/test'],
                              start_new_session=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL,
                              env=dict(os.environ, TMPDIR=str(self.root))) as script:
            try:
                for name in names:
                    self.assertTrue(self.wait_for((self.root / f'{name}.started').exists), name)
                os.killpg(script.pid, signal.SIGINT)  # as a terminal does
                self.assertTrue(self.wait_for(lambda: not members(script.pid)),
                                'some of it still runs')
            finally:
                for process in members(script.pid):
                    os.kill(process, signal.SIGKILL)
        self.assertEqual(list(self.root.glob('tmp.*')), [])

    def test_while_packages_are_built(self):
        self.expect_all_ends('deb', 'compiler')

    def test_while_a_program_runs_that_ends_well(self):
        self.write('build/devel/env.sh', ENDS_WELL.format(started=self.root / 'env.started'))
        self.expect_all_ends('deb', 'compiler', 'env')

    def test_before_the_script_knows_what_it_has_started(self):
        text = (self.root / 'scripts/test').read_text()
        start = '  packager=$!\n'
        self.assertEqual(text.count(start), 1)
        self.write('scripts/test', text.replace(start, '  while :; do :; done\n'))
        self.expect_all_ends('deb', 'compiler')


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop())
    unittest.main()
