# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Links that stay apart, or in contact, wherever the joints are, for check_certificate.

A pair has a tree of boxes of joint values that are halved, from the limits of the URDF on. A box
without halves names a direction n: at its centre the second body is beyond the first one along n,
by more than both can move in the box. How far that is: let the link behind some joint of the way
rest; the joints before it move the first body, the others the second. Taken to any pose one joint
at a time, that nearest to the resting link first, a point at the distance d from the axis of a
joint moves over a chord of at most 2 sin(h / 2) d, h being half the width of the box; if the joint
is prismatic, by h. Or, to second order: for offsets t_k the coordinate n.p changes by
sum t_k n.(a_k x (p - o_k)), and by at most the sum over rotations of
h_k^2 / 2 (d_k + b_k) + h_k b_k. Here b_k is how far the joints between k and the body move p, and
the reason is that a turn by t moves p by t a x p but for t^2 / 2 d, and that a x (p + q) differs
from a x p by at most the length of q.
"mesh": the shapes are cut into parts until some direction is found for each two of them.
Of links in contact, a box names a point near each body. The points of the bodies nearest to these
are moved as above, and stay within the distance that is claimed. Inside of a solid, a point is the
centre of a ball in it, whose radius adds to that distance."""
import heapq
import itertools
import math
import random
import sys

import numpy as np
from certificate_intervals import Interval, Pose, cross, dot, exact, length, rotation
from certificate_robot import Refused, origin

TOUCH = 1e-7  # metres; bodies this near collide


class Pair:
    """Two bodies and the joints between them."""
    def __init__(self, robot, entry, kinds, range_of=None):
        links = entry['first'], entry['second']
        self.bodies = [robot.body(link, kinds) for link in links]
        self.inside = [lambda hint, link=link: robot.inside(link, kinds, hint) for link in links]
        if not all(self.bodies):
            raise Refused('a link has no shape')
        self.steps, self.ranges = [], {}
        for joint, is_up in robot.way(*links):
            kind, axis, lead = robot.motion(joint)
            if kind != 'fixed' and lead[1] != 0:
                self.ranges[lead[0]] = (range_of or robot.range)(lead[0])
            self.steps.append((kind, origin(joint), is_up, axis, lead))

    def enter(self, box, bodies):
        """Places the two at the centre of the box. Bounds how far each joint moves each in it."""
        pose, self.axes = Pose(), []
        for kind, place, is_up, axis, (name, factor, offset) in self.steps:
            pose = pose if is_up else pose * place
            if kind != 'fixed':
                lower, upper = box[name] if factor != 0 else (0.0, 0.0)
                value = (-1 if is_up else 1) * (factor * (lower + upper) / 2 + offset)
                half = abs(factor) * (upper - lower) / 2 * (1 + 1e-9)
                half += 1e-15 * (abs(value) + abs(offset) + abs(factor * lower))
                is_straight = kind == 'prismatic'
                self.axes.append((is_straight, pose.place, pose.turn(axis), half))
                pose *= Pose(place=axis * exact(value)) if is_straight else rotation(axis, value)
            pose = pose * place.inverse() if is_up else pose
        second = [(pose.apply(p), radius, parts) for p, radius, parts in bodies[1]]
        self.placed = [bodies[0], second]
        self.levers = [[1.0 if is_straight else lever(body, place, axis)
                        for is_straight, place, axis, _ in self.axes] for body in self.placed]
        chords = [half if is_straight else 2 * math.sin(min(half, math.pi) / 2) * (1 + 1e-15)
                  for is_straight, _, _, half in self.axes]
        first, second = ([a * b for a, b in zip(chords, levers)] for levers in self.levers)
        self.moves = first, second
        sums = [sum(first[:cut]) + sum(second[cut:]) for cut in range(len(chords) + 1)]
        self.cuts = sorted(range(len(sums)), key=sums.__getitem__)
        self.motion = min(sums) * (1 + 1e-13)

    def farthest(self, shapes, side, n, cut):
        """The largest coordinate along n of a point of the shapes in the box, to second order."""
        joints = range(cut)[::-1] if side == 0 else range(cut, len(self.axes))
        tilts, slides, remainder, beyond = [], exact(0), exact(0), exact(0)
        for k in reversed(joints):
            is_straight, place, axis, half = self.axes[k]
            if is_straight:
                slides += exact(half) * abs(dot(n, axis))
            else:
                tilts.append((exact(half), cross(n, axis), place))
                speed = exact(self.levers[side][k]) + beyond
                remainder += exact(half) * (exact(half / 2) * speed + beyond)
            beyond += exact(self.moves[side][k])
        rest = slides + remainder * length(n)
        largest = []
        for p, radius, _ in shapes:
            # Linear in the offsets, so largest at a corner; of a point, the signs are known.
            offsets = [half * dot(p - place, tilt) for half, tilt, place in tilts]
            if radius == 0:
                largest.append(sum(map(abs, offsets), dot(p, n) + rest).hi.max())
                continue
            for signs in itertools.product((exact(-1), exact(1)), repeat=len(tilts)):
                value = sum((s * offset for s, offset in zip(signs, offsets)), dot(p, n) + rest)
                normal = sum((s * half * tilt for s, (half, tilt, _) in zip(signs, tilts)), n)
                largest.append((value + exact(radius) * length(normal)).hi.max())
        return exact(np.max(largest))

    def closes(self, n, shapes, clearance):
        """Whether the shapes are farther apart than that along n, all over the box."""
        n = Interval(n)
        if n.lo.shape != (3,) or not 0.5 < length(n).lo < 2:
            raise Refused('%s is no direction' % n.lo)
        return apart(n, shapes, clearance + self.motion) or any(
            (self.farthest(shapes[0], 0, n, cut) + self.farthest(shapes[1], 1, -n, cut)
             + exact(clearance) * length(n)).hi <= 0 for cut in self.cuts)

    def touches(self, leaf, box, distance):
        """Whether those points and the balls around them stay so near to each other."""
        (first, depth), (second, depth2) = (inside(p) for inside, p in zip(self.inside, leaf))
        self.enter(box, [[(first, 0.0, None)], [(second, 0.0, None)]])
        gap = length(self.placed[1][0][0] - first) + exact(self.motion)
        return gap.hi <= (exact(distance) + exact(depth) + exact(depth2)).lo

    def check(self, leaf, box, clearance):
        """Whether they stay farther apart than that."""
        self.enter(box, self.bodies)
        if leaf == 'mesh':
            return all(searched(a, b, clearance + self.motion)
                       for a in self.placed[0] for b in self.placed[1])
        if not isinstance(leaf[0], list):
            return self.closes(leaf, self.placed, clearance)
        pairs = list(itertools.product(*self.placed))
        return len(pairs) == len(leaf) and all(
            self.closes(n, ([a], [b]), clearance) for n, (a, b) in zip(leaf, pairs))


def lever(body, place, axis):
    """No point of the body is farther from that axis."""
    reaches = [length(cross(axis, p - place)).hi.max() + radius for p, radius, _ in body]
    return np.max(reaches) * (1 + 1e-15)


def support(shapes, n):
    return exact(np.max([(dot(p, n) + exact(radius) * length(n)).hi.max()
                         for p, radius, _ in shapes]))


def apart(n, shapes, least):
    return (support(shapes[0], n) + support(shapes[1], -n) + exact(least) * length(n)).hi <= 0


def direction(first, second, least):
    """Mostly one along which the hulls of two sets are that far apart; None if they are nearer.
    The nearest point of the hull of differences, by Wolfe's algorithm (1976)."""
    points, weights = second.mean(0)[None] - first.mean(0), np.ones(1)
    for _ in range(200):
        v = weights @ points
        size = math.sqrt(v @ v)
        nearest = second[np.argmin(second @ v)] - first[np.argmax(first @ v)]
        if not size >= least or not nearest @ v < (least + 1e-12) * size:
            break
        points, weights = np.vstack((points, nearest)), np.append(weights, 0.0)
        while len(points) > 1:
            rest = np.linalg.lstsq((points[1:] - points[0]).T, -points[0], rcond=None)[0]
            flat = np.append(1 - rest.sum(), rest)  # the nearest point of their plane
            leaving = flat <= 1e-14
            share = min([1.0, *(weights / np.maximum(weights - flat, 1e-300))[leaving]])
            weights = weights + share * (flat - weights)
            stays = ~leaving | (weights > 1e-14)
            points, weights = points[stays], weights[stays] / weights[stays].sum()
            if stays.all():
                break
    return v if size >= least and size > 0 else None


