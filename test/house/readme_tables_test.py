#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""README.md and doc/*.md against the code: tables say what the programs and
message files say, links lead somewhere, and named files, functions and tests exist.

Run as: readme_tables_test.py PATH_OF_link_bounds_publisher FOLDER_OF_assert_box
FOLDER_OF_THE_PACKAGE
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import unittest

from help_testing import help_rows
from page_testing import rows_below, tables
from three_hosts_testing import NEIGHBOURS

PUBLISHER, PROGRAMS, PACKAGE = '', pathlib.Path(), pathlib.Path()
ASSERTIONS = ('assert_box', 'assert_distance')
MAX_PICTURE_BYTES = 3000000
# Of README.md. With 240 words above and a picture of 343 pixels the commands end at 967 of 1,000 pixels.
MAX_LINES, MAX_WORDS_ABOVE, MAX_PICTURE_HEIGHT = 250, 245, 350
FOLDERS = ('doc/', 'include/', 'launch/', 'msg/', 'scripts/', 'src/', 'srv/', 'test/')


def text_of(*path):
    return PACKAGE.joinpath(*path).read_text('utf-8')


def pages():
    """{path: text} of the README, CONTRIBUTING and the pages in doc."""
    paths = [PACKAGE / 'README.md', PACKAGE / 'CONTRIBUTING.md'] + sorted((PACKAGE / 'doc').glob('*.md'))
    return {path: path.read_text('utf-8') for path in paths}


def without_blocks(text):
    """Without fenced code blocks, whose comments look like headings."""
    return re.sub(r'^```.*?^```$', '', text, flags=re.DOTALL | re.MULTILINE)


def code_in(text):
    return re.findall('`([^`\n]+)`', without_blocks(text))


def anchors(text):
    """What GitHub makes of the headings."""
    headings = re.findall(r'^#+ (.*)$', without_blocks(text), re.MULTILINE)
    return {re.sub(r'[^\w\- ]', '', heading.lower()).replace(' ', '-') for heading in headings}


def links(text):
    return re.findall(r'\]\(([^)\s]+)\)', without_blocks(text))


def section(text, title):
    """What stands below a heading of the second level, up to the next one."""
    return re.search(r'^## %s\n(.*?)(?=^## |\Z)' % re.escape(title), text,
                     re.DOTALL | re.MULTILINE).group(1)


def fields_of(path):
    """[name, type] of each field of a message or service file; constants are left out."""
    lines = [line.split('#')[0].split() for line in path.read_text('utf-8').splitlines()]
    return [[name, kind] for kind, name in (words for words in lines if len(words) > 1)
            if '=' not in name]


def known_tests():
    """The names by which ctest -R finds them."""
    lists = ' '.join(path.read_text('utf-8')
                     for path in (PACKAGE / 'test').rglob('CMakeLists.txt'))
    names = re.findall(r'(?:bounds_\w+\(|NAME )(\w+)', lists)
    for several in re.findall(r'bounds_gtests\(([^)]*)\)', lists):
        names += several.split()
    return set(names)


def needs_data(name):
    """True if (part of) a test runs with LINK_BOUNDS_DATA only."""
    return any('LINK_BOUNDS_DATA' in path.read_text('utf-8')
               for path in (PACKAGE / 'test').rglob(name + '_test.*')
               if path.suffix != '.pyc')


