# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The oracle of ~overlaps: checks all pairs of published boxes."""
import itertools
import math
import re
from xml.etree import ElementTree

TOLERANCE = 1e-12  # m; both sides start from the same published boxes
AXES = ("x", "y", "z")


def distance(a, b):
    gaps = [max(getattr(a.min, k) - getattr(b.max, k), getattr(b.min, k) - getattr(a.max, k))
            for k in AXES]
    if max(gaps) <= 0:
        return max(gaps)
    return math.sqrt(sum(max(gap, 0) ** 2 for gap in gaps))


def pairs_of(message):
    return [(overlap.first, overlap.second) for overlap in message.overlaps]


def joined_links(urdf, max_joints=1):
    """Pairs of links with at most `max_joints` movable joints between them."""
    root = ElementTree.fromstring(urdf)
    body = {link.get("name"): link.get("name") for link in root.findall("link")}
    joints = [(joint.find("parent").get("link"), joint.find("child").get("link"), joint.get("type"))
              for joint in root.findall("joint")]
    for parent, child, kind in joints:
        if kind == "fixed":
            old, new = body[child], body[parent]
            body.update({link: new for link, name_of_body in body.items() if name_of_body == old})
    near = {(one, one) for one in body.values()}
    for _ in range(max_joints):
        near |= {(a, after) for a, b in near for parent, child, _ in joints
                 for before, after in ((body[parent], body[child]), (body[child], body[parent]))
                 if b == before}
    return {(a, b) for a, b in itertools.product(body, body) if (body[a], body[b]) in near}


def pairs_that_fit(names, first, second):
    """Those of two names of which each fits one of two patterns; * is any text without a slash."""
    fits_first, fits_second = (
        re.compile("[^/]*".join(map(re.escape, pattern.split("*"))), re.DOTALL).fullmatch
        for pattern in (first, second))
    return {(a, b) for a, b in itertools.product(names, names)
            if fits_first(a) and fits_second(b) or fits_first(b) and fits_second(a)}


def expected(boxes, margin, ignored):
    """Names and distance of all pairs, in order."""
    return [(a.name, b.name, distance(a, b)) for a, b in itertools.combinations(boxes.boxes, 2)
            if (a.name, b.name) not in ignored and distance(a, b) <= margin]


def agree(message, wanted):
    return pairs_of(message) == [pair[:2] for pair in wanted] and all(
        abs(found.distance - depth) < TOLERANCE
        for found, (_, _, depth) in zip(message.overlaps, wanted))
