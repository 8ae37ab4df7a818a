#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what a box costs against the size of its mesh: plot_cost.py ROWS.json PICTURE.png

The rows are those of `scripts/bench core --json`.
"""
import json
import sys

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402, after the choice of the backend

# Method, label, colour; solid lines are exact boxes, dashed ones loose.
EXACT = [('paper_loop', "the paper's loop over triangles", '#888888'),
         ('welded_scan', 'scan of all vertices', '#444444'),
         ('bullet_slow', 'Bullet getAabbSlow, hull', '#d18700'),
         ('fcl_exact', 'FCL computeBV, hull', '#a3348b'),
         ('ours_sse2', 'link_bounds, SSE2', '#4aa3df'),
         ('ours_avx2', 'link_bounds, AVX2', '#0b5fa5')]
LOOSE = [('geometric_shapes', 'geometric_shapes', '#2f8f4e'),
         ('corners8', 'eight corners', '#c0392b'),
         ('fcl', "FCL's sphere", '#a3348b'),
         ('bullet', 'Bullet getAabb, MoveIt', '#d18700')]


def points_of(rows, method):
    """Pairs of vertices and ns per box, in ascending order."""
    return sorted((row['vertices'], row['ns']) for row in rows
                  if row['method'] == method and row['kind'] != 'synthetic')


def draw(rows, methods, style, axes):
    for method, label, colour in methods:
        points = points_of(rows, method)
        if points:
            axes.plot(*zip(*points), style, color=colour, label=label, markersize=3, linewidth=1)


def main():
    with open(sys.argv[1], encoding='utf-8') as file:
        rows = json.load(file)
    figure, axes = pyplot.subplots(figsize=(9, 5.2))
    draw(rows, EXACT, 'o-', axes)
    draw(rows, LOOSE, '.--', axes)
    axes.set(xscale='log', yscale='log', xlabel='vertices of the mesh',
             ylabel='ns per box', title='Cost of a box under rotation: exact (solid), loose (dashed)')
    axes.grid(True, which='major', alpha=0.3)
    axes.legend(loc='center left', bbox_to_anchor=(1.0, 0.5), frameon=False)
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == '__main__':
    main()
