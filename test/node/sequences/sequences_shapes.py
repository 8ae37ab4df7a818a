# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes the slow way: turns every point, and bounds solids by textbook formulas. Lengths in m."""
import itertools
import struct

import numpy
from visualization_msgs.msg import Marker

IDENTITY = numpy.eye(3)
ZERO = numpy.zeros(3)


def rotation_matrix(xyzw):
    """The rotation of a quaternion of any length but zero."""
    x, y, z, w = numpy.array(xyzw, dtype=float) / numpy.linalg.norm(xyzw)
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def rpy_matrix(rpy):
    """URDF's roll, pitch and yaw about fixed axes."""
    (a, b, c), (s, t, u) = numpy.cos(rpy), numpy.sin(rpy)
    roll = numpy.array([[1, 0, 0], [0, a, -s], [0, s, a]])
    pitch = numpy.array([[b, 0, t], [0, 1, 0], [-t, 0, b]])
    yaw = numpy.array([[c, -u, 0], [u, c, 0], [0, 0, 1]])
    return yaw @ pitch @ roll


class Shape:
    """Points, each with a solid around it: "none", "box", "ellipsoid" or "cylinder"."""

    def __init__(self, points=None, solid="none", size=(0, 0, 0), linear=IDENTITY, offset=ZERO):
        self.points = numpy.zeros((1, 3)) if points is None else numpy.array(points, dtype=float)
        self.solid, self.size = solid, numpy.array(size, dtype=float)
        self.linear, self.offset = linear, numpy.array(offset, dtype=float)

    def extents(self, rotation, translation):
        """Minimum and maximum at a pose, and the size of the numbers that were added."""
        linear = rotation @ self.linear
        offset = rotation @ self.offset
        moved = self.points @ linear.T
        half = half_extents(self.solid, linear * self.size)
        magnitude = (numpy.abs(self.points).max() * numpy.abs(linear).sum() + half.max() +
                     numpy.abs(self.offset).sum())
        return (moved.min(axis=0) - half + offset + translation,
                moved.max(axis=0) + half + offset + translation, magnitude)


def half_extents(solid, axes):
    """Half the extents of a solid; the columns of `axes` are its full diameters."""
    if solid == "box":
        corners = numpy.array(list(itertools.product((-0.5, 0.5), repeat=3)))
        return (corners @ axes.T).max(axis=0)
    if solid == "ellipsoid":
        return numpy.sqrt((axes ** 2).sum(axis=1)) / 2
    if solid == "cylinder":
        return (numpy.sqrt((axes[:, :2] ** 2).sum(axis=1)) + numpy.abs(axes[:, 2])) / 2
    return ZERO


def disc(center, normal, diameter):
    """A flat cylinder; of the normal only the direction counts."""
    normal = numpy.array(normal, dtype=float) / numpy.linalg.norm(normal)
    first = numpy.cross(normal, IDENTITY[numpy.abs(normal).argmin()])
    first /= numpy.linalg.norm(first)
    axes = numpy.column_stack([first, numpy.cross(normal, first), normal])
    return Shape(None, "cylinder", (diameter, diameter, 0), axes, center)


def arrow(marker, points, scale):
    """In the frame of the marker's pose."""
    if not len(points):
        neck = (0.77 * scale[0], 0, 0)
        return [Shape(None, "ellipsoid", (0, scale[1], scale[2])),
                Shape(None, "ellipsoid", (0, 2 * scale[1], 2 * scale[2]), IDENTITY, neck),
                Shape([(scale[0], 0, 0)])]
    tail, tip = points
    length = numpy.linalg.norm(tip - tail)
    direction = (tip - tail) / length
    neck = tip - direction * (min(scale[2], length) if scale[2] else 0.23 * length)
    return [disc(tail, direction, scale[0]), disc(neck, direction, scale[0]),
            disc(neck, direction, scale[1]), Shape([tip])]


def unplaced_marker_shapes(marker, mesh_points):
    """In the frame of the marker's pose."""
    scale = numpy.array([marker.scale.x, marker.scale.y, marker.scale.z])
    points = numpy.array([(p.x, p.y, p.z) for p in marker.points])
    if marker.type == Marker.ARROW:
        return arrow(marker, points, scale)
    if marker.type == Marker.MESH_RESOURCE:
        return [Shape(mesh_points * scale)]
    if marker.type == Marker.TRIANGLE_LIST:
        return [Shape(points * scale)]
    if marker.type in (Marker.LINE_STRIP, Marker.LINE_LIST):
        return [Shape(points, "ellipsoid", [scale[0]] * 3)]
    if marker.type == Marker.POINTS:
        return [Shape(points, "ellipsoid", [numpy.linalg.norm(scale[:2])] * 3)]
    solid = {Marker.CUBE: "box", Marker.CUBE_LIST: "box", Marker.SPHERE: "ellipsoid",
             Marker.SPHERE_LIST: "ellipsoid", Marker.CYLINDER: "cylinder"}[marker.type]
    is_list = marker.type in (Marker.CUBE_LIST, Marker.SPHERE_LIST)
    return [Shape(points if is_list else None, solid, scale)]


def marker_shapes(marker, mesh_points=None):
    """What a marker draws, in the frame of its header."""
    q, p = marker.pose.orientation, marker.pose.position
    xyzw = (q.x, q.y, q.z, q.w)
    rotation = rotation_matrix(xyzw) if any(xyzw) else IDENTITY
    shapes = unplaced_marker_shapes(marker, mesh_points)
    for shape in shapes:
        shape.offset = rotation @ shape.offset + (p.x, p.y, p.z)
        shape.linear = rotation @ shape.linear
    return shapes


def stl(points):
    """A binary STL file with a triangle of each three points."""
    triangles = numpy.array(points, dtype="<f4").reshape(-1, 9)
    facets = (struct.pack("<3f", 0, 0, 1) + row.tobytes() + b"\0\0" for row in triangles)
    return b"sequences".ljust(80) + struct.pack("<I", len(triangles)) + b"".join(facets)
