# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of which only bounds are known, and poses of such: for check_certificate."""
import math

import numpy as np


class Interval:
    """Numbers between lo and hi."""
    def __init__(self, lo, hi=None):
        self.lo = np.asarray(lo, float)
        self.hi = self.lo if hi is None else np.asarray(hi, float)

    def map(self, function):
        return Interval(function(self.lo), function(self.hi))

    def __getitem__(self, key):
        return Interval(self.lo[key], self.hi[key])

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __abs__(self):
        return Interval(np.maximum(0, np.maximum(self.lo, -self.hi)), np.maximum(-self.lo, self.hi))

    def __add__(self, other):
        return rounded(self.lo + other.lo, self.hi + other.hi)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        return rounded(np.minimum.reduce(ends), np.maximum.reduce(ends))


def rounded(lo, hi, steps=1):
    return Interval(lo - steps * np.spacing(np.abs(lo)), hi + steps * np.spacing(np.abs(hi)))


def exact(number):
    return Interval(float(number))


def stack(parts, axis=-1):
    return Interval(np.stack([p.lo for p in parts], axis), np.stack([p.hi for p in parts], axis))


def dot(a, b):
    product = a * b
    return product[..., 0] + product[..., 1] + product[..., 2]


def length(a):
    square = dot(abs(a), abs(a))
    return rounded(np.sqrt(np.maximum(square.lo, 0)), np.sqrt(square.hi))


def cross(a, b):
    return stack([a[..., i] * b[..., j] - a[..., j] * b[..., i]
                  for i, j in ((1, 2), (2, 0), (0, 1))])


class Pose:
    """A matrix and a place."""
    def __init__(self, matrix=Interval(np.eye(3)), place=Interval(np.zeros(3))):
        self.matrix, self.place = matrix, place

    def turn(self, vectors):
        return dot(self.matrix, vectors[..., None, :])

    def apply(self, points):
        return self.turn(points) + self.place

    def __mul__(self, other):
        columns = other.matrix.map(np.transpose)
        return Pose(self.turn(columns).map(np.transpose), self.apply(other.place))

    def inverse(self):
        back = Pose(self.matrix.map(np.transpose))
        return Pose(back.matrix, -back.turn(self.place))


def rotation(axis, angle):
    """About a unit axis; the C library's sine and cosine are wrong by less than 4 steps."""
    sine, cosine = (rounded(f(angle), f(angle), 4) for f in (math.sin, math.cos))
    turned = stack([cross(axis, Interval(row)) for row in np.eye(3)])
    return Pose(Interval(np.eye(3)) * cosine + turned * sine
                + axis[:, None] * axis[None, :] * (exact(1) - cosine))
