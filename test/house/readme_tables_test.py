#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the README say what the node and the message files say; its pictures are there;
doc/paper.md names what exists.

Run as: readme_tables_test.py PATH_OF_link_bounds_publisher PATH_OF_assert_box FOLDER_OF_THE_PACKAGE
"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

from help_testing import help_rows

PUBLISHER, ASSERT_BOX, PACKAGE = '', '', ''
MOST_PICTURE_BYTES = 3000000


def tables(text):
    """Every table of a markdown text as its rows, the header first; no backticks."""
    result, rows = [], []
    for line in text.splitlines() + ['']:
        if line.startswith('|'):
            cells = [cell.strip().replace('`', '') for cell in line.strip().strip('|').split('|')]
            if not all(re.fullmatch('-+', cell) for cell in cells):
                rows.append(cells)
        elif rows:
            result.append(rows)
            rows = []
    return result


def rows_below(text, header):
    """The rows of all tables with that header."""
    return [row for table in tables(text) if table[0] == header for row in table[1:]]


def fields_of(path):
    """[name, type] of each field of a message file."""
    with open(path, encoding='utf-8') as file:
        lines = [line.split('#')[0].split() for line in file]
    return [[name, kind] for kind, name in (words for words in lines if words)]


def text_of(*path):
    """Of a file in the package."""
    with open(os.path.join(PACKAGE, *path), encoding='utf-8') as file:
        return file.read()


def code_in(text):
    return re.findall('`([^`]+)`', text)


def known_tests():
    """The names by which ctest -R finds them."""
    lists = ' '.join(path.read_text('utf-8')
                     for path in pathlib.Path(PACKAGE, 'test').rglob('CMakeLists.txt'))
    return set(re.findall(r'(?:bounds_\w+\(|NAME )(\w+)', lists))


class ReadmeTablesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.readme = text_of('README.md')

    def check(self, section, header, program=None):
        text = subprocess.run([program or PUBLISHER, '--help'], check=True, timeout=20,
                              stdout=subprocess.PIPE).stdout.decode('utf-8')
        expected = help_rows(section, text)
        self.assertGreater(len(expected), 0)
        self.assertEqual(rows_below(self.readme, header), expected)

    def test_topics(self):
        self.check('Topics', ['topic', 'type', 'when'])

    def test_services(self):
        self.check('Services', ['service', 'type', 'what'])

    def test_parameters(self):
        self.check('Parameters', ['name', 'type', 'default', 'meaning'])

    def test_parameters_of_assert_box(self):
        self.check('Parameters', ['parameter', 'type', 'default', 'meaning'], ASSERT_BOX)

    def test_example_of_assert_box_is_one_that_runs(self):
        example = re.search(r'^  <test .*?^  </test>$', self.readme, re.DOTALL | re.MULTILINE)
        self.assertIn(example.group(0), text_of('test', 'tools', 'assert_box', 'assert_box.test'))

    def test_messages(self):
        messages = sorted(os.listdir(os.path.join(PACKAGE, 'msg')))
        self.assertGreater(len(messages), 0)
        for message in messages:
            title = '`link_bounds/%s`\n' % message[:-len('.msg')]
            self.assertIn(title, self.readme)
            table = tables(self.readme[self.readme.index(title):])[0]
            self.assertEqual(table[0], ['field', 'type', 'meaning'])
            self.assertEqual([row[:2] for row in table[1:]],
                             fields_of(os.path.join(PACKAGE, 'msg', message)))

    def test_faults_name_their_tests(self):
        known = known_tests()
        rows = [row for row in rows_below(self.readme, ['fault', 'what happens', 'test']) if row[1]]
        self.assertGreater(len(rows), 20)
        for fault, _, names in rows:
            for name in names.split(', '):
                is_script = os.access(os.path.join(PACKAGE, name), os.X_OK)
                self.assertTrue(name in known or is_script, '%s: no test %s' % (fault, name))

    def test_paper_names_files_and_tests_that_exist(self):
        known, text = known_tests(), text_of('doc', 'paper.md')
        rows = [line.strip('|').split('|') for line in text.splitlines()
                if line.startswith('| ') and not line.endswith('| tests |')]
        self.assertGreater(len(rows), 20)
        for *cells, tests in rows:
            names = code_in(' '.join(cells))
            files = [name for name in names if '/' in name]
            self.assertTrue(files and code_in(tests), 'no file or no test: %s' % cells)
            self.assertEqual(set(code_in(tests)) - known, set())
            for word in set(names) - set(files):
                self.assertTrue(any(word in text_of(file) for file in files), word)
        for name in code_in(text):
            self.assertTrue('/' not in name or os.path.exists(os.path.join(PACKAGE, name)), name)

    def test_paper_page_has_every_figure(self):
        figures = re.findall(r'Figures? (\d+)(?: and (\d+))?', text_of('doc', 'paper.md'))
        self.assertEqual({int(n) for pair in figures for n in pair if n}, set(range(1, 11)))

    def test_pictures_are_there_and_small(self):
        pictures = re.findall(r'!\[[^]]*\]\((.*?)\)', self.readme)
        self.assertGreater(len(pictures), 0)
        for picture in pictures:
            size = os.path.getsize(os.path.join(PACKAGE, picture))
            self.assertLess(size, MOST_PICTURE_BYTES, picture)

    def test_drawing_names_files_that_exist(self):
        with open(os.path.join(PACKAGE, 'doc', 'architecture.dot'), encoding='utf-8') as file:
            drawn = set(re.findall(r'\w+\.cpp', file.read()))
        sources = {name for _, _, names in os.walk(os.path.join(PACKAGE, 'src')) for name in names}
        self.assertGreater(len(drawn), 0)
        self.assertEqual(drawn - sources, set())


if __name__ == '__main__':
    PACKAGE, ASSERT_BOX, PUBLISHER = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()
    unittest.main()
