#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/debian: names agree with the libraries and programs, and a manual page shows what --help
prints. scripts/test --all builds the packages and looks into them: debian_test.py FOLDER"""
import importlib.util
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True  # scripts/deb copies the folder

PACKAGE = pathlib.Path()
HELP = '''usage: urdf_bounds FILE
         [--format F]

Prints -- in
two lines.

  --format F  table (default)
              csv: no
              spaces
  ~boxes | link_bounds/Box | latched
  .           a dot
'''
PAGE = r'''.SH SYNOPSIS
.br
rosrun link_bounds urdf_bounds FILE
.br
_________[\-\-format F]
.SH DESCRIPTION
Prints \-\- in
two lines.
.PP
.TP
\fB\-\-format F\fR
table (default)
.br
csv: no
spaces
.TP
\fB~boxes\fR
(link_bounds/Box)
.br
latched
.TP
\fB\&.\fR
a dot
'''.replace('_' * 9, '\N{NO-BREAK SPACE}' * 9)


def text_of(path):
    return (PACKAGE / path).read_text('utf-8')


class DebianTest(unittest.TestCase):
    def setUp(self):
        spec = importlib.util.spec_from_file_location(
            'man_page', PACKAGE / 'scripts/debian/man_page.py')
        self.man_page = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.man_page)

    def test_the_package_of_the_libraries_has_their_soversion(self):
        version = re.search(r'SOVERSION (\d+)', text_of('src/geometry/CMakeLists.txt')).group(1)
        for path in ('control.in', 'rules', 'liblink-bounds0.install'):
            names = set(re.findall(r'(?:link-bounds|link_bounds|[.]so[.])(\d+)',
                                   text_of('scripts/debian/' + path)))
            self.assertEqual(names, {version}, path)

    def test_each_program_with_a_page_has_a_line_about_it(self):
        programs = re.search('^PROGRAMS = (.*)$', text_of('scripts/debian/rules'), re.MULTILINE)
        self.assertEqual(programs.group(1).split(), sorted(self.man_page.ABOUT))

    def test_a_page_shows_what_help_prints(self):
        roff = self.man_page.page_of('urdf_bounds', '1.2.3', HELP)
        self.assertEqual(roff[roff.index('.SH SYNOPSIS'):], PAGE)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
