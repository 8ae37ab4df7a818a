# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables that --help prints."""


def help_rows(section, text):
    """The rows that --help prints below a line which begins with `section`."""
    lines = iter(text.splitlines())
    next(line for line in lines if line.startswith(section))
    rows = []
    for line in lines:
        if not line.startswith('  '):
            break
        rows.append([cell.strip() for cell in line.split(' | ')])
    return rows
