#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""CHANGELOG.rst as catkin_pkg and bloom read it: the newest version is that of package.xml, and
what each version brings stands below the same four headings.

Run as: changelog_test.py FOLDER_OF_THE_PACKAGE
"""
import pathlib
import re
import sys
import unittest

from catkin_pkg.changelog import BulletList, get_changelog_from_path
from catkin_pkg.package import parse_package

PACKAGE = pathlib.Path(sys.argv.pop())
GROUPS = ['Programs and topics', 'Behaviour', 'C++ interface', 'Build, tests and pages']
UNRELEASED = 'Forthcoming'  # what catkin_prepare_release replaces


class ChangelogTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.changelog = get_changelog_from_path(str(PACKAGE))
        cls.entries = list(cls.changelog.foreach_version(reverse=True))

    def test_newest_version_is_that_of_the_package(self):
        newest = [version for version, _, _ in self.entries[:1]]
        self.assertEqual(newest, [parse_package(str(PACKAGE)).version])

    def test_newer_versions_have_later_dates(self):
        dates = [date for _, date, _ in self.entries]
        self.assertEqual(dates, sorted(dates, reverse=True))

    def test_each_version_is_a_heading_and_a_list_per_group(self):
        for version, _, content in self.entries:
            headings = [str(entry).strip('*') for entry in content[::2]]
            self.assertEqual(headings, GROUPS, version)
            self.assertEqual({type(entry) for entry in content[1::2]}, {BulletList}, version)

    def test_catkin_reads_every_section(self):
        titles = re.findall(r'^(.+)\n-+$', self.changelog.rst, re.MULTILINE)
        read = ['%s (%s)' % (version, date.date()) for version, date, _ in self.entries]
        self.assertEqual([title for title in titles if title != UNRELEASED], read)


if __name__ == '__main__':
    unittest.main()
