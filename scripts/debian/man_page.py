#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The manual page of a program, from what its --help prints: man_page.py PACKAGE_XML PROGRAM

help2man would join the lines of an option's values and the rows of our tables to paragraphs."""
import os
import re
import subprocess
import sys
from xml.etree import ElementTree

ABOUT = {
    'assert_box': 'test of published boxes for rostest',
    'assert_distance': 'test of published distances for rostest',
    'bag_bounds': 'boxes and distances of a robot during a recorded bag',
    'link_bounds_publisher': 'ROS node that publishes the exact box of each link of a robot',
    'urdf_bounds': 'exact boxes, distances and proofs of a robot from its URDF',
}
OPTION = re.compile(r'  (\S.*?)(?:  +(\S.*))?$')  # its name, and its text from a second column on
MAX_INDENT = 4  # spaces before a name; lines with more continue a text


def escaped(text):
    text = text.replace('\\', r'\e').replace('-', r'\-')
    return re.sub("^([.'])", r'\\&\1', text)


def bold(text):
    return r'\fB%s\fR' % escaped(text)


class Page:
    """Collects lines of roff."""

    def __init__(self):
        self.lines = []
        self._is_in_list = False

    def add(self, *lines):
        self.lines += lines

    def add_item(self, name, text):
        self.add('.TP', bold(name), escaped(text or '') or r'\&')
        self._is_in_list = True

    def add_text(self, text):
        """Of a paragraph, or with `name: ...` at the start a line of its own in a list."""
        if self._is_in_list and re.match(r'[\w-]+: ', text):
            self.add('.br')
        self.add(escaped(text))

    def end_paragraph(self):
        self.add('.PP')
        self._is_in_list = False


def add_row(page, row):
    """NAME | TYPE | ... | MEANING"""
    name, *middle, meaning = row.split(' | ')
    page.add_item(name, '(%s)' % ', '.join(middle) if middle else '')
    page.add('.br', escaped(meaning))


def indent_of(line):
    return len(line) - len(line.lstrip())


def add_line(page, line):
    indent = indent_of(line)
    option = OPTION.match(line)
    if not line:
        page.end_paragraph()
    elif 0 < indent <= MAX_INDENT and ' | ' in line:
        add_row(page, line.strip())
    elif 0 < indent <= MAX_INDENT and option:
        page.add_item(*option.groups())
    else:
        page.add_text(line.strip())


def page_of(name, version, text):
    usage, _, rest = text.partition('\n\n')
    page = Page()
    page.add('.TH %s 1 "" "link_bounds %s" "link_bounds"' % (name.upper(), version),
             '.SH NAME', r'%s \- %s' % (name, escaped(ABOUT[name])), '.SH SYNOPSIS')
    usage = re.sub('^usage: (rosrun link_bounds )?', 'rosrun link_bounds ', usage)
    for line in usage.splitlines():
        page.add('.br', escaped(line.replace(' ', '\N{NO-BREAK SPACE}', indent_of(line))))
    page.add('.SH DESCRIPTION')
    for line in rest.splitlines():
        add_line(page, line)
    return '\n'.join(page.lines) + '\n'


def main():
    package, program = sys.argv[1:]
    version = ElementTree.parse(package).findtext('version')
    text = subprocess.run([program, '--help'], check=True, stdout=subprocess.PIPE,
                          encoding='utf-8').stdout
    print(page_of(os.path.basename(program), version, text), end='')


if __name__ == '__main__':
    main()
