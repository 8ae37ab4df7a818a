# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""STL files."""
import random
import struct


def binary_stl(triangles):
    """The bytes of a file of these triangles, which are three corners each."""
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) for a, b, c in triangles)


def random_mesh(path, seed, vertices=400, size=None):
    """Writes points on an ellipsoid of these half axes, or of random ones: all can be extreme."""
    dice = random.Random(seed)
    size = size or [dice.uniform(0.03, 0.15) for _ in range(3)]
    points = []
    while len(points) < vertices:
        direction = [dice.gauss(0, 1) for _ in range(3)]
        length = sum(x * x for x in direction) ** 0.5
        points.append([s * x / length for s, x in zip(size, direction)])
    with open(path, "wb") as file:
        file.write(binary_stl(list(zip(points, points[1:], points[2:]))))
