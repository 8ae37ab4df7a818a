#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts install packages where apt has no lists yet, or has a broken source that they do not
need: install_packages_test.py FOLDER_OF_THE_PACKAGE

What changes or asks the system is a stand-in: a file per list and per installed package.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path()
BROKEN = "E: The repository 'http://broken.example stable Release' does not have a Release file."
STAND_INS = {
    'dpkg-query': '[ -e {root}/installed/$4 ] && echo installed',
    'sudo': 'shift; exec "$@"',
    'apt-cache': 'case $1 in show) cat {root}/lists/$2;; madison) cat {root}/lists/$2 || true;; esac',
    'apt-get': '''
case $1 in
  update)
    echo apt >{root}/lists/apt
    for name in $AVAILABLE; do echo $name >{root}/lists/$name; done
    [ -z "$BROKEN" ] || { echo "$BROKEN"; exit 100; } ;;
  install)
    for name; do :; done
    [ -e {root}/lists/$name ] || { seq 30; echo "E: Unable to locate package $name"; exit 100; }
    touch {root}/installed/$name ;;
esac''',
}


class InstallPackagesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ('bin', 'lists', 'installed'):
            (self.root / name).mkdir()
        for name, text in STAND_INS.items():
            path = self.root / 'bin' / name
            path.write_text('#!/bin/bash\n' + text.replace('{root}', str(self.root)) + '\n')
            path.chmod(0o755)

    def run_function(self, command, available, broken=''):
        """Exit code and output of a function of scripts/packages.sh on a system without lists."""
        command = f'. {PACKAGE}/scripts/common.sh; BUILD={self.root}/build; {command}'
        done = subprocess.run(
            ['bash', '-euo', 'pipefail', '-c', command], check=False, encoding='utf-8',
            env=dict(os.environ, PATH=f'{self.root}/bin:/usr/bin:/bin', AVAILABLE=available,
                     BROKEN=broken),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout

    def is_installed(self, name):
        return (self.root / 'installed' / name).exists()

    def test_what_exists_where_apt_has_no_lists(self):
        code, text = self.run_function('install_what_exists nodelet', 'libnodeletlib-dev')
        self.assertEqual(code, 0, text)
        self.assertTrue(self.is_installed('libnodeletlib-dev'), text)
        self.assertNotIn('left out', text)

    def test_what_does_not_exist_is_named(self):
        for _ in range(2):  # the second time there are lists
            code, text = self.run_function('install_what_exists nodelet', '')
            self.assertEqual((code, text.strip()), (
                0, '==> There is no package libnodeletlib-dev here; it is left out'))

    def test_lists_that_apt_cannot_get_are_named(self):
        (self.root / 'bin/apt-get').write_text('#!/bin/sh\nexit 100\n')
        code, text = self.run_function('install_what_exists nodelet', '')
        self.assertEqual(code, 0)
        self.assertEqual(text.count('apt-get update failed; the log is'), 1, text)

    def test_a_broken_source_that_is_not_needed(self):
        code, text = self.run_function('install_packages count', 'valgrind', BROKEN)
        self.assertEqual(code, 0, text)
        self.assertTrue(self.is_installed('valgrind'))

    def test_a_broken_source_that_is_needed_is_named(self):
        code, text = self.run_function('install_packages count', '', BROKEN)
        self.assertEqual(code, 1)
        self.assertEqual(text.count(BROKEN), 1, text)
        self.assertEqual(text.count('Unable to locate package valgrind'), 1, text)
        self.assertIn('installing failed; the complete log is', text)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop())
    unittest.main()
