# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The geometry of a URDF as triangles: the mesh formats that make_meshes.py writes, and solids."""

import math
import os
import struct
from xml.etree import ElementTree

import numpy
import rospkg

CORNERS = 48  # of a round solid


def box(size):
    """Triangles of a box around the origin, as an array of n x 3 corners x 3 coordinates."""
    signs = numpy.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)]) - 0.5
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]
    return (signs * size)[faces]


def lathe(profile):
    """The surface around z of (z, radius) points in order; open at both ends unless a radius is 0."""
    angles = numpy.arange(CORNERS) * 2 * math.pi / CORNERS
    rings = numpy.array([[(r * math.cos(a), r * math.sin(a), z) for a in angles]
                         for z, r in profile])
    ahead = numpy.roll(rings, -1, axis=1)
    quads = (rings[:-1], ahead[:-1], ahead[1:], rings[1:])
    first, second = (numpy.stack([quads[i].reshape(-1, 3) for i in face], axis=1)
                     for face in ((0, 1, 2), (0, 2, 3)))
    return numpy.concatenate([first, second])


def cylinder(radius, length):
    return lathe([(-length / 2, 0), (-length / 2, radius), (length / 2, radius), (length / 2, 0)])


def sphere(radius):
    steps = [math.pi * (i / 16 - 0.5) for i in range(17)]
    return lathe([(radius * math.sin(a), radius * math.cos(a)) for a in steps])


def read_stl(data):
    if data[:5] == b'solid' and b'facet' in data:
        words = [line.split()[1:] for line in data.decode('ascii').splitlines()
                 if line.split()[:1] == ['vertex']]
        return numpy.array(words, dtype=float).reshape(-1, 3, 3)
    count, = struct.unpack_from('<I', data, 80)
    kind = numpy.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('rest', '<u2')])
    return numpy.frombuffer(data, kind, count, 84)['corners'].astype(float)


def read_obj(data):
    lines = [line.split() for line in data.decode('ascii').splitlines()]
    vertices = numpy.array([line[1:4] for line in lines if line[:1] == ['v']], dtype=float)
    return vertices[[[int(corner.split('/')[0]) - 1 for corner in line[1:4]]
                     for line in lines if line[:1] == ['f']]]


def read_dae(data):
    """Each node of the scene has one geometry with triangles of one input, and a matrix."""
    root = ElementTree.fromstring(data)
    for element in root.iter():
        element.tag = element.tag.split('}')[-1]
    unit = float(root.find('.//unit').get('meter'))
    parts = []
    for node in root.iter('node'):
        matrix = numpy.array(node.find('matrix').text.split(), dtype=float).reshape(4, 4)
        name = node.find('instance_geometry').get('url')[1:]
        mesh = next(g for g in root.iter('geometry') if g.get('id') == name).find('mesh')
        sources = {source.get('id'): source for source in mesh.findall('source')}
        position = mesh.find('vertices/input').get('source')[1:]
        vertices = numpy.array(sources[position].find('float_array').text.split(), dtype=float)
        triangles = mesh.find('triangles')
        stride = 1 + max(int(i.get('offset')) for i in triangles.findall('input'))
        indices = numpy.array(triangles.find('p').text.split(), dtype=int)[::stride]
        corners = vertices.reshape(-1, 3)[indices].reshape(-1, 3, 3)
        parts.append(unit * (corners @ matrix[:3, :3].T + matrix[:3, 3]))
    return numpy.concatenate(parts)


READERS = {'.stl': read_stl, '.obj': read_obj, '.dae': read_dae}


def read_mesh(uri):
    package, _, path = uri[len('package://'):].partition('/')
    path = os.path.join(rospkg.RosPack().get_path(package), path)
    with open(path, 'rb') as file:
        return READERS[os.path.splitext(path)[1]](file.read())


def numbers(text):
    return numpy.array(text.split(), dtype=float)


def turned(roll_pitch_yaw):
    """The matrix of these angles."""
    result = numpy.eye(3)
    for axis, angle in enumerate(roll_pitch_yaw):
        turn, (a, b) = numpy.eye(3), ((1, 2), (2, 0), (0, 1))[axis]
        turn[a, a] = turn[b, b] = math.cos(angle)
        turn[b, a], turn[a, b] = math.sin(angle), -math.sin(angle)
        result = turn @ result
    return result


def shape(geometry):
    kind = geometry[0]
    if kind.tag == 'mesh':
        return read_mesh(kind.get('filename')) * numbers(kind.get('scale', '1 1 1'))
    if kind.tag == 'box':
        return box(numbers(kind.get('size')))
    if kind.tag == 'sphere':
        return sphere(float(kind.get('radius')))
    return cylinder(float(kind.get('radius')), float(kind.get('length')))


def link_triangles(description):
    """{link: triangles in its frame} of all visual elements of a URDF: meshes and solids."""
    result = {}
    for link in ElementTree.fromstring(description).findall('link'):
        parts = []
        for visual in link.findall('visual'):
            origin = visual.find('origin')
            attributes = {} if origin is None else origin.attrib
            parts.append(shape(visual.find('geometry')) @ turned(numbers(
                attributes.get('rpy', '0 0 0'))).T + numbers(attributes.get('xyz', '0 0 0')))
        if parts:
            result[link.get('name')] = numpy.concatenate(parts)
    return result
