#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what a box costs against the size of its mesh: plot_cost.py ROWS.json PICTURE.png

The rows are those of `scripts/bench core --json`. The table below the plot has the other methods.
"""
import json
import sys

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402, after the choice of the backend

# Method, label and its height above the last point, colour, style.
METHODS = [('paper_loop', "exact: loop over all\ntriangles, the paper's way", 0, '#6b6b6b', 's-'),
           ('fcl_exact', 'exact: FCL, computeBV\nof the hull', 0, '#c25b00', '^-'),
           ('ours_avx2', 'exact: link_bounds', 6, '#0b5fa5', 'o-'),
           ('corners8', 'loose: eight corners\nof the resting box', -12, '#8e2f6e', 'x--')]


def points_of(rows, method):
    """Pairs of vertices and ns per box, in ascending order."""
    return sorted((row['vertices'], row['ns']) for row in rows
                  if row['method'] == method and row['kind'] != 'synthetic')


def main():
    with open(sys.argv[1], encoding='utf-8') as file:
        rows = json.load(file)
    pyplot.rcParams['font.size'] = 12
    figure, axes = pyplot.subplots(figsize=(8, 4.4))
    for method, label, height, colour, style in METHODS:
        points = points_of(rows, method)
        axes.plot(*zip(*points), style, color=colour, markersize=6, linewidth=1.4)
        axes.annotate(label, points[-1], xytext=(10, height), textcoords='offset points', color=colour,
                      va='center', annotation_clip=False)
    axes.set(xscale='log', yscale='log', ylim=(3, None), xlabel='vertices of the mesh', ylabel='ns per box')
    axes.grid(True, which='major', alpha=0.3)
    for side in ('top', 'right'):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.subplots_adjust(right=0.7)
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == '__main__':
    main()
