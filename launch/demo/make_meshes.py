#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the mesh files of the demo robot, or checks that those on disk are the ones it writes.

Every part is a loft: closed rings stacked along z, joined by triangles and capped at both ends.
The files differ in format and unit on purpose, so that the demo shows each case once.
"""

import argparse
import math
import pathlib
import sys
from typing import NamedTuple

sys.dont_write_bytecode = True  # this folder is installed as it is

from mesh_formats import (Mesh, ascii_stl, binary_stl, collada,  # noqa: E402
                          wavefront_mtl, wavefront_obj)

MESHES = pathlib.Path(__file__).resolve().parent / 'meshes'


class Station(NamedTuple):
    """One ring of a loft: its height, its half widths, and where its centre is."""
    z: float
    half_x: float
    half_y: float
    x: float = 0.0
    y: float = 0.0


# Shapes. Metres, but for the upper arm (millimetres) and the shoulder (centimetres).

def pedestal():
    """A round foot that narrows to a neck and widens again to carry the shoulder."""
    return lathe([(0.000, 0.190), (0.016, 0.190), (0.030, 0.178), (0.060, 0.140), (0.120, 0.108),
                  (0.200, 0.100), (0.262, 0.110), (0.278, 0.122), (0.300, 0.122)], corners=36)


def shoulder_dome():
    """The turning body below the shoulder axis, in centimetres."""
    return lathe([(0.0, 11.4), (1.2, 11.8), (3.0, 11.6), (8.0, 9.6), (14.0, 8.4), (19.0, 7.2),
                  (21.6, 5.0), (22.6, 2.0)], corners=36)


def shoulder_hub():
    """The axle of the shoulder along its own z, in centimetres."""
    return lathe([(-11.8, 6.0), (-11.4, 7.0), (-9.0, 7.2), (-8.6, 8.2), (8.6, 8.2), (9.0, 7.2),
                  (11.4, 7.0), (11.8, 6.0)], corners=32)


def upper_arm():
    """A bowed, tapered shell in millimetres, its z to be stretched by 1.5."""
    stations = [Station(-62, 34, 30), Station(-54, 66, 52), Station(-30, 82, 62),
                Station(0, 84, 64), Station(70, 72, 58, 8), Station(150, 58, 52, 14),
                Station(230, 56, 50, 8), Station(280, 62, 52), Station(304, 60, 50),
                Station(320, 48, 40), Station(326, 26, 24)]
    return loft(smooth(stations, 2), corners=24, power=2.8)


def forearm():
    """A slender shell that leaves the roll axis and comes back to it."""
    stations = [Station(0.000, 0.054, 0.054), Station(0.012, 0.060, 0.058),
                Station(0.050, 0.062, 0.058, 0.008), Station(0.120, 0.050, 0.050, 0.030),
                Station(0.200, 0.040, 0.044, 0.030), Station(0.270, 0.040, 0.042, 0.008),
                Station(0.310, 0.044, 0.044), Station(0.338, 0.038, 0.038),
                Station(0.350, 0.022, 0.022)]
    return loft(smooth(stations, 2), corners=24, power=2.6)


def wrist_bell():
    """The bell between the wrist's axle and the flange."""
    return lathe([(-0.044, 0.012), (-0.038, 0.030), (-0.020, 0.044), (0.004, 0.050),
                  (0.036, 0.044), (0.070, 0.034), (0.088, 0.034), (0.100, 0.040), (0.108, 0.040)],
                 corners=28)


def finger():
    """The left finger: its flat pad faces -y, its back is bowed, its tip is thin."""
    stations = [Station(0.000, 0.014, 0.012, 0.0, 0.014), Station(0.018, 0.015, 0.014, 0.0, 0.018),
                Station(0.040, 0.014, 0.013, 0.0, 0.027), Station(0.064, 0.012, 0.011, 0.0, 0.024),
                Station(0.084, 0.010, 0.009, 0.0, 0.012), Station(0.112, 0.008, 0.006, 0.0, 0.006),
                Station(0.120, 0.005, 0.004, 0.0, 0.004)]
    return loft(stations, corners=16, power=4.0)


# From rings to triangles.

