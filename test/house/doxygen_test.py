#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Doxygen makes pages of all public headers without a warning: doxygen_test.py FOLDER"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path()
MAX_LINES = 15
SKIPPED = 4  # the status that ctest knows
WRONG = '/// \\param radius that this function does not have\nvoid grow(double size);\n'


class DoxygenTest(unittest.TestCase):
    def setUp(self):
        self.output = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.output)
        self.doxyfile = (PACKAGE / 'doc' / 'Doxyfile').read_text('utf-8')

    def run_doxygen(self, *settings):
        """Status and what it says; `settings` come after those of the file."""
        text = '\n'.join([self.doxyfile, 'OUTPUT_DIRECTORY = %s' % self.output, *settings])
        done = subprocess.run(['doxygen', '-'], cwd=PACKAGE, input=text, encoding='utf-8',
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout

    def test_every_header_has_its_page_and_no_warning(self):
        self.assertEqual(self.run_doxygen(), (0, ''))
        pages = (self.output / 'doxygen' / 'files.html').read_text('utf-8')
        headers = sorted((PACKAGE / 'include').rglob('*.h'))
        self.assertGreater(len(headers), 20)
        for header in headers:
            self.assertIn('>%s<' % header.name, pages)

    def test_a_warning_is_an_error(self):
        (self.output / 'wrong.h').write_text(WRONG)
        status, text = self.run_doxygen('INPUT = %s' % self.output)
        self.assertNotEqual(status, 0)
        self.assertIn("argument 'radius'", text)

    def test_it_is_short(self):
        self.assertLessEqual(len(self.doxyfile.splitlines()), MAX_LINES)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop())
    if not shutil.which('doxygen'):
        print('skipped: pages of the headers, doxygen is not installed; '
              'scripts/test --ci installs it')
        sys.exit(SKIPPED)
    unittest.main()
