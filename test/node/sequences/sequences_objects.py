# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The oracle of objects: what doc/scene.md says of markers. Times in ns."""
import math
import os

from sequences_shapes import marker_shapes
from sequences_state import Entry, bounds_of
from sequences_tf import HISTORY, SECOND, to_time
from visualization_msgs.msg import Marker

GIVEN_UP_AFTER = 10  # s of the clock, where timeout is 0
LARGEST = 1e29
FAR_AHEAD = SECOND // 2
COUNTS = {Marker.ARROW: lambda n: n in (0, 2), Marker.LINE_STRIP: lambda n: n >= 2,
          Marker.LINE_LIST: lambda n: n > 0 and n % 2 == 0,
          Marker.TRIANGLE_LIST: lambda n: n > 0 and n % 3 == 0,
          Marker.CUBE_LIST: lambda n: n > 0, Marker.SPHERE_LIST: lambda n: n > 0,
          Marker.POINTS: lambda n: n > 0}


def is_refused(marker):
    p, q, s = marker.pose.position, marker.pose.orientation, marker.scale
    numbers = [p.x, p.y, p.z, s.x, s.y, s.z]
    if marker.type in COUNTS:
        numbers += [c for point in marker.points for c in (point.x, point.y, point.z)]
    return (marker.action != Marker.ADD or not 0 <= marker.type <= Marker.TRIANGLE_LIST or
            marker.header.frame_id in ("", "/") or not all(abs(n) <= LARGEST for n in numbers) or
            not all(map(math.isfinite, (q.x, q.y, q.z, q.w))) or min(s.x, s.y, s.z) < 0 or
            not COUNTS.get(marker.type, lambda _: True)(len(marker.points)) or
            marker.type == Marker.MESH_RESOURCE and not marker.mesh_resource)


def content_of(marker):
    """All fields that change the box, as text."""
    stamp = to_time(0) if marker.frame_locked else marker.header.stamp
    return repr((marker.type, marker.action, marker.header.frame_id, stamp, marker.pose,
                 marker.scale, marker.points, marker.mesh_resource))


class Object:
    """A marker, and the entry that the object had before it."""

    def __init__(self, marker, now, before):
        self.marker, self.content = marker, content_of(marker)
        self.is_refused = is_refused(marker)
        self.frame = marker.header.frame_id.lstrip("/")
        self.stamp = 0 if marker.frame_locked else marker.header.stamp.to_nsec()
        self.shown_stamp = self.stamp
        self.received = self.waits_since = now
        self.before = before  # is shown until this marker can be placed
        self.placed = None  # where the object is placed once: the fixed frame, and the pose in it
        self.is_of_this_time = True  # the clock has been at the stamp since it last jumped back
        self.is_from_before = False  # a jump back: until it is sent again, only static tf places it
        self.is_placed_anew = False  # as soon as tf has the stamp: it was sent again after a jump
        self.is_given_up = False
        self.points = None  # of the mesh file, when it has been read
        self.is_loading = marker.type == Marker.MESH_RESOURCE and not self.is_refused
        self.is_read_again = False  # its mesh file was replaced; the points are those of the old one

    def mesh(self):
        return self.marker.mesh_resource if self.marker.type == Marker.MESH_RESOURCE else ""

    def has_no_mesh(self):
        return bool(self.mesh()) and self.points is None

    def waits(self):
        return not (self.is_refused or self.is_loading or self.has_no_mesh() or self.stamp == 0 or
                    self.is_given_up) and (self.is_placed_anew or not self.placed)

    def place(self, fixed_frame, pose):
        if self.placed:
            self.shown_stamp = self.stamp
        self.placed = fixed_frame, pose
        self.is_placed_anew = False

    def give_up(self):
        """What has a place stays there, until it is sent again once more."""
        if self.placed:
            self.is_placed_anew = self.is_of_this_time = False
        else:
            self.is_given_up = True

    def elapsed(self, now):
        """How much of the lifetime is over."""
        return min(now - self.received, max(self.marker.lifetime.to_nsec(), 0))

    def is_over(self, now):
        return 0 < self.marker.lifetime.to_nsec() == self.elapsed(now)