def lathe(profile, corners):
    """Turns a profile of (z, radius) about z."""
    return loft([Station(z, radius, radius) for z, radius in profile], corners, power=2.0)


def smooth(stations, steps):
    """Puts steps - 1 stations of a Catmull-Rom spline between each two."""
    padded = [stations[0], *stations, stations[-1]]
    fine = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:]):
        fine += [Station(*(spline(values, step / steps) for values in zip(a, b, c, d)))
                 for step in range(steps)]
    return fine + [stations[-1]]


def spline(values, t):
    """The Catmull-Rom spline through four values, between the middle two at t in 0..1."""
    a, b, c, d = values
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))


def loft(stations, corners, power):
    """Joins the rings of the stations and closes both ends."""
    vertices = [point for station in stations for point in ring(station, corners, power)]
    triangles = []
    for row in range(len(stations) - 1):
        for this in range(corners):
            triangles += wall(row * corners, this, (this + 1) % corners, corners)
    last = (len(stations) - 1) * corners
    triangles += cap(len(vertices), range(corners - 1, -1, -1))
    triangles += cap(len(vertices) + 1, range(last, last + corners))
    return Mesh(vertices + [centre(stations[0]), centre(stations[-1])], triangles)


def ring(station, corners, power):
    """A superellipse: power 2 is an ellipse, more is squarer."""
    points = []
    for index in range(corners):
        angle = 2 * math.pi * (index + 0.5) / corners
        points.append(exact(station.x + station.half_x * bend(math.cos(angle), power),
                            station.y + station.half_y * bend(math.sin(angle), power), station.z))
    return points


def bend(value, power):
    """The coordinate of a superellipse for the coordinate of a circle."""
    return math.copysign(abs(value) ** (2 / power), value)


def centre(station):
    return exact(station.x, station.y, station.z)


def exact(*coordinates):
    """Rounds to six digits, so that every mathematics library yields the same file; no -0."""
    return tuple(round(coordinate, 6) + 0.0 for coordinate in coordinates)


def wall(base, this, following, corners):
    """The two triangles of one quad between a ring that starts at base and the one above."""
    lower, upper = base + this, base + this + corners
    return [(lower, base + following, base + following + corners),
            (lower, base + following + corners, upper)]


def cap(middle, rim):
    """A fan around the vertex middle."""
    rim = list(rim)
    return [(middle, this, following) for this, following in zip(rim, rim[1:] + rim[:1])]


# What goes into which file.

def shoulder():
    """Two scene nodes in centimetres; the second lays the hub's axis along y, 14 cm up."""
    return collada('0.01', [
        ('dome', shoulder_dome(), '0.90 0.91 0.92 1', '1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1'),
        ('hub', shoulder_hub(), '0.20 0.22 0.25 1', '1 0 0 0  0 0 1 0  0 -1 0 14  0 0 0 1')])


def files():
    """File name -> content."""
    return {
        'pedestal.stl': binary_stl(pedestal()),
        'shoulder.dae': shoulder(),
        'upper_arm_mm.stl': binary_stl(upper_arm()),
        'forearm.obj': wavefront_obj(forearm(), 'forearm.mtl'),
        'forearm.mtl': wavefront_mtl('0.95 0.52 0.16'),
        'wrist.stl': binary_stl(wrist_bell()),
        'finger_ascii.stl': ascii_stl(finger()),
    }


def differences(wanted):
    """One line for each file that is missing, changed or not ours."""
    found = {path.name: path.read_bytes() for path in MESHES.glob('*')}
    return [f'{MESHES.name}/{name} is not what make_meshes.py writes'
            for name in sorted(wanted.keys() | found.keys()) if wanted.get(name) != found.get(name)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--check', action='store_true',
                        help='write nothing; exit 1 when a file on disk differs')
    if parser.parse_args().check:
        complaints = differences(files())
        print('\n'.join(complaints), file=sys.stderr, end='\n' if complaints else '')
        return 1 if complaints else 0
    MESHES.mkdir(exist_ok=True)
    for name, content in files().items():
        (MESHES / name).write_bytes(content)
    return 0


if __name__ == '__main__':
    sys.exit(main())
