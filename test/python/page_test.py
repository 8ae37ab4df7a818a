#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The code of doc/python.md and the ten lines of the README run as they are: page_test.py FOLDER"""
import contextlib
import io
import os
import pathlib
import re
import sys
import unittest

from page_testing import code_block

PACKAGE = pathlib.Path()


def printed_by(code):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, 'page', 'exec'), {})
    return out.getvalue()


class PageTest(unittest.TestCase):
    def setUp(self):
        os.chdir(PACKAGE)

    def test_the_page(self):
        text = (PACKAGE / 'doc/python.md').read_text('utf-8')
        blocks = re.findall(r'^```python\n(.*?)^```$', text, re.DOTALL | re.MULTILINE)
        self.assertEqual(len(blocks), 5)
        out = printed_by(''.join(blocks))
        self.assertIn("'elbow_bend'", out)
        self.assertRegex(out, r'\n1 (SAFE|COLLIDES) 0\.\d+ \w+ \w+\n')
        self.assertIn('"elbow" is no movable joint of the robot; those that can be set:', out)

    def test_the_lines_of_the_readme(self):
        code = code_block('README.md', 'Without a robot or a master, [from Python](doc/python.md), '
                          'in arrays of NumPy:', 'python')
        self.assertEqual(code.count('\n'), 10)
        out = printed_by(code)
        for words in ('upper_arm', 'highest point: ', 'poses bring two links within 1 mm: ', ': NEVER>'):
            self.assertIn(words, out)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