class Objects:
    def __init__(self, oracle):
        self._oracle = oracle
        self._objects = {}  # by namespace and number
        self._carries = {}  # poses of earlier fixed frames in this one; they stay once found
        self._newest_past = 0  # the newest time before the clock jumped back
        self._jump = None  # to which time the clock last jumped back

    def take(self, marker):
        key = (marker.ns, marker.id)
        if marker.action == Marker.DELETEALL:
            self._objects.clear()
        elif marker.ns.startswith("link_bounds/"):
            pass
        elif marker.action == Marker.DELETE or (marker.action == Marker.ADD and
                                                marker.type == Marker.TEXT_VIEW_FACING):
            self._objects.pop(key, None)
        else:
            self._put(key, marker)

    def _put(self, key, marker):
        now = self._oracle.now
        old = self._objects.get(key)
        if old and not old.is_given_up and old.content == content_of(marker):
            old.marker.lifetime = marker.lifetime
            old.received = old.waits_since = now
            if not old.is_of_this_time and self._has_reached(old.stamp):
                self._send_again(key, old)
            return
        thing = Object(marker, now, self._entry(key, old) if old else None)
        thing.is_of_this_time = self._has_reached(thing.stamp)
        if now + FAR_AHEAD < thing.stamp <= self._newest_past:
            thing.shown_stamp = now
        self._objects[key] = thing
        self.settle()

    def _has_reached(self, stamp):
        """Whether the clock has been at a stamp since it last jumped back."""
        return self._jump is None or self._jump <= stamp <= self._oracle.now + FAR_AHEAD

    def _send_again(self, key, thing):
        """The stamp may be of the time since the jump back: tf of that time places the object."""
        if thing.placed:
            thing.before = self._entry(key, thing)
            thing.is_placed_anew = True
        else:
            thing.shown_stamp = thing.stamp
        thing.is_of_this_time, thing.is_from_before = True, False
        self.settle()

    def meshes(self):
        """In the order in which a reload reads them."""
        return sorted({o.mesh() for o in self._objects.values() if not o.is_refused} - {""})

    def on_mesh(self, uri, points):
        for thing in self._objects.values():
            if thing.mesh() == uri and not thing.is_refused:
                thing.points, thing.is_loading, thing.is_read_again = points, False, False
                thing.before = None if points is None else thing.before
        self.settle()

    def settle(self):
        """Places what can be placed now."""
        fixed_frame = self._oracle.model.fixed_frame
        for thing in filter(Object.waits, self._objects.values()):
            pose = self._pose_at_stamp(thing)
            if pose:
                thing.place(fixed_frame, pose)
            elif thing.is_placed_anew and self._oracle.now - thing.stamp > HISTORY:
                thing.give_up()  # tf keeps no such stamp
        for frame in [frame for frame, carry in self._carries.items() if carry is None]:
            carry = self._oracle.pose(frame)
            self._carries[frame] = carry if carry and carry.is_finite() else None

    def _pose_at_stamp(self, thing):
        """Of what was sent before a jump back, tf of the new time tells only what is static."""
        fixed_frame, tf = self._oracle.model.fixed_frame, self._oracle.tf
        if thing.is_from_before and tf.oldest_receipt(fixed_frame, thing.frame) is not None:
            return None
        return tf.at(fixed_frame, thing.frame, thing.stamp)

    def expire(self):
        now = self._oracle.now
        patience = round((self._oracle.model.timeout or GIVEN_UP_AFTER) * SECOND)
        self._objects = {key: o for key, o in self._objects.items() if not o.is_over(now)}
        self.settle()
        for thing in self._objects.values():
            if thing.waits() and now - thing.waits_since > patience:
                thing.give_up()

    def on_jump_back(self, past):
        """The rest of each lifetime stays the same, and no stamp stays ahead of the clock. What
        waits is not placed before it is sent again."""
        now = self._jump = self._oracle.now
        self._newest_past = max(self._newest_past, past)
        for thing in self._objects.values():
            thing.received = now - thing.elapsed(past)
            thing.waits_since = now
            thing.shown_stamp = min(thing.shown_stamp, now)
            thing.is_of_this_time = thing.is_placed_anew = False
            thing.is_from_before = True
            if thing.before and thing.before.has_box():
                thing.before.stamp = min(thing.before.stamp, now)
        self.settle()

    def on_reload(self, old_model, files):
        """Objects of `files`, which were replaced, keep their boxes and are incomplete until the new
        ones are read."""
        fixed_frame = self._oracle.model.fixed_frame
        if fixed_frame != old_model.fixed_frame:
            self._carries = {o.placed[0]: None for o in self._objects.values() if o.placed}
            self._carries.pop(fixed_frame, None)
            for thing in self._objects.values():
                thing.before, thing.is_given_up = None, False
        for thing in self._objects.values():
            thing.waits_since = self._oracle.now
            thing.is_read_again = (os.path.basename(thing.mesh()) in files and
                                   thing.points is not None)
        self.settle()

    def _pose(self, thing):
        """The pose in the fixed frame; None if there is none."""
        if not thing.stamp:
            return self._oracle.pose(thing.frame)
        frame, pose = thing.placed
        if frame == self._oracle.model.fixed_frame:
            return pose
        return self._carries[frame] and self._carries[frame].of(pose)

    def entries(self):
        return [self._entry(key, thing) for key, thing in sorted(self._objects.items())]

    def _entry(self, key, thing):
        name = "%s/%d" % key
        if thing.is_refused:
            return Entry(name)
        waits = thing.is_loading or thing.waits()
        if waits and thing.before and thing.before.has_box():
            return thing.before.as_incomplete()
        if thing.has_no_mesh() or thing.is_given_up or waits and not thing.placed:
            return Entry(name)
        pose = self._pose(thing)
        bounds = bounds_of(marker_shapes(thing.marker, thing.points), pose)
        if bounds is None:
            return Entry(name)
        is_complete = not (waits or thing.is_read_again)
        return Entry(name, is_complete, bounds, pose, thing.shown_stamp or pose.stamp)
