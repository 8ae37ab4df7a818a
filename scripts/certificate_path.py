# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The motion between the rows of a table, objects around the robot, and exempt pairs, for
check_certificate.

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
from certificate_intervals import Interval, Pose, dot, exact, rounded
from certificate_pairs import Pair, drawn, leaves
from certificate_robot import NotCovered, Refused, shape, solid_of


def cells(line, file):
    """Of one line of a table: each stands by itself, whatever the quotes in it."""
    try:
        return next(csv.reader([line.rstrip('\r')], skipinitialspace=True, strict=True))
    except csv.Error as reason:
        raise Refused('%s is no table: %s' % (file, reason)) from reason


class Path:
    """A csv file whose first line names its columns; other joints stay where `given` says."""
    def __init__(self, file, robot, given):
        with open(file, encoding='utf-8-sig', newline='') as text:
            lines = [cells(line, file) for line in text.read().split('\n')
                     if line.strip(' \t\r') and not line.strip(' \t\r').startswith('#')]
        names = [name.strip() for name in lines[0]]
        if len(set(names)) != len(names) or any(len(line) != len(names) for line in lines):
            raise Refused('%s is no table' % file)
        known = {name for name in names if name == 'time' or any(
            name == joint + end for joint in robot.joints
            for end in ('', '.velocity', '.acceleration'))}
        self.rows = [{name: Fraction(float(cell)) for name, cell in zip(names, line)
                      if name in known} for line in lines[1:]]
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


def add_objects(file, robot):
    """As links that are fixed to the root."""
    import yaml
    with open(file, encoding='utf-8') as text:
        objects = yaml.safe_load(text)
    root = robot.root(next(iter(robot.links)))
    for name, fields in objects.items():
        if name in robot.links:
            raise Refused('object %s has the name of a link' % name)
        joint = ElementTree.Element('joint', name='to object ' + name, type='fixed')
        ElementTree.SubElement(joint, 'parent', link=root)
        robot.joints[joint.get('name')] = robot.above[name] = joint
        robot.links[name] = ElementTree.Element('link')
        robot.bodies[name] = [placed(fields, robot)]
    return set(objects)


def placed(fields, robot):
    """The shape of an object."""
    pose, kind = fields.get('pose', {}), fields['type']
    scale = [float(fields.get('scale', {}).get(key, 1)) for key in 'xyz']
    if kind == 'SPHERE' and len(set(scale)) > 1 or kind == 'CYLINDER' and scale[0] != scale[1]:
        raise NotCovered('an object is an ellipsoid, or round in no circle')
    x, y, z = map(repr, scale)
    radius = repr(scale[0] / 2)
    text = {'CUBE': '<box size="%s %s %s"/>' % (x, y, z),
            'SPHERE': '<sphere radius="%s"/>' % radius,
            'CYLINDER': '<cylinder radius="%s" length="%s"/>' % (radius, z),
            'MESH_RESOURCE': '<mesh scale="%s %s %s"/>' % (x, y, z)}[kind]
    element = ElementTree.fromstring('<visual><geometry>%s</geometry></visual>' % text)
    if kind == 'MESH_RESOURCE':
        if not fields['mesh_resource'].startswith(('file:///', 'package://')):
            raise NotCovered('the mesh of an object has a relative name')
        solid_of(element).set('filename', fields['mesh_resource'])
    position = [float(pose.get('position', {}).get(key, 0)) for key in 'xyz']
    turn = pose.get('orientation', {'w': 1})
    frame = quaternion([float(turn.get(key, 0)) for key in 'wxyz'])
    points, swell, parts = shape(element, robot.file_of)
    return frame.apply(points) + Interval(position), swell, parts


def quaternion(values):
    """The rotation of the unit quaternion along w, x, y, z."""
    q = Interval(values)
    square = dot(q[None, 1:], q[None, 1:])[0] + q[0] * q[0]
    if not square.lo > 0:
        raise Refused('an orientation is zero')
    twice = rounded(2 / square.hi, 2 / square.lo)
    w, x, y, z = (q[i] for i in range(4))
    one = exact(1)
    rows = [[one - twice * (y * y + z * z), twice * (x * y - w * z), twice * (x * z + w * y)],
            [twice * (x * y + w * z), one - twice * (x * x + z * z), twice * (y * z - w * x)],
            [twice * (x * z - w * y), twice * (y * z + w * x), one - twice * (x * x + y * y)]]
    return Pose(Interval(*(np.array([[float(getattr(cell, end)) for cell in row] for row in rows])
                           for end in ('lo', 'hi'))))


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
        self.path = Path(options.poses, robot, given)
        self.pairs = pairs(robot, objects, kinds)
        self.exempt = self.pairs & disabled(options.srdf, links) if options.srdf else set()

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