def searched(first, second, least):
    """Whether two shapes are so far apart; cuts both into parts."""
    todo = [(first, second)]
    while todo:
        pair = todo.pop()
        shapes = [(p[np.unique(parts)], radius, parts) for p, radius, parts in pair]
        n = direction(shapes[0][0].lo, shapes[1][0].lo, least + pair[0][1] + pair[1][1])
        if n is not None and apart(Interval(n), ([shapes[0]], [shapes[1]]), least):
            continue
        sizes = [np.ptp(p.lo, 0).max() if len(parts) > 1 else -1 for p, _, parts in shapes]
        if max(sizes) < 0:
            return False
        side = int(sizes[1] > sizes[0])
        p, radius, parts = pair[side]
        middles = p.lo[parts].mean(1)
        order = parts[np.argsort(middles[:, np.argmax(np.ptp(middles, 0))])]
        for half in (order[:len(order) // 2], order[len(order) // 2:]):
            todo.append(((p, radius, half), pair[1]) if side == 0 else (pair[0], (p, radius, half)))
    return True


def leaves(entry, ranges):
    """What closes each box of the tree, the box, and how many halvings have led to it."""
    names = [name for name, (lower, upper) in ranges.items() if lower < upper]
    if sorted(names) != sorted(entry['variables']):
        raise Refused('other joints move them: %s' % ', '.join(names))
    todo = [(ranges, 0)]
    for token in entry['tree']:
        if not todo:
            raise Refused('the tree is too long')
        box, halvings = todo.pop()
        if not isinstance(token, int):
            yield token, box, halvings
            continue
        name = entry['variables'][token]
        lower, upper = box[name]
        middle = (lower + upper) / 2
        if not (token >= 0 and lower < middle < upper):
            raise Refused('a box cannot be halved')
        todo += [({**box, name: ends}, halvings + 1)
                 for ends in ([middle, upper], [lower, middle])]
    if todo:
        raise Refused('the tree is too short')


def drawn(boxes, options):
    """Some boxes, or all; the last member of each says how many halvings have led to it. One box
    after the other, each as likely as its share of the ranges of the joints, which each halving
    halves: by times that are exponential with these shares as rates, the first ones."""
    def time(box):
        return math.log(random.expovariate(1) or sys.float_info.min) + box[-1] * math.log(2)
    return boxes if options.all else heapq.nsmallest(options.sample, boxes, key=time)


def check_pair(robot, entry, head, kinds, options):
    """How many boxes there are, and how many were checked."""
    distance, goal = entry['distance'], head['clearance']
    is_never = entry['verdict'] == 'NEVER'
    largest = sys.float_info.max if is_never else {
        'ALWAYS': goal + TOUCH, 'TOUCHING': max(goal, head['touching'])}[entry['verdict']]
    if not (goal >= 0 and (distance > goal or not is_never) and 0 <= distance <= largest):
        raise Refused('%g m is not %s' % (distance, entry['verdict']))
    pair = Pair(robot, entry, kinds)
    boxes = list(leaves(entry, pair.ranges))
    chosen = drawn(boxes, options)
    for leaf, box, _ in chosen:
        if not (pair.check if is_never else pair.touches)(leaf, box, distance):
            raise Refused('not proven around %s' % {k: sum(v) / 2 for k, v in box.items()})
    return len(boxes), len(chosen)
