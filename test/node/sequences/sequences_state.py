# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the node must show at one moment: names, boxes, stamps, and what is incomplete."""
import numpy

IDENTICAL = 1e-9  # relative; a smaller difference of poses may be no news


class Entry:
    """A name with its box, if it has one."""

    def __init__(self, name, is_complete=False, bounds=None, pose=None, stamp=None):
        self.name, self.is_complete = name, is_complete
        self.pose, self.stamp = pose, stamp
        self.low = self.high = None
        if bounds is not None:
            self.low, self.high, self.magnitude = bounds

    def has_box(self):
        return self.low is not None

    def as_incomplete(self):
        bounds = (self.low, self.high, self.magnitude) if self.has_box() else None
        return Entry(self.name, False, bounds, self.pose, self.stamp)

    def is_news(self, other):
        """True if the node must publish the change from the other entry to this one."""
        if (self.name, self.is_complete, self.has_box(), self.stamp) != (
                other.name, other.is_complete, other.has_box(), other.stamp):
            return True
        return self.has_box() and (
            differs(self.low, other.low) or differs(self.high, other.high) or
            differs(self.pose.rotation, other.pose.rotation) or
            differs(self.pose.translation, other.pose.translation))


def differs(a, b):
    return bool((numpy.abs(a - b) > IDENTICAL * (1 + numpy.abs(a))).any())


def bounds_of(shapes, pose, padding=0.0):
    """Minimum, maximum, and the size of the numbers that were added; None if not finite."""
    if pose is None or not pose.is_finite():
        return None
    with numpy.errstate(all="ignore"):
        each = [shape.extents(pose.rotation, pose.translation) for shape in shapes]
    low = numpy.min([low for low, _, _ in each], axis=0) - padding
    high = numpy.max([high for _, high, _ in each], axis=0) + padding
    magnitude = pose.magnitude + padding + max(m for _, _, m in each)
    if not numpy.isfinite(low).all() or not numpy.isfinite(high).all():
        return None
    return low, high, magnitude


class State:
    """The source of one message of each topic."""

    def __init__(self, model, entries):
        self.model, self.entries = model, entries

    def is_news(self, other):
        return len(self.entries) != len(other.entries) or self.model is not other.model or any(
            a.is_news(b) for a, b in zip(self.entries, other.entries))

    def with_incomplete(self, name):
        """The same with one more name, which has no box."""
        return State(self.model, self.entries + [Entry(name)])
