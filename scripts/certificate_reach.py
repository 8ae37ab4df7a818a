# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes that links never leave, for check_certificate.

Let h_i(d) be the largest dot product of d with a point of the link, seen from the frame before
joint i, while the joints from i on take all their values. A line of the file has a table for each
joint but the first: numbers no less than h_i along the points d_k of a grid on a cube. Where
d = sum w_k d_k with w_k >= 0, h_i(d) <= sum w_k h_i(d_k), because no point is better for the sum
than the best one for each part. So a table bounds h_i along any d; the last one is checked against
the points of the link, each other one against the one after it, and the box against the first one.

Joint i moves a point p to t + R Q(q) p, so h_i(d) = t.d + max of h_i+1(e(q)), e(q) = Q(-q) R'd. For
a prismatic joint the max is at an end of the range. Otherwise let f be the part of R'd along the
axis and c >= h_i+1(-f). Between angles q0 and q1 = q0 + D < q0 + pi it is
e(q) = A e(q0) + B e(q1) + (A + B - 1)(-f) with A = sin(q1 - q) / sin D and B = sin(q - q0) / sin D,
so h_i+1(e(q)) <= A b0 + B b1 - c with b = h_i+1(e) + c, which is a sinusoid less c. Joints that
follow the same one count as independent, which only adds poses."""
import math
import random

import numpy as np
from certificate_intervals import Interval, Pose, cross, dot, exact, length, rotation, rounded
from certificate_robot import Refused, origin

CHUNK = 200000  # vectors at once
ROUNDING = 1e-12  # of a support; the sums of a few doubles here are off by less than a hundredth


class Reach:
    """The joints between the root and a link, and the shapes of the link."""
    def __init__(self, robot, entry, kinds):
        pose, self.joints = Pose(), []
        for joint, _ in robot.way(robot.root(entry['link']), entry['link']):
            pose = pose * origin(joint)
            kind, axis, (name, factor, offset) = robot.motion(joint)
            if kind == 'fixed':
                continue
            lower, upper = sorted(factor * end + offset for end in robot.range(name))
            if lower < upper:
                self.joints.append((pose, kind == 'prismatic', axis, lower, upper))
                pose = Pose()
            elif kind == 'prismatic':
                pose = pose * Pose(place=axis * exact(lower))
            else:
                pose = pose * rotation(axis, lower)
        self.shapes = []  # points, a radius, and the axis of a disc; without one, it is that of a ball
        link = entry['link'], kinds
        for (points, radius, _), cylinder in zip(robot.body(*link), robot.cylinders(*link)):
            axis = None
            if cylinder:
                place, radius, height = cylinder
                points = place.apply(Interval([[0, 0, -height / 2], [0, 0, height / 2]]))
                axis = (pose * place).turn(Interval([0, 0, 1.0]))
            self.shapes.append((pose.apply(points), radius, axis))
        if not self.shapes:
            raise Refused('the link has no shape')

    def support(self, i, d, table):
        """No less than h_i along each d; the table is of i + 1."""
        if i == len(self.joints):
            return np.max([(dot(p[None], d[:, None]) + exact(radius) * length(
                d if axis is None else cross(d, axis))[:, None]).hi.max(1)
                           for p, radius, axis in self.shapes], 0)
        before, is_straight, axis, lower, upper = self.joints[i]
        turned = before.inverse().turn(d)
        along = dot(turned, axis)
        start = dot(d, before.place).hi
        if is_straight:
            ends = np.maximum((along * exact(lower)).hi, (along * exact(upper)).hi)
            return start + ends + table.above(turned) + ROUNDING * (1 + table.largest)
        if upper - lower >= 2 * math.pi - 1e-12:
            lower, upper = -math.pi, math.pi
        pieces = max(1, math.ceil((upper - lower) / (2 / table.cells)))
        angles = np.append(lower + (upper - lower) * (np.arange(pieces) / pieces), upper)
        sine, cosine = (rounded(values, values, 4)[None, :, None] for values in (
            np.array([f(angle) for angle in angles]) for f in (math.sin, math.cos)))
        constant = axis * along[:, None]
        e = (constant[:, None] + (turned - constant)[:, None] * cosine
             + cross(turned, axis)[:, None] * sine)
        against = table.above(-constant)
        b = table.above(e) + against[:, None]
        half_piece = (upper - lower) / pieces / 2 * (1 + ROUNDING)
        cosine2, sine2 = math.cos(half_piece) ** 2, math.sin(half_piece) ** 2
        mean, half = (b[:, :-1] + b[:, 1:]) / 2, (b[:, 1:] - b[:, :-1]) / 2
        top = np.where(np.abs(half) * cosine2 < mean * sine2,
                       np.sqrt(mean ** 2 / cosine2 + half ** 2 / sine2), -math.inf)
        best = np.maximum(b.max(1), top.max(1)) - against
        return start + best + ROUNDING * (1 + table.largest)

    def check(self, entry, options):
        """How many supports there are, and how many were checked. The box always is, and so is
        what it rests on in the first table."""
        cells, step = entry['cells'], entry['step']
        if not (isinstance(cells, int) and 2 <= cells <= 1024 and 0 < step < math.inf):
            raise Refused('%s cells of step %s' % (cells, step))
        tables = [np.array(table, float) * step for table in entry['tables']]
        grid = directions(cells)
        if len(tables) != len(self.joints) or not all(
                table.shape == (len(grid),) and np.isfinite(table).all() for table in tables):
            raise Refused('a table is missing or has another size')
        largest, smallest = (np.array(entry[end], float) for end in ('max', 'min'))
        if not largest.shape == smallest.shape == (3,):
            raise Refused('a corner of the box has not three numbers')
        claims = [(np.concatenate((np.eye(3), -np.eye(3))), np.concatenate((largest, -smallest)))]
        claims += [(grid, table) for table in tables]
        tables = [Table(table, cells) for table in tables]
        total = checked = 0
        for i, (d, claim) in enumerate(claims):
            always = np.ones(len(d), bool) if i == 0 or options.all else (
                tables[0].used.reshape(-1) if i == 1 else np.zeros(len(d), bool))
            chosen = with_sample(always, options.sample)
            total, checked = total + len(d), checked + len(chosen)
            table = tables[i] if i < len(tables) else None
            size = max(len(p.lo) for p, *_ in self.shapes) if table is None else 4 * cells
            for part in np.array_split(chosen, len(chosen) * size // CHUNK + 1):
                holds = self.support(i, Interval(d[part]), table) <= claim[part] if len(part) else []
                if not np.all(holds):
                    raise Refused('not proven before joint %d along %s' % (i, d[part][~holds][0]))
        return total, checked


def directions(cells):
    """Points of the surface of a cube: by face, +x first, then along the two axes after its own."""
    line = 2.0 * np.arange(cells + 1) / cells - 1
    faces = np.empty((6, cells + 1, cells + 1, 3))
    for face in range(6):
        axis = face // 2
        faces[face, ..., axis] = 1 - 2 * (face % 2)
        faces[face, ..., (axis + 1) % 3] = line[:, None]
        faces[face, ..., (axis + 2) % 3] = line
    return faces.reshape(-1, 3)


def with_sample(always, count):
    """The indices of these entries, and of so many of the others."""
    others = np.flatnonzero(~always)
    some = random.sample(range(len(others)), min(len(others), count))
    return np.concatenate((np.flatnonzero(always), others[some]))


class Table:
    """Supports along the directions of a grid, and which of them were used."""
    def __init__(self, supports, cells):
        self.cells, self.values = cells, supports.reshape(6, cells + 1, cells + 1)
        self.largest = np.abs(supports).max()
        self.used = np.zeros(self.values.shape, bool)

    def above(self, vectors):
        """No less than the support along each vector: the mean of the corners of its cell, and the
        largest support times what the vector may differ from that mean of directions."""
        middle = (vectors.lo + vectors.hi).reshape(-1, 3) / 2
        row, axis, cells = np.arange(len(middle)), np.abs(middle).argmax(1), self.cells
        size = np.abs(middle[row, axis])
        face = 2 * axis + (middle[row, axis] < 0)
        scale = cells / 2 / np.maximum(size, 1e-300)
        places = [middle[row, (axis + k) % 3] * scale + cells / 2 for k in (1, 2)]
        i, j = (np.clip(place.astype(int), 0, cells - 1) for place in places)
        s, t = places[0] - i, places[1] - j
        table = self.values
        mean = ((1 - s) * ((1 - t) * table[face, i, j] + t * table[face, i, j + 1])
                + s * ((1 - t) * table[face, i + 1, j] + t * table[face, i + 1, j + 1]))
        for a, b, weight in ((i, j, (1 - s) * (1 - t)), (i, j + 1, (1 - s) * t),
                             (i + 1, j, s * (1 - t)), (i + 1, j + 1, s * t)):
            counts = weight != 0
            self.used[face[counts], a[counts], b[counts]] = True
        rest = (vectors.hi - vectors.lo).sum(-1).reshape(-1) + ROUNDING / 10 * size
        return (size * mean + rest * self.largest).reshape(vectors.lo.shape[:-1])
