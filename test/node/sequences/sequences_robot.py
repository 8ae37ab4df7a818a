# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random robots, mesh files and parameters, for the start of a seed and for its reloads."""
import math

from sequences_model import Element, Link

MESHES = ["ball.stl", "blob.stl", "plate.stl", "late.stl"]  # the last one is no mesh at first
GROUPS = {"arm": ["a", "b", "c"], "all": ["base", "p/*", "o/1"], "bad": ["d", "nobody"],
          "none": ["bare", "q/*"], "fences": ["fence", "fence/*"]}


def random_points(rng, name):
    """Three for each triangle. Many lie on the hull, so that the node makes look-up tables."""
    def point():
        while True:
            p = [rng.uniform(-1, 1) for _ in range(3)]
            length = math.sqrt(sum(c * c for c in p))
            if 0.1 < length < 1:
                break
        if name.startswith("ball"):
            return [c / length for c in p]
        if name.startswith("plate"):
            return [p[0], p[1], 0]
        return [p[0] / length * 0.7, p[1] / length * 0.2, p[2] / length + 0.3]
    return [point() for _ in range(3 * rng.choice([1, 30, 100]))]


def random_rpy(rng):
    return [rng.choice([0, math.pi / 2, rng.uniform(-3, 3)]) for _ in range(3)]


def random_xyz(rng, limit=1.0):
    return [rng.uniform(-limit, limit) for _ in range(3)]


def random_element(rng, meshes=tuple(MESHES) + ("missing.stl",)):
    kind = rng.choice(["box", "cylinder", "sphere", "mesh", "mesh"])
    size = [rng.choice([0, rng.uniform(0.1, 1), rng.uniform(0.1, 1)]) for _ in range(3)]
    mesh = rng.choice(meshes)
    if kind == "mesh":
        size = [rng.choice([1, 1, -1, rng.uniform(-2, 2)]) for _ in range(3)]
    xyz = rng.choice([None, [0, 0, 0], random_xyz(rng)])
    return Element(kind, size, mesh, xyz, random_rpy(rng))


def random_robot(rng):
    """Link `a` has two meshes, one with an origin of its own."""
    def mesh(name, **fields):
        return Element("mesh", (1, 1, 1), name, **fields)

    def some(count):
        return [random_element(rng) for _ in range(count)]
    return [Link("base", visual=some(2), collision=some(1)),
            Link("a", "base", False, [mesh("ball.stl"),
                                      mesh("blob.stl", xyz=random_xyz(rng), rpy=random_rpy(rng))],
                 some(1)),
            Link("b", "a", False, [mesh("ball.stl"), mesh("blob.stl")], some(2)),
            Link("c", "b", False, some(rng.randint(1, 3))),
            Link("d", "base", True, some(1), some(1)),
            Link("e", "d", False, [mesh("ball.stl")] + some(1), []),
            Link("g", "base", False, [Element("box", (0.2, 0.2, 0.2))], some(1)),
            Link("bare", "c", False),
            fence("fence"), fence("still_fence")]


def fence(name):
    box = Element("box", (0.01, 0.01, 0.01))
    return Link(name, "base", False, [box], [box])


def random_parameters(rng):
    """Parameters of the node; the links of the fences are always selected."""
    result = {}

    def maybe(name, share, value):
        if rng.random() < share:
            result[name] = value
    maybe("fixed_frame", 0.5, rng.choice(["base", "odom", "cam", "a", "/odom", "nowhere"]))
    maybe("geometry", 0.3, rng.choice(["collision", "both"]))
    maybe("links", 0.2, ["fence", "still_fence"] + rng.sample("abcdeg", 3))
    maybe("ignore_links", 0.2, rng.sample("abcdeg", 2))
    maybe("padding", 0.3, rng.choice([0.01, 0.5]))
    maybe("link_padding", 0.2, {"a": 0.1, "e": 0.0})
    maybe("groups", 0.5, {name: GROUPS[name] for name in rng.sample(sorted(GROUPS), 3)})
    maybe("timeout", 0.6, rng.choice([0.0, 0.7, 5.0]))
    maybe("overlap_margin", 0.3, rng.choice([0.1, 1.0]))
    maybe("ignore_pairs", 0.3, rng.choice([["a e", "o/1 b", "p/0 p/1"], ["* o/*", "p/* */*"]]))
    maybe("attached", 0.3, rng.choice([{"e": ["o/*"], "b": ["p/1", "p/0"]}, {"bare": ["p/*"]}]))
    maybe("adjacent_joints", 0.3, rng.choice([0, 2, 3]))
    maybe("parts_per_link", 0.3, rng.choice([2, 5]))
    maybe("max_rate", 0.1, 200.0)
    return result