class ReadmeTablesTest(unittest.TestCase):
    """The tables that the programs and the message files hold."""

    def rows_of_help(self, help_section, program=None):
        help_text = subprocess.run([program or PUBLISHER, '--help'], check=True, timeout=20,
                                   stdout=subprocess.PIPE).stdout.decode('utf-8')
        rows = help_rows(help_section, help_text)
        self.assertGreater(len(rows), 0)
        return rows

    def check(self, text, help_section, header, program=None):
        self.assertEqual(rows_below(text, header), self.rows_of_help(help_section, program))

    def test_topics(self):
        self.check(text_of('README.md'), 'Topics', ['topic', 'type', 'when'])

    def test_services(self):
        self.check(text_of('README.md'), 'Services', ['service', 'type', 'what'])

    def test_parameters(self):
        self.check(text_of('README.md'), 'Parameters', ['name', 'type', 'default', 'meaning'])

    def test_interface_of_cloud_filter(self):
        text, program = text_of('doc/clouds.md'), PROGRAMS / 'cloud_filter'
        self.check(text, 'Topics', ['topic', 'type', 'when'], program)
        self.check(text, 'Services', ['service', 'type', 'what'], program)
        self.check(text, 'Parameters', ['name', 'type', 'default', 'meaning'], program)

    def test_example_config(self):
        text = text_of('launch/example_config.yaml')
        blocks = re.findall(r'^((?:# .*\n)+?)(?:# )?(\w+): (.*)$', text[text.index('\n\n'):],
                            re.MULTILINE)
        rows = [[name, default, ' '.join(comment.replace('# ', '').split())]
                for comment, name, default in blocks]
        rows.insert(0, ['robot_description', '(public, found upwards)', None])
        expected = self.rows_of_help('Parameters')
        self.assertEqual([row[:2] for row in rows], [[name, default]
                                                     for name, _, default, _ in expected])
        self.assertEqual([row[2] for row in rows[1:]], [row[3] for row in expected[1:]])

    def test_parameters_of_assertions(self):
        for name in ASSERTIONS:
            self.check(section(text_of('doc/tools.md'), name), 'Parameters',
                       ['parameter', 'type', 'default', 'meaning'], PROGRAMS / name)

    def test_examples_of_assertions_are_some_that_run(self):
        for name in ASSERTIONS:
            example = re.search(r'^  <test .*?^  </test>$', section(text_of('doc/tools.md'), name),
                                re.DOTALL | re.MULTILINE)
            self.assertIn('type="%s"' % name, example.group(0))
            self.assertIn(example.group(0), text_of('test/tools/assertions', name + '.test'))

    def test_messages(self):
        messages = sorted((PACKAGE / 'msg').iterdir()) + sorted((PACKAGE / 'srv').iterdir())
        self.assertGreater(len(messages), 0)
        for message in messages:
            title = '`link_bounds/%s`\n' % message.stem
            described = [text for text in pages().values() if title in text]
            self.assertEqual(len(described), 1, message.stem)
            table = tables(described[0][described[0].index(title):])[0]
            self.assertEqual(table[0], ['field', 'type', 'meaning'])
            self.assertEqual([row[:2] for row in table[1:]], fields_of(message))

    def test_faults_name_their_tests(self):
        known = known_tests()
        rows = [row for row in rows_below(text_of('doc/reliability.md'),
                                          ['fault', 'what happens', 'test']) if row[1]]
        self.assertGreater(len(rows), 20)
        for fault, _, names in rows:
            for name in names.split(', '):
                is_script = os.access(PACKAGE / name, os.X_OK)
                self.assertTrue(name in known or is_script, '%s: no test %s' % (fault, name))
                self.assertFalse(needs_data(name), '%s: %s needs data' % (fault, name))

    def test_timers_of_a_cut_cable_are_those_of_its_test(self):
        names = {'base_reachable': 'base_reachable_time_ms', 'retrans': 'retrans_time_ms',
                 'delay_probe': 'delay_first_probe_time'}
        timers = re.findall(r'net.ipv4.neigh.eth0.(\w+)=(\d+)', text_of('doc/deployment.md'))
        self.assertEqual(dict(timers), {names[name]: str(value)
                                        for name, value in NEIGHBOURS.items()})


