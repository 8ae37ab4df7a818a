# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables and targets of the scripts, as those of table.h and target.h."""
import statistics


def text_of(value):
    """For people, with three digits or more."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if not isinstance(value, float):
        return str(value)
    return "%.*f" % (next((digits for digits, end in ((3, 0.9995), (2, 9.995), (1, 99.95))
                           if abs(value) < end), 0), value)


class Table:
    """In Markdown, each row as soon as it is measured. Columns are {name of a value: head}; those
    of `texts` are so wide and stand to the left."""

    def __init__(self, title, columns, **texts):
        self._names = list(columns)
        self._widths = [max(len(head), texts.get(name, 7)) for name, head in columns.items()]
        self._texts = texts
        print("\n%s\n" % title)
        self.add(columns)
        print("".join("|" + "-" * (width + 1) + ("-" if name in texts else ":")
                      for name, width in zip(self._names, self._widths)) + "|", flush=True)

    def add(self, row):
        cells = [(text_of(row.get(name)), width, name in self._texts)
                 for name, width in zip(self._names, self._widths)]
        print("| " + " | ".join(text.ljust(width) if is_text else text.rjust(width)
                                for text, width, is_text in cells) + " |", flush=True)


def print_table(title, columns, rows, **texts):
    table = Table(title, columns, **texts)
    for row in rows:
        table.add(row)


def print_target(text, limit, values, at_most=True):
    """One line: is the median within the limit? scripts/figures reads it."""
    median = statistics.median(values)
    reached = median <= limit if at_most else median >= limit
    print("%-76s %s %7.2f: %9.2f  %s (from %.2f to %.2f on %d value%s)" % (
        text, "<=" if at_most else ">=", limit, median, "reached" if reached else "MISSED ",
        min(values), max(values), len(values), "" if len(values) == 1 else "s"))
