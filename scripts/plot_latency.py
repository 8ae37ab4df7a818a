#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how long boxes take to arrive: plot_latency.py PICTURE.png ROWS.json ...

The rows are those of `scripts/bench end-to-end --json`, at 1 kHz.
"""
import json
import sys

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402, after the choice of the backend

HZ = 1000
METHODS = [('usual_tf2', 'usual node of tf2, loose boxes', '#c0392b'),
           ('ours', 'link_bounds, exact boxes', '#0b5fa5'),
           ('relay', 'relay that computes nothing', '#888888')]


def draw(rows, figure, axes, title):
    """One quantity of all methods over the number of links."""
    for method, label, colour in METHODS:
        own = sorted((row for row in rows if row['method'] == method and row['hz'] == HZ),
                     key=lambda row: row['links'])
        links = [row['links'] for row in own]
        axes.plot(links, [row[figure] for row in own], 'o-', color=colour, label=label,
                  markersize=4, linewidth=1.2)
    axes.set(xscale='log', yscale='log', xlabel='links', title=title)
    axes.set_xticks(links, [str(count) for count in links])
    axes.minorticks_off()
    axes.grid(True, which='major', alpha=0.3)


def main():
    rows = []
    for path in sys.argv[2:]:
        with open(path, encoding='utf-8') as file:
            rows += json.load(file)
    figure, (latency, cpu) = pyplot.subplots(1, 2, figsize=(9, 3.8))
    draw(rows, 'p50_us', latency, 'From tf message to boxes, median [µs]')
    draw(rows, 'cpu_us_per_update', cpu, 'CPU time of the node per message [µs]')
    latency.legend(frameon=False)
    figure.suptitle('tf at 1 kHz, over TCP on one machine')
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == '__main__':
    main()
