# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The motion between the rows of a table, and exempt pairs, for check_certificate.

From row to row a joint is at a polynomial of the share of the time between the two, from 0 to 1:
linear; cubic where the rows have velocities; of fifth order where they have accelerations, too.
The coefficients c_k around the middle of an interval are computed as fractions, so they are exact:
within half its width h the joint stays within the sum of |c_k| h^k, k > 0, of c_0."""
import csv
import functools
import itertools
import math
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

import numpy as np
from certificate_objects import add_objects, number
from certificate_pairs import Pair, drawn, leaves
from certificate_robot import Refused, Unusable


def cells(line, file):
    """Of one line of a table: each stands by itself, whatever the quotes in it."""
    try:
        return next(csv.reader([line.rstrip('\r')], skipinitialspace=True, strict=True))
    except csv.Error as reason:
        raise Refused('%s is no table: %s' % (file, reason)) from reason


class Path:
    """A csv file whose first line names its columns, or else `columns`; other joints stay where
    `given` says."""
    def __init__(self, file, robot, given, columns):
        with open(file, encoding='utf-8-sig', newline='') as text:
            lines = [cells(line, file) for line in text.read().split('\n')
                     if line.strip(' \t\r') and not line.strip(' \t\r').startswith('#')]
        if columns:
            lines.insert(0, cells(columns, '--columns'))
        names = [name.strip() for name in lines[0]] if lines else []
        if not set(names) & set(robot.joints):
            raise Unusable('%s has no column of a joint; where it has no line of names, give them '
                           'by --columns A,B' % file)
        if len(set(names)) != len(names) or any(len(line) != len(names) for line in lines):
            raise Refused('%s is no table' % file)
        known = {name for name in names if name == 'time' or any(
            name == joint + end for joint in robot.joints
            for end in ('', '.velocity', '.acceleration'))}
        self.rows = [{name: Fraction(number(cell.strip(' \t'), '%s: %s' % (file, name)))
                      for name, cell in zip(names, line) if name in known} for line in lines[1:]]
        self.has_speeds = any(name.endswith('.velocity') for name in names)
        self.is_quintic = any(name.endswith('.acceleration') for name in names)
        self.joints = {name for name in names if name in robot.joints}
        self.resting = {name: list(given.get(name, (0.0, 0.0))) for name in robot.joints}
        self.segments = len(self.rows) - 1

    @functools.lru_cache(maxsize=1000)
    def polynomial(self, segment, joint):
        first, second = self.rows[segment:segment + 2]
        p, d = first[joint], second[joint] - first[joint]
        if not self.has_speeds:
            return [p, d]
        time = second['time'] - first['time']
        if time <= 0:
            raise Refused('times do not grow')
        v, w = (row.get(joint + '.velocity', 0) * time for row in (first, second))
        if not self.is_quintic:
            return [p, v, 3 * d - 2 * v - w, v + w - 2 * d]
        a, b = (row.get(joint + '.acceleration', 0) * time ** 2 for row in (first, second))
        # What is left for the last three coefficients: value, slope and curvature at the end.
        value, slope, curve = d - v - a / 2, w - v - a, b - a
        return [p, v, a / 2, 10 * value - 4 * slope + curve / 2, 7 * slope - 15 * value - curve,
                6 * value - 3 * slope + curve / 2]

    @functools.lru_cache(maxsize=1000)
    def box(self, segment, begin, end):
        """Bounds of all joints in that part of a segment."""
        middle, half = (Fraction(begin) + Fraction(end)) / 2, (Fraction(end) - Fraction(begin)) / 2
        found = dict(self.resting)
        for joint in self.joints:
            c = self.polynomial(segment, joint)
            shifted = [sum(math.comb(n, k) * c[n] * middle ** (n - k) for n in range(k, len(c)))
                       for k in range(len(c))]
            spread = sum(abs(x) * half ** k for k, x in enumerate(shifted) if k > 0)
            ends = float(shifted[0] - spread), float(shifted[0] + spread)
            found[joint] = [float(np.nextafter(end, sign * math.inf))
                            for end, sign in zip(ends, (-1, 1))]
        return found


def disabled(file, links):
    """The pairs of links that a SRDF exempts."""
    root = ElementTree.parse(file).getroot()
    off, on = ({frozenset((each.get('link1'), each.get('link2'))) for each in root.findall(tag)}
               for tag in ('disable_collisions', 'enable_collisions'))
    return off | {frozenset((each.get('link'), other)) for other in links
                  for each in root.findall('disable_default_collisions')} - on


def pairs(robot, objects, kinds):
    """Bodies that must stay apart: two or more joints are between links, one before an object."""
    bodies = [link for link in robot.links if robot.body(link, kinds)]
    found = set()
    for first, second in itertools.combinations(bodies, 2):
        moving = len(robot.moving(first, second))
        resting = len(objects & {first, second})
        if resting < 2 and moving + resting >= 2 and moving > 0:
            found.add(frozenset((first, second)))
    return found


class Segments:
    """The motion from row to row, and the pairs that must stay apart."""
    def __init__(self, robot, given, kinds, options):
        if not options.poses:
            raise Refused('it is about a path, give its table, too: --poses FILE')
        self.robot, self.kinds, self.made = robot, kinds, {}
        links = list(robot.links)
        objects = add_objects(options.objects, robot) if options.objects else set()
        self.path = Path(options.poses, robot, given, options.columns)
        self.pairs = pairs(robot, objects, kinds)
        exempt = disabled(options.srdf, links) if options.srdf else set()
        # A SRDF is about links: an object may have the name of one that this robot does not have.
        self.exempt = {pair for pair in self.pairs & exempt if not pair & objects}

    def pair(self, entry):
        names = entry['first'], entry['second']
        if names not in self.made:
            self.made[names] = Pair(self.robot, entry, self.kinds, lambda joint: None)
        return self.made[names]

    def check(self, entry, head, options):
        """How many boxes there are, and how many were checked."""
        number = entry['from'] - 1
        if not (0 <= number < self.path.segments and entry['to'] == number + 2
                and entry['distance'] > head['clearance'] >= 0):
            raise Refused('there is no such segment')
        names = [frozenset((each['first'], each['second'])) for each in entry['pairs']]
        missing = self.pairs - self.exempt - set(names)
        if missing or len(set(names)) < len(names):
            raise Refused('a pair is missing or stands twice: %s' % sorted(map(sorted, missing)))
        boxes = []
        for each in entry['pairs']:
            tree = {'variables': ['share'], 'tree': each['tree']}
            boxes += [(each, leaf, box['share'], halvings)
                      for leaf, box, halvings in leaves(tree, {'share': [0.0, 1.0]})]
        chosen = drawn(boxes, options)
        for each, leaf, share, _ in chosen:
            box = self.path.box(number, *share)
            if not self.pair(each).check(leaf, box, entry['distance']):
                raise Refused('%s and %s: not proven from %g to %g' % (
                    each['first'], each['second'], *share))
        return len(boxes), len(chosen)
