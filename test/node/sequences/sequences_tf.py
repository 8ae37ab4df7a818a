# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The oracle of tf: poses from tf2's own buffer, and when each edge got its newest stamp. Times in ns."""
import bisect
import math

import numpy
import rospy
import tf2_py
from sequences_shapes import rotation_matrix

numpy.seterr(all="ignore")  # some poses are not finite on purpose
SECOND = 10 ** 9
HISTORY = 10 * SECOND
LAST_SECOND = 2 ** 32 - 12  # tf2 adds its history to a stamp, in 32 bits
FAILURES = (tf2_py.LookupException, tf2_py.ConnectivityException, tf2_py.ExtrapolationException,
            tf2_py.InvalidArgumentException, tf2_py.TransformException)


def to_time(nanoseconds):
    return rospy.Time(*divmod(nanoseconds, SECOND))


def vector_of(transform):
    t = transform.transform.translation
    return numpy.array([t.x, t.y, t.z])


def quaternion_of(transform):
    q = transform.transform.rotation
    return numpy.array([q.x, q.y, q.z, q.w])


def is_usable(transform):
    """Whether tf2 accepts the transform; names are compared as they are."""
    q, t = quaternion_of(transform), vector_of(transform)
    stamp = transform.header.stamp
    if math.isnan(sum(abs(q)) + sum(abs(t))) or not abs(sum(q * q) - 1) < 0.01:
        return False
    if not transform.child_frame_id or not transform.header.frame_id:
        return False
    return (transform.child_frame_id != transform.header.frame_id and
            stamp.secs <= LAST_SECOND and 0 <= stamp.nsecs < SECOND)


def product(a, b):
    """Of two quaternions x, y, z, w."""
    return numpy.append(a[3] * b[:3] + b[3] * a[:3] + numpy.cross(a[:3], b[:3]),
                        a[3] * b[3] - a[:3] @ b[:3])


def conjugate(q):
    return q * (-1, -1, -1, 1)


def turned(q, v):
    """The vector v turned as tf2 does it: a quaternion whose length is not 1 scales it, too."""
    return product(product(q, numpy.append(v, 0)), conjugate(q))[:3]


def composed(a, b):
    """Poses are pairs of a quaternion and a translation."""
    return product(a[0], b[0]), turned(a[0], b[1]) + a[1]


def inverse(a):
    return conjugate(a[0]), turned(conjugate(a[0]), -a[1])


def meeting_of(target, way, other):
    """The frame where the way up from a source meets the target or the target's way up."""
    return target if target in way else next((frame for frame in way if frame in other), None)


class Pose:
    """The pose of a frame in another one."""

    def __init__(self, rotation, translation, stamp, magnitude):
        self.rotation, self.translation = rotation, translation
        self.stamp = stamp
        self.magnitude = magnitude  # of the translations that were added up [m]

    def of(self, pose):
        """Changes the frame of a pose that is given in this frame."""
        return Pose(self.rotation @ pose.rotation, self.rotation @ pose.translation +
                    self.translation, self.stamp, self.magnitude + pose.magnitude)

    def is_finite(self):
        return bool(numpy.isfinite(self.rotation).all() and numpy.isfinite(self.translation).all())


class Edge:
    """What tf keeps of one child frame."""

    def __init__(self, is_static):
        self.is_static = is_static
        self.samples = {}  # by stamp
        self.received = None
        self.is_distrusted = False
        self._stamps = []

    @property
    def newest(self):
        return self._stamps[-1] if self._stamps else 0

    def accepts(self, stamp):
        return self.is_static or not self._stamps or (
            stamp >= self.newest - HISTORY and stamp not in self.samples)

    def has_pose_at(self, stamp):
        """True if there is a pose at a time, 0 for the newest."""
        return bool(self._stamps) and (self.is_static or stamp == 0 or
                                       self._stamps[0] <= stamp <= self.newest)

    def is_too_old(self, stamp):
        return bool(self._stamps) and stamp < self.newest - HISTORY

    def add(self, stamp, transform):
        if self.is_static:
            self.samples = {0: transform}
        else:
            self.samples[stamp] = transform
            self.samples = {s: t for s, t in self.samples.items()
                            if s >= max(self.samples) - HISTORY}
        self._stamps = sorted(self.samples)

    def clear(self):
        self.samples, self._stamps = {}, []

    def neighbours(self, stamp):
        """The sample before or at a time, then those that may be interpolated with it."""
        place = max(bisect.bisect_right(self._stamps, stamp), 1)
        return [self.samples[s] for s in self._stamps[place - 1:place + 1]]

    def parent(self):
        return self.samples[self.newest].header.frame_id if self.samples else None


