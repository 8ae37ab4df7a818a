# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables and the code of README.md and doc/*.md."""
import pathlib
import re

PACKAGE = pathlib.Path(__file__).resolve().parent.parent.parent


def code_block(page, title, language):
    """The first block of a language below a line of a page."""
    text = (PACKAGE / page).read_text('utf-8')
    below = text[text.index('\n' + title + '\n'):]
    return re.search(r'^```%s\n(.*?)^```$' % language, below, re.DOTALL | re.MULTILINE).group(1)


def tables(text):
    """Every table of a markdown text as its rows, the header first; no backticks."""
    result, rows = [], []
    for line in text.splitlines() + ['']:
        if line.startswith('|'):
            cells = [cell.strip().replace('`', '') for cell in line.strip().strip('|').split('|')]
            if not all(re.fullmatch(':?-+:?', cell) for cell in cells):
                rows.append(cells)
        elif rows:
            result.append(rows)
            rows = []
    return result


def rows_below(text, header):
    """The rows of all tables with that header."""
    return [row for table in tables(text) if table[0] == header for row in table[1:]]
