#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/figures --texts passes for README.md and doc/*.md. It fails where a figure was changed in
a page, or in a page and in doc/figures.json; --check fails where a ratio has changed:
figures_test.py FOLDER_OF_THE_PACKAGE
"""
import importlib.machinery
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from unittest import mock

PACKAGE = pathlib.Path(sys.argv.pop())
MAX_WORDS = 2500  # of the page by which a user decides
FILES = ('README.md', 'package.xml', 'doc', 'scripts/figures', 'scripts/figure_values.py')
SENTENCE = 'A loop over all triangles takes %s times as long'


class FiguresTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / 'scripts').mkdir()
        for name in FILES:
            copy = shutil.copytree if (PACKAGE / name).is_dir() else shutil.copy
            copy(PACKAGE / name, self.folder / name)
        readme = ' '.join((PACKAGE / 'README.md').read_text('utf-8').split())
        self.figure = re.search(SENTENCE % r'(\d+)', readme)[1]

    def run_script(self, *arguments):
        """Exit code, and what it printed, of the copy."""
        done = subprocess.run([sys.executable, '-B', self.folder / 'scripts/figures', *arguments],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                              encoding='utf-8')
        return done.returncode, done.stdout

    def replace(self, name, old, new):
        path = self.folder / name
        text = path.read_text('utf-8')
        changed = re.sub(old, new, text, count=1)
        self.assertNotEqual(changed, text, '%s has no %s' % (name, old))
        path.write_text(changed, 'utf-8')

    def test_pages_have_the_measured_figures(self):
        done = subprocess.run([PACKAGE / 'scripts/figures', '--texts'], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, check=False, encoding='utf-8')
        print(done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_changed_figure_in_a_page(self):
        self.replace('README.md', self.figure + ' times', '999 times')
        self.replace('doc/measurements.md', '[|] reached [|]', '| **missed by 9 %** |')
        code, text = self.run_script('--texts')
        self.assertEqual(code, 1)
        self.assertIn('README.md: 999 must be %s (core/paper_loop/times)' % self.figure, text)
        self.assertIn('not as measured: the table | target', text)
        self.assertEqual(self.run_script('--write'), (0, ''))
        self.assertEqual((self.folder / 'README.md').read_text('utf-8'),
                         (PACKAGE / 'README.md').read_text('utf-8'))

    def test_a_changed_figure_in_a_page_and_in_the_file(self):
        self.replace('README.md', self.figure + ' times', '999 times')
        self.replace('doc/performance.md', '[|] %s [|] 1.00' % self.figure, '| 999 | 1.00')
        self.replace('doc/figures.json', '"core/paper_loop/times": [0-9.]+',
                     '"core/paper_loop/times": 999.0')
        code, text = self.run_script('--texts')
        self.assertEqual(code, 1)
        self.assertIn('doc/figures.json was edited by hand', text)

    def test_a_figure_that_nobody_measured(self):
        self.replace('README.md', r'- \*\*Fast\.\*\*', '- **Fast.** A mesh loads in 3 ms.')
        code, text = self.run_script('--texts')
        self.assertEqual(code, 1)
        self.assertIn('doc/figures.txt does not explain 3 in', text)

    def check(self, factor):
        """What --check says if the loop now takes factor times as long as measured."""
        loader = importlib.machinery.SourceFileLoader('figures', str(PACKAGE / 'scripts/figures'))
        with mock.patch.object(sys, 'path', [str(PACKAGE / 'scripts'), *sys.path]), \
                mock.patch.object(sys, 'dont_write_bytecode', True):
            figures = types.ModuleType('figures')
            figures.__file__ = loader.path
            loader.exec_module(figures)
        parts = figures.read_parts()
        parts['core']['figures']['core/paper_loop/ns'] *= factor
        with mock.patch.object(figures, 'run', lambda part, is_quick: parts[part]), \
                mock.patch.dict(os.environ, LINK_BOUNDS_DATA='anywhere'):
            return figures.check()

    def test_a_ratio_that_has_changed(self):
        self.assertEqual(self.check(1.9) + self.check(1 / 1.9), [])
        for factor in (2.1, 1 / 2.1):
            wrong = self.check(factor)
            self.assertEqual(len(wrong), 1)
            self.assertIn('core/welded_scan/ns / core/paper_loop/ns: ', wrong[0])

    def test_a_part_beside_a_mode_that_takes_none(self):
        for mode in ('--check', '--texts', '--write'):
            code, text = self.run_script(mode, 'core')
            self.assertEqual(code, 2, text)
            self.assertIn('a PART is only measured', text)

    def test_missed_targets_are_explained(self):
        page = (PACKAGE / 'doc/measurements.md').read_text('utf-8')
        reasons = ' '.join(page[page.index('## Where it falls short'):].split())
        explained = tuple(re.findall(r'\*\*(.*?)\*\*', reasons))
        for row in re.findall(r'^\| (.*?) \|.*\*\*missed', page, re.MULTILINE):
            self.assertTrue(row.startswith(explained), 'say why this target is missed: ' + row)

    def test_the_page_to_decide_by_is_short(self):
        words = (PACKAGE / 'doc/performance.md').read_text('utf-8').split()
        self.assertLessEqual(len(words), MAX_WORDS)


if __name__ == '__main__':
    unittest.main()