class TfOracle:
    """Accepts what the node accepts. To forget an edge it makes a new buffer."""

    def __init__(self):
        self._buffer = tf2_py.BufferCore(rospy.Duration(10))
        self._edges = {}

    def add(self, transforms, is_static, now):
        for transform in transforms:
            if is_usable(transform):
                self._add(transform, is_static, now)

    def _add(self, transform, is_static, now):
        child, stamp = transform.child_frame_id, transform.header.stamp.to_nsec()
        edge = self._edges.setdefault(child, Edge(is_static))
        if not edge.accepts(stamp):
            if not edge.is_distrusted or not edge.is_too_old(stamp):
                return
            edge.clear()
            self._rebuild()
        edge.add(stamp, transform)
        edge.is_distrusted = False
        if edge.is_static or stamp == edge.newest:
            edge.received = now
        self._insert(transform, edge)

    def _insert(self, transform, edge):
        insert = self._buffer.set_transform_static if edge.is_static else self._buffer.set_transform
        insert(transform, "sequences")

    def _rebuild(self):
        self._buffer = tf2_py.BufferCore(rospy.Duration(10))
        for edge in self._edges.values():
            for _, transform in sorted(edge.samples.items()):
                self._insert(transform, edge)

    def clear(self):
        """Static edges stay."""
        self._buffer.clear()
        for edge in self._edges.values():
            if not edge.is_static:
                edge.clear()

    def distrust_stamps_ahead(self, now):
        for edge in self._edges.values():
            edge.is_distrusted = not edge.is_static and edge.newest > now + HISTORY

    def latest(self, target, source):
        """At the latest common time; None if tf2 has no pose."""
        return self.at(target, source, 0)

    def at(self, target, source, stamp):
        """At a time, 0 for the latest common one; None if tf2 has no pose."""
        try:
            found = self._buffer.lookup_transform_core(target, source, to_time(stamp))
        except FAILURES:
            return None
        stamp = found.header.stamp.to_nsec()
        (quaternion, translation), magnitude = self._composed(target, source, stamp)
        rotation = numpy.full((3, 3), numpy.nan)
        if numpy.isfinite(quaternion).all():
            rotation = rotation_matrix(quaternion)
        return Pose(rotation, translation, stamp, magnitude)

    def _composed(self, target, source, stamp):
        """The pose through the frame where both ways up meet, and the size of the numbers that were
        added. tf2 goes on to the root and back. That makes a difference only where a pose above the
        meeting frame is not finite, or its quaternion has not length 1."""
        ups = [{frame: (pose, size) for frame, pose, size in self._climb(start, stamp)}
               for start in (source, target)]
        meeting = meeting_of(target, *ups)
        (meeting_from_source, size), (meeting_from_target, other) = (up[meeting] for up in ups)
        if meeting == target:
            return meeting_from_source, size
        return composed(inverse(meeting_from_target), meeting_from_source), size + other

    def _climb(self, frame, stamp):
        """Frames from this one to the root, as they were at a time; each with the pose there."""
        pose, size = (numpy.array([0, 0, 0, 1.0]), numpy.zeros(3)), 0.0
        seen = set()
        while frame not in seen:
            yield frame, pose, size
            seen.add(frame)
            edge = self._edges.get(frame)
            if edge is None or not edge.has_pose_at(stamp):
                return
            samples = edge.neighbours(stamp or edge.newest)
            parent = samples[0].header.frame_id
            step = self._buffer.lookup_transform_core(parent, frame, to_time(stamp))
            pose = composed((quaternion_of(step), vector_of(step)), pose)
            size += max(numpy.abs(vector_of(sample)).sum() for sample in samples)
            frame = parent

    def oldest_receipt(self, target, source):
        """When the edge whose newest stamp is the oldest receipt got it; None if all are static."""
        ups = [self._way_up(frame) for frame in (source, target)]
        meeting = meeting_of(target, *ups)
        path = [frame for up in ups if meeting for frame in up[:up.index(meeting)]]
        edges = [self._edges[frame] for frame in path]
        return min((edge.received for edge in edges if not edge.is_static), default=None)

    def _way_up(self, frame):
        """Frames from this one to the root, by the newest parents."""
        way = []
        while frame is not None and frame not in way:
            way.append(frame)
            frame = self._edges[frame].parent() if frame in self._edges else None
        return way
