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


def is_skipped(case):
    """gtest 1.11 and later say so by an element, earlier versions by an attribute."""
    return case.find('skipped') is not None or case.get('result') == 'skipped'


def counted(passed, skipped, failed=0):
    """As "108 passed, 2 skipped"."""
    counts = [(passed, 'passed'), (skipped, 'skipped'), (failed, 'failed')]
    return ', '.join('%d %s' % count for count in counts if count[0] or count[1] == 'passed')


def cases(build):
    """The test cases that ran in all tests of ctest, by what became of them."""
    scripts, skipped_in_scripts = (
        sum(map(int, re.findall(pattern, details(build), re.MULTILINE)))
        for pattern in (r'^Ran (\d+) tests? in ', r'^(?:OK|FAILED) \(.*skipped=(\d+)'))
    found = [case for root in results(build) for case in root.iter('testcase')]
    failed = sum(case.find('failure') is not None or case.find('error') is not None
                 for case in found)
    skipped = sum(map(is_skipped, found)) + skipped_in_scripts
    return counted(len(found) + scripts - skipped - failed, skipped, failed)


def tests(build):
    """The tests of ctest, by what became of them; nothing where it did not run. ctest itself counts
    a skipped test as passed."""
    log = text_of(os.path.join(build, 'ctest.log'))
    match = re.search(r'(\d+) tests failed out of (\d+)', log)
    if not match:
        return ''
    failed, every = map(int, match.groups())
    skipped = len(re.findall(r'^\s*\d+ - \S+ \(Skipped\)', log, re.MULTILINE))
    return counted(every - failed - skipped, skipped, failed)


def print_failures(build):
    """The last lines of what each failed test case said, which ctest does not show of a rostest."""
    for root in results(build):
        for case in root.iter('testcase'):
            for found in [*case.findall('failure'), *case.findall('error')]:
                print('failed:   %s.%s' % (case.get('classname'), case.get('name')))
                lines = (found.text or found.get('message') or '').strip().splitlines()
                print('\n'.join('          ' + line for line in lines[-12:]))


def print_counted(kind, lines):
    for line, count in collections.Counter(lines).items():
        print('%-9s %s%s' % (kind + ':', line, ' (%d times)' % count if count > 1 else ''))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build, *sanitized = sys.argv[1:]
    found = facts(build)
    print('tests:    %s; cases: %s' % (tests(build) or 'none', cases(build)))
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
    for folder in [build, *sanitized]:
        print_failures(folder)


if __name__ == '__main__':
    main()