class DiagnosticsTest(unittest.TestCase):
    """The table of levels in doc/deployment.md; the test diagnostics holds that of keys."""

    def test_levels_and_texts(self):
        code = text_of('src/node/upkeep/diagnostics.cpp')
        code = code.replace(' " + logText(health.awaited_description)', ' robot_description"')
        code = code.replace('logText(nearestText(*health.nearest))',
                            '"NAME and NAME may be only N m apart"')
        code = code.replace('ageText(age_ms, health.delay_ms)',
                            '"boxes were up to N ms old when they were sent; '
                            'the longest delay in this node was N ms"')
        code = code.replace('behindText(topic, seconds)', '"~TOPIC was up to N ms behind ~boxes"')
        errors = re.search(r'kUnexpectedErrors\[\] =\s*(".*?");', text_of('src/node/upkeep/status.h'))
        code = code.replace('kUnexpectedErrors', errors.group(1))
        raised = re.findall(r'raise\(status, DiagnosticStatus::(\w+),\s*(.*?)\);', code, re.DOTALL)
        self.assertGreater(len(raised), 5)
        in_code = {(level, re.sub(r'std::to_string\(.*\) \+ "', '"N', text).strip('"'))
                   for level, text in raised}
        in_code.add(('OK', re.search(r'status.message = "(.*?)"', code).group(1)))
        rows = rows_below(text_of('doc/deployment.md'), ['level', 'text', 'when'])
        self.assertEqual({(level, text) for level, text, _ in rows}, in_code)


class PagesTest(unittest.TestCase):
    """What holds for every page."""

    def test_links_lead_to_files_and_headings(self):
        checked = 0
        for page, text in pages().items():
            for link in links(text):
                if '://' in link:
                    continue
                name, _, anchor = link.partition('#')
                target = page.parent / name if name else page
                self.assertTrue(target.exists(), '%s: %s' % (page.name, link))
                if anchor:
                    self.assertIn(anchor, anchors(target.read_text('utf-8')),
                                  '%s: %s' % (page.name, link))
                checked += 1
        self.assertGreater(checked, 30)

    def test_every_page_is_linked_from_the_readme(self):
        for page in pages():
            if page.parent.name == 'doc':
                self.assertIn('doc/' + page.name, links(text_of('README.md')))

    def test_named_files_exist(self):
        names = {path.name for folder in FOLDERS for path in (PACKAGE / folder).rglob('*')}
        for page, text in pages().items():
            for code in code_in(text):
                if code.startswith(FOLDERS) and ' ' not in code:
                    self.assertTrue((PACKAGE / code).exists(), '%s: %s' % (page.name, code))
                elif re.fullmatch(r'\w+\.(cpp|h|py|launch|rviz)', code):
                    self.assertIn(code, names, page.name)

    def test_rows_have_the_cells_of_their_header(self):
        for page, text in pages().items():
            for table in tables(text):
                self.assertEqual({len(row) for row in table}, {len(table[0])},
                                 '%s: %s' % (page.name, table[0]))

    def test_pictures_are_there_and_small(self):
        pictures = [page.parent / name for page, text in pages().items()
                    for name in re.findall(r'(?:!\[[^]]*\]\(|<img src=")(.*?)[)"]', text)]
        self.assertIn(PACKAGE / 'doc/arm.gif', pictures)
        for picture in pictures:
            self.assertLess(picture.stat().st_size, MAX_PICTURE_BYTES, picture)


class FirstScreenTest(unittest.TestCase):
    """What it is, a picture, figures and two commands fit into 1,000 pixels as GitHub shows them."""

    def setUp(self):
        self.text = text_of('README.md')

    def test_words_before_the_commands(self):
        above, commands = self.text.split('```')[:2]
        self.assertEqual(re.findall(r'^scripts/\w+', commands, re.MULTILINE),
                         ['scripts/demo', 'scripts/test'])
        self.assertLessEqual(len(above.split()), MAX_WORDS_ABOVE)

    def test_height_of_the_picture(self):
        name, shown = re.search(r'<img src="(.*?)" width="(\d+)"', self.text).groups()
        width, height = struct.unpack('<6xHH', (PACKAGE / name).read_bytes()[:10])  # of a GIF
        self.assertLessEqual(int(shown) * height / width, MAX_PICTURE_HEIGHT)

    def test_is_one_page(self):
        self.assertLessEqual(len(self.text.splitlines()), MAX_LINES)


