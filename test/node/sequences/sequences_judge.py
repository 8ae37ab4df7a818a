# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares messages with their expected content. Functions return the fault as text, or ""."""
import numpy
from overlap_testing import pairs_that_fit

TOO_SMALL = 4e-14  # relative to the numbers that are added: rounding by numpy and tf2
TOO_LARGE = 1e-12  # relative to the same numbers, besides SLACK
SLACK = 1e-9  # m


def corners(box):
    return (numpy.array([box.min.x, box.min.y, box.min.z]),
            numpy.array([box.max.x, box.max.y, box.max.z]))


def wrong_boxes(message, state):
    """Judges ~boxes."""
    shown = [entry for entry in state.entries if entry.has_box()]
    incomplete = [entry.name for entry in state.entries if not entry.is_complete]
    newest = max((entry.stamp for entry in shown), default=0)
    if message.header.frame_id != state.model.fixed_frame:
        return "frame %r instead of %r" % (message.header.frame_id, state.model.fixed_frame)
    if [box.name for box in message.boxes] != [entry.name for entry in shown]:
        return "boxes %s instead of %s" % ([b.name for b in message.boxes], [e.name for e in shown])
    if message.incomplete != incomplete:
        return "incomplete %s instead of %s" % (message.incomplete, incomplete)
    wrong = next(filter(None, map(wrong_box, message.boxes, shown)), "")
    if not wrong and message.header.stamp.to_nsec() != newest:
        return "header stamp %d instead of %d" % (message.header.stamp.to_nsec(), newest)
    return wrong


def wrong_box(box, entry):
    if box.stamp.to_nsec() != entry.stamp:
        return "%s: stamp %d instead of %d" % (box.name, box.stamp.to_nsec(), entry.stamp)
    low, high = corners(box)
    lacks = max((low - entry.low).max(), (entry.high - high).max())
    exceeds = max((entry.low - low).max(), (high - entry.high).max())
    if not lacks <= TOO_SMALL * entry.magnitude:
        return "%s: TOO SMALL by %g m: %s %s instead of %s %s" % (
            box.name, lacks, low, high, entry.low, entry.high)
    if not exceeds <= SLACK + TOO_LARGE * entry.magnitude:
        return "%s: too large by %g m: %s %s instead of %s %s" % (
            box.name, exceeds, low, high, entry.low, entry.high)
    return ""


def group_members(members, boxes, model):
    """The names that the members of a group stand for; None for a member that does not exist."""
    links = {link.name for link in model.links}
    names = []
    for member in members:
        if member in links:
            names.append(member)
        elif member in model.without_geometry:
            continue
        elif member.endswith("/*"):
            everything = [box.name for box in boxes.boxes] + boxes.incomplete
            names += [name for name in everything
                      if name not in links and name.rpartition("/")[0] == member[:-2]]
        else:
            names.append(member if "/" in member else None)
    return names


def wrong_groups(message, boxes, model):
    """Judges ~groups by the ~boxes that were published with it."""
    groups = [("robot", [link.name for link in model.links])]
    groups += sorted(model.parameters["groups"].items())
    by_name = {box.name: box for box in boxes.boxes}
    expected, incomplete = [], []
    for name, members in groups:
        names = group_members(members, boxes, model)
        if any(n not in by_name or n in boxes.incomplete for n in names):
            incomplete.append(name)
        present = [by_name[n] for n in names if n in by_name]
        if present:
            low, high = zip(*map(corners, present))
            stamp = min((b.stamp.to_nsec() for b in present if b.stamp.to_nsec()), default=0)
            expected.append((name, stamp, *numpy.min(low, axis=0), *numpy.max(high, axis=0)))
    got = [(b.name, b.stamp.to_nsec(), *corners(b)[0], *corners(b)[1]) for b in message.boxes]
    if got != expected or message.incomplete != incomplete:
        return "groups %s, incomplete %s instead of %s, %s" % (
            got, message.incomplete, expected, incomplete)
    newest = max((stamp for _, stamp, *_ in expected), default=0)
    if (message.header.frame_id, message.header.stamp.to_nsec()) != (model.fixed_frame, newest):
        return "header of groups: %s" % message.header
    return ""


def wrong_overlaps(message, boxes, model):
    """Judges ~overlaps by the ~boxes that were published with it."""
    if (message.header.frame_id, message.header.stamp) != (
            boxes.header.frame_id, boxes.header.stamp):
        return "header of overlaps: %s instead of %s" % (message.header, boxes.header)
    names = [box.name for box in boxes.boxes]
    ignored = set().union(*(pairs_that_fit(names, *pair.split())
                            for pair in model.parameters["ignore_pairs"]))
    expected = []
    for i, first in enumerate(boxes.boxes):
        for second in boxes.boxes[i + 1:]:
            distance = box_distance(corners(first), corners(second))
            if (distance <= model.parameters["overlap_margin"] and
                    (first.name, second.name) not in ignored and
                    not model.are_joined(first.name, second.name)):
                expected.append((first.name, second.name, distance))
    got = [(o.first, o.second, o.distance) for o in message.overlaps]
    if [pair[:2] for pair in got] != [pair[:2] for pair in expected]:
        return "overlaps %s instead of %s" % (got, expected)
    wrong = [(a, b) for a, b in zip(got, expected) if abs(a[2] - b[2]) > 1e-14 * (1 + abs(b[2]))]
    return "distances %s" % wrong if wrong else ""


def box_distance(a, b):
    gaps = numpy.maximum(a[0] - b[1], b[0] - a[1])
    return gaps.max() if gaps.max() <= 0 else numpy.linalg.norm(numpy.maximum(gaps, 0))


def wrong_parts(message, boxes):
    """Judges ~parts: the parts of a link together have the box of the link."""
    parts = {}
    for box in message.boxes:
        parts.setdefault(box.name, []).append(corners(box))
    for box in boxes.boxes:
        if box.name not in parts:
            continue
        low, high = (f([part[i] for part in parts[box.name]], axis=0)
                     for i, f in ((0, numpy.min), (1, numpy.max)))
        scale = numpy.abs(corners(box)).max()
        if numpy.abs((low, high) - numpy.array(corners(box))).max() > 1e-9 + 1e-12 * scale:
            return "parts of %s: %s %s, but its box is %s" % (box.name, low, high, corners(box))
    return ""


def footprint(groups):
    """The corners that ~footprint must have, rounded outward to float32; None if there is none."""
    robot = next((box for box in groups.boxes if box.name == "robot"), None)
    if robot is None or "robot" in groups.incomplete:
        return None
    low = [rounded(c, -1) for c in corners(robot)[0][:2]]
    high = [rounded(c, 1) for c in corners(robot)[1][:2]]
    if not numpy.isfinite(low + high).all():
        return None
    return [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]


def rounded(value, direction):
    with numpy.errstate(over="ignore"):
        result = numpy.float32(value)
    if (float(result) - value) * direction < 0:
        result = numpy.nextafter(result, numpy.float32(direction * numpy.inf))
    return float(result)


def wrong_footprint(message, groups):
    got = [(point.x, point.y) for point in message.points]
    expected = footprint(groups)
    return "" if got == expected else "footprint %s instead of %s" % (got, expected)
