#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Skipped tests are not counted as passed: test_summary_test.py FOLDER GTEST

GTEST is an executable with one case that needs LINK_BOUNDS_DATA.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 4  # the exit code of gtest_main.cpp
PACKAGE, GTEST = '', ''

CTEST = """1/4 Test #1: shape ............   Passed    0.10 sec
2/4 Test #2: meshes ...........***Skipped   0.10 sec
3/4 Test #3: truth ............***Skipped   0.10 sec
4/4 Test #4: tf ...............***Failed    0.10 sec

75% tests passed, 1 tests failed out of 4

Total Test time (real) =   0.40 sec

The following tests did not run:
\t  2 - meshes (Skipped)
\t  3 - truth (Skipped)

The following tests FAILED:
\t  4 - tf (Failed)
"""
CASES = """<testsuites><testsuite>
  <testcase name="a" status="run" result="completed"/>
  <testcase name="b" status="run" result="skipped"/>
  <testcase name="c" status="run" result="skipped"><skipped message="x"/></testcase>
  <testcase name="d" status="run" result="completed"><failure message="y"/></testcase>
</testsuite></testsuites>
"""


def summary(ctest, cases):
    """What test_summary.py prints of a run."""
    with tempfile.TemporaryDirectory() as build:
        pathlib.Path(build, 'ctest.log').write_text(ctest)
        results = pathlib.Path(build, 'test_results', 'link_bounds')
        results.mkdir(parents=True)
        (results / 'gtest-shape.xml').write_text(cases)
        return subprocess.run([sys.executable, PACKAGE + '/scripts/test_summary.py', build],
                              check=True, capture_output=True, text=True).stdout


class TestSummaryTest(unittest.TestCase):
    def test_skipped_and_failed_are_counted_apart(self):
        self.assertIn('tests:    1 passed, 2 skipped, 1 failed; cases: 1 passed, 2 skipped, '
                      '1 failed\n', summary(CTEST, CASES))

    def test_what_did_not_happen_is_not_named(self):
        self.assertIn('tests:    2 passed; cases: 0 passed\n',
                      summary('100% tests passed, 0 tests failed out of 2\n', '<testsuites/>'))

    def test_a_gtest_without_its_data_is_skipped(self):
        environment = {name: value for name, value in os.environ.items()
                       if name != 'LINK_BOUNDS_DATA'}
        done = subprocess.run([GTEST], env=environment, capture_output=True, text=True, check=False,
                              cwd=PACKAGE + '/test')
        self.assertEqual(done.returncode, SKIPPED, done.stdout)
        self.assertIn('\nskipped: meshes of robots', done.stdout)


if __name__ == '__main__':
    GTEST, PACKAGE = sys.argv.pop(), sys.argv.pop()
    unittest.main()