class ArchitectureTest(unittest.TestCase):
    """doc/architecture.md and its drawing."""

    def test_rooms_are_the_folders_with_their_sentences(self):
        rooms = {str(path.parent.relative_to(PACKAGE)): path.read_text('utf-8').splitlines()[0]
                 for path in (PACKAGE / 'src').rglob('CMakeLists.txt')}
        self.assertGreater(len(rooms), 20)
        rows = rows_below(text_of('doc/architecture.md'), ['room', 'what it is'])
        self.assertEqual({room: '# ' + sentence for room, sentence in rows}, rooms)

    def test_stops_name_functions_in_their_files(self):
        text = text_of('doc/architecture.md')
        for title in ('A tf message', 'A marker', 'A distance', 'A box of the past',
                      'A recorded message', 'The parameter `padding`'):
            stops = re.findall(r'^\d+\. (.*?)(?=^\d+\. |^\n|\Z)', section(text, title),
                               re.DOTALL | re.MULTILINE)
            self.assertGreater(len(stops), 4, title)
            for stop in stops:
                function, *names = code_in(stop)
                files = [name for name in names if name.startswith(FOLDERS)]
                self.assertTrue(files, stop)
                code = ' '.join(text_of(file) for file in files)
                self.assertTrue(function + '(' in code, 'no function: ' + stop)
                for name in set(names) - set(files):
                    self.assertTrue(name[0] in '-~' or name in code, '%s: %s' % (name, stop))

    def test_drawing_names_files_that_exist(self):
        drawn = set(re.findall(r'\w+\.cpp', text_of('doc/architecture.dot')))
        sources = {path.name for path in (PACKAGE / 'src').rglob('*.cpp')}
        self.assertGreater(len(drawn), 0)
        self.assertEqual(drawn - sources, set())


class PaperTest(unittest.TestCase):
    """doc/paper.md."""

    def test_files_and_tests_exist(self):
        known, text = known_tests(), text_of('doc', 'paper.md')
        rows = [line.strip('|').split('|') for line in text.splitlines()
                if line.startswith('| ') and not line.endswith('| tests |')]
        self.assertGreater(len(rows), 20)
        for *cells, tests in rows:
            names = code_in(' '.join(cells))
            files = [name for name in names if '/' in name]
            self.assertTrue(files and code_in(tests), 'no file or no test: %s' % cells)
            scripts = {name for name in code_in(tests) if name.startswith('scripts/')}
            for script in scripts:
                self.assertTrue(os.access(PACKAGE / script.split()[0], os.X_OK), script)
            self.assertEqual(set(code_in(tests)) - scripts - known, set())
            self.assertTrue('LINK_BOUNDS_DATA' in names or
                            not all(map(needs_data, code_in(tests))), 'needs data: %s' % tests)
            for word in set(names) - set(files):
                self.assertTrue(any(word in text_of(file) for file in files), word)
        for name in code_in(text):
            self.assertTrue('/' not in name or (PACKAGE / name.split()[0]).exists(), name)

    def test_what_is_not_realised_is_named(self):
        missing = ' '.join(section(text_of('doc', 'paper.md'), 'What is not realised').split())
        for words in ('k-DOP', 'convex polyhedra', 'hybrid', 'deeper hierarchy',
                      'Penetration depth'):
            self.assertIn(words, missing)

    def test_every_figure_is_there(self):
        figures = re.findall(r'Figures? (\d+)(?: and (\d+))?', text_of('doc', 'paper.md'))
        self.assertEqual({int(n) for pair in figures for n in pair if n}, set(range(1, 11)))


if __name__ == '__main__':
    PACKAGE, PROGRAMS = pathlib.Path(sys.argv.pop()), pathlib.Path(sys.argv.pop())
    PUBLISHER = sys.argv.pop()
    unittest.main()
