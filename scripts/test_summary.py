#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarises a run of the tests from what they printed.

Run as: test_summary.py BUILD_FOLDER [BUILD_FOLDER_OF_A_SANITIZER ...]

A test reports its results in lines of its output:
  truth: N boxes compared; worst error X m...
  faults: N WHAT
  latency: ...
  skipped: WHAT AND WHY
"""

import collections
import functools
import glob
import os
import re
import sys
from xml.etree import ElementTree

FACT = re.compile(r'(truth|faults|latency|skipped): (.*)')
TRUTH = re.compile(r'(\d+) boxes compared; worst error (\S+) m')


def text_of(path):
    if not os.path.exists(path):
        return ''
    with open(path, encoding='utf-8', errors='replace') as file:
        return file.read()


@functools.lru_cache(maxsize=None)
def results(build):
    """The roots of the JUnit files, without those that only say that rostest ran a test."""
    roots = []
    for path in sorted(glob.glob(os.path.join(build, 'test_results', '*', '*.xml'))):
        if os.path.basename(path).startswith('rostest-'):
            continue
        try:
            roots.append(ElementTree.parse(path).getroot())
        except ElementTree.ParseError:
            print('not readable:', path)
    return roots


def details(build):
    """What the tests of ctest printed; the output of a rostest's tests is in the JUnit files."""
    return text_of(os.path.join(build, 'Testing', 'Temporary', 'LastTest.log'))


def facts(build):
    """By kind, in the order of the tests."""
    texts = [details(build)]
    for root in results(build):
        texts += [out.text or '' for out in root.iter('system-out')]
    found = collections.defaultdict(list)
    for line in '\n'.join(texts).splitlines():
        match = FACT.match(line.strip())
        if match:
            found[match.group(1)].append(match.group(2))
    return found


def cases(build):
    """How many test cases ran in all tests of ctest."""
    scripts = map(int, re.findall(r'^Ran (\d+) tests? in ', details(build), re.MULTILINE))
    return sum(len(root.findall('.//testcase')) for root in results(build)) + sum(scripts)


def tests(build):
    """ctest's own count, as "109 of 109"; nothing where it did not run."""
    match = re.search(r'(\d+) tests failed out of (\d+)', text_of(os.path.join(build, 'ctest.log')))
    if not match:
        return ''
    failed, every = map(int, match.groups())
    return '%d of %d passed' % (every - failed, every)


def print_counted(kind, lines):
    for line, count in collections.Counter(lines).items():
        print('%-9s %s%s' % (kind + ':', line, ' (%d times)' % count if count > 1 else ''))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build, *sanitized = sys.argv[1:]
    found = facts(build)
    print('tests:    %s, with %d cases' % (tests(build) or 'none', cases(build)))
    for folder in sanitized:
        if tests(folder):
            print('          %s: %s' % (os.path.basename(folder), tests(folder)))
    compared = [TRUTH.match(line) for line in found['truth']]
    if compared:
        print('boxes:    %d compared with known ones, worst error %.1e m'
              % (sum(int(match.group(1)) for match in compared),
                 max(float(match.group(2)) for match in compared)))
    print_counted('survived', found['faults'])
    print_counted('latency', found['latency'])
    skipped = [line for folder in [build, *sanitized] for line in facts(folder)['skipped']]
    print_counted('skipped', skipped or ['nothing'])


if __name__ == '__main__':
    main()
