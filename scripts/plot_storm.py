#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the age of boxes and the node's memory over time: plot_storm.py ROWS.csv PICTURE.png

The rows are those of `scripts/soak --storm`. Of each second the oldest boxes are drawn.
"""
import csv
import itertools
import sys

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402, after the choice of the backend

MAX_AGE = 250  # ms, which storm_test.py allows
MAX_MEMORY = 200  # MB


def seconds_of(rows):
    """(second, oldest boxes [ms], largest memory [MB]) of each second."""
    for second, group in itertools.groupby(rows, lambda row: int(float(row['seconds']))):
        samples = list(group)
        yield (second, max(float(row['age_ms']) for row in samples),
               max(float(row['resident_mb']) for row in samples))


def draw(axes, minutes, values, limit, title):
    axes.plot(minutes, values, color='#0b5fa5', linewidth=0.8)
    axes.axhline(limit, color='#c0392b', linewidth=0.8, linestyle='--')
    axes.set(title=title, ylim=(0, 1.1 * max(limit, *values)))
    axes.grid(True, alpha=0.3)


def main():
    with open(sys.argv[1], encoding='utf-8') as file:
        seconds, ages, memory = zip(*seconds_of(csv.DictReader(file)))
    minutes = [second / 60 for second in seconds]
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(9, 5), sharex=True)
    draw(above, minutes, ages, MAX_AGE, 'Oldest boxes of each second [ms]; dashed: the limit')
    draw(below, minutes, memory, MAX_MEMORY, 'Memory of the node [MB]')
    below.set(xlabel='minutes of storm')
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == '__main__':
    main()
