#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures in README.md and doc/*.md are those that scripts/figures measured: doc/figures.txt
says which figure stands where, doc/figures.json has the values.

Run as: figures_test.py FOLDER_OF_THE_PACKAGE
"""
import json
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(sys.argv.pop())
sys.path.insert(0, str(PACKAGE / 'scripts'))
sys.dont_write_bytecode = True
import figure_texts  # noqa: E402, after the path is set
import figure_values  # noqa: E402

# Every number with a unit on these pages is a figure, or listed as a constant; on those of
# MEASURED every number in a table, too. The pages on faults and networks have limits instead, which the
# tests hold that they name.
PAGES = ['README.md', 'doc/architecture.md', 'doc/library.md',
         'doc/scene.md', 'doc/tools.md']
MEASURED = ['doc/performance.md', 'doc/measurements.md']
MAX_WORDS = 2500  # of the page by which a user decides


class FiguresTest(unittest.TestCase):
    """The texts beside the file."""

    @classmethod
    def setUpClass(cls):
        cls.file = json.loads((PACKAGE / 'doc' / 'figures.json').read_text('utf-8'))
        cls.values = cls.file['figures']

    def test_texts_have_the_measured_figures(self):
        wrong = figure_texts.differences(PACKAGE, self.values)
        self.assertEqual(wrong, [], '\n'.join(wrong + ['remedy: scripts/figures --write']))

    def test_no_figure_is_unexplained(self):
        for page in PAGES + MEASURED:
            unknown = figure_texts.unexplained(PACKAGE, page, page in MEASURED)
            self.assertEqual(unknown, [], '\n'.join(unknown))

    def test_file_says_where_it_was_measured(self):
        for entry in ('commit', 'date', 'processor', 'cores', 'compiler', 'peers'):
            self.assertTrue(self.file[entry], entry)
        self.assertTrue(self.file['targets'])

    def test_every_target_is_in_the_table(self):
        starts = tuple(figure_values.TARGETS.values())
        for target in self.file['targets']:
            self.assertTrue((target['target'] + '  ').startswith(starts), target['target'])
        text = (PACKAGE / 'doc' / 'figures.txt').read_text('utf-8')
        for name in figure_values.TARGETS:
            self.assertIn('{targets/%s/verdict}' % name, text)

    def test_missed_targets_are_explained(self):
        text = (PACKAGE / 'doc' / 'measurements.md').read_text('utf-8')
        reasons = ' '.join(text[text.index('## Where it falls short'):].split())
        for row in re.findall(r'^\| (.*?) \|.*\*\*missed', text, re.MULTILINE):
            self.assertIn('**%s**' % row, reasons, 'say why this target is missed')


    def test_page_to_decide_by_is_short(self):
        words = (PACKAGE / 'doc' / 'performance.md').read_text('utf-8').split()
        self.assertLessEqual(len(words), MAX_WORDS)


class MechanismTest(unittest.TestCase):
    """On a page of its own: each fault is found, and `write` mends it."""

    def setUp(self):
        self.package = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.package)
        (self.package / 'doc').mkdir()
        self.sentences = '== README.md\nA box takes {a/ns} ns, {b:.2f} times\n| box | {a/ns} |\n'
        self.write('A box takes 35 ns,\n2.50 times ours.\n\n| box | 35 |\n')

    def write(self, page, sentences=None):
        (self.package / 'README.md').write_text(page, 'utf-8')
        (self.package / 'doc' / 'figures.txt').write_text(sentences or self.sentences, 'utf-8')

    def differences(self, values):
        return figure_texts.differences(self.package, values)

    def test_right_figures(self):
        self.assertEqual(self.differences({'a/ns': 35.2, 'b': 2.499}), [])
        self.assertEqual(figure_texts.unexplained(self.package, 'README.md', True), [])

    def test_stale_figures_are_named_and_mended(self):
        values = {'a/ns': 7.04, 'b': 2.5}
        wrong = self.differences(values)
        self.assertEqual(len(wrong), 2)
        self.assertIn('35 must be 7.0 (a/ns)', wrong[0])
        figure_texts.write(self.package, values)
        self.assertEqual((self.package / 'README.md').read_text('utf-8'),
                         'A box takes 7.0 ns,\n2.50 times ours.\n\n| box | 7.0 |\n')

    def test_zero_has_no_minus(self):
        self.assertEqual(figure_texts.to_text(-0.4, '.0f'), '0')
        self.assertEqual(figure_texts.to_text(-0.04, '.1f'), '0.0')
        self.assertEqual(figure_texts.to_text(-10, '.0f'), '-10')

    def test_missing_key_and_missing_sentence(self):
        self.assertIn('lacks b', self.differences({'a/ns': 35})[0])
        self.write('A box takes long.\n\n| box | 35 |\n')
        self.assertIn('0 times in the page', self.differences({'a/ns': 35, 'b': 2.5})[0])
        with self.assertRaises(LookupError):
            figure_texts.write(self.package, {'a/ns': 1, 'b': 1})
        self.assertIn('| 35 |', (self.package / 'README.md').read_text('utf-8'))

    def test_unexplained_figures(self):
        self.write('A box takes 35 ns,\n2.50 times ours; 4 MB.\n\n| box | 35 |\n| mesh | 70 |\n')
        self.assertEqual(len(figure_texts.unexplained(self.package, 'README.md', True)), 2)
        self.assertEqual(len(figure_texts.unexplained(self.package, 'README.md', False)), 1)

    def test_targets_are_read_as_they_are_printed(self):
        line = '%s  <=    2.50:      2.75  MISSED  (from 1.87 to 3.11 on 63 meshes)\n'
        targets = figure_values.targets_of('Targets\n' + line % 'ours_avx2 / corners8')
        figures = figure_values.of_targets(targets)
        self.assertEqual(figures['targets/avx2/verdict'], '**missed by 10 %**')
        self.assertEqual(figures['targets/avx2/max'], 3.11)

    def test_a_target_may_be_below_zero(self):
        line = 'us above the relay, 50 links at 100 Hz  <= 15.00:  -2.13  reached  (from %s)\n'
        targets = figure_values.targets_of(line % '-12.43 to 54.88 in 22 repetitions')
        self.assertEqual(figure_values.of_targets(targets)['targets/cpu_50/min'], -12.43)
        with self.assertRaisesRegex(LookupError, 'cannot be read: us above the relay'):
            figure_values.targets_of(line % '-12.43 to nan in 22 repetitions')


if __name__ == '__main__':
    unittest.main()
