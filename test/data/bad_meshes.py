#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small mesh files, broken, hostile or odd but right, and what must become of each.

usage: bad_meshes.py [--check]     writes them into this folder, or checks that they are there
"""
import json
import pathlib
import struct
import sys

FOLDER = pathlib.Path(__file__).resolve().parent / 'meshes'
NAN, INFINITY = float('nan'), float('inf')


def cube():
    """The 12 triangles of [0, 1]^3."""
    triangles = []
    for axis in range(3):
        for side in (0.0, 1.0):
            corners = []
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = [float(u), float(v)]
                corner.insert(axis, side)
                corners.append(tuple(corner))
            triangles += [corners[:3], [corners[0], *corners[2:]]]
    return triangles


def stl(triangles, count=None):
    """Binary; the count may lie."""
    count = len(triangles) if count is None else count
    data = bytes(80) + struct.pack('<I', count)
    for triangle in triangles:
        data += struct.pack('<3f', 0, 0, 0)
        for corner in triangle:
            data += struct.pack('<3f', *corner)
        data += bytes(2)
    return data


def ply(vertices, faces, claimed=None):
    lines = ['ply', 'format ascii 1.0', 'element vertex %d' % (claimed or len(vertices)),
             'property float x', 'property float y', 'property float z',
             'element face %d' % len(faces), 'property list uchar int vertex_indices',
             'end_header']
    lines += [' '.join(map(str, row)) for row in vertices]
    lines += [' '.join(map(str, [len(face), *face])) for face in faces]
    return '\n'.join(lines + ['']).encode()


def dae(unit='1', matrix='1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1', geometry='#g', nodes='',
        primitive='<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/>'
                  '<p>0 1 2</p></triangles>', prolog=''):
    """One triangle (0 0 0), (1 0 0), (0 2 0) below one node."""
    return ('<?xml version="1.0"?>%s<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"'
            ' version="1.4.1"><asset><unit meter="%s"/><up_axis>Z_UP</up_axis></asset>'
            '<library_geometries><geometry id="g"><mesh><source id="p">'
            '<float_array id="a" count="9">0 0 0 1 0 0 0 2 0</float_array><technique_common>'
            '<accessor source="#a" count="3" stride="3"><param name="X" type="float"/>'
            '<param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
            '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>'
            '</vertices>%s</mesh></geometry></library_geometries>%s<library_visual_scenes>'
            '<visual_scene id="s"><node id="n"><matrix>%s</matrix><instance_geometry url="%s"/>'
            '</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/>'
            '</scene></COLLADA>\n' % (prolog, unit, primitive, nodes, matrix, geometry)).encode()


def recursive_dae():
    """A node that contains itself: readers that recurse run out of stack."""
    nodes = ('<library_nodes><node id="r"><instance_geometry url="#g"/><instance_node url="#r"/>'
             '</node></library_nodes>')
    return dae(nodes=nodes).replace(b'<instance_geometry url="#g"/></node></visual_scene>',
                                    b'<instance_node url="#r"/></node></visual_scene>')


def nested_dae():
    """Ten nodes, each with ten instances of the next: 10^10 triangles in a small file."""
    nodes = '<library_nodes>'
    for depth in range(10):
        child = ('<instance_node url="#d%d"/>' % (depth + 1) if depth < 9 else
                 '<instance_geometry url="#g"/>')
        nodes += '<node id="d%d">%s</node>' % (depth, 10 * child)
    return dae(nodes=nodes + '</library_nodes>').replace(
        b'<instance_geometry url="#g"/></node></visual_scene>',
        b'<instance_node url="#d0"/></node></visual_scene>')


def entity_bomb():
    entities = '<!ENTITY a0 "lol">'
    for i in range(1, 20):
        entities += '<!ENTITY a%d "%s">' % (i, 10 * ('&a%d;' % (i - 1)))
    return dae(prolog='<!DOCTYPE bomb [%s]>' % entities)


def gltf(uri):
    """Three vertices in another file."""
    return json.dumps({
        'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
        'nodes': [{'mesh': 0}], 'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
        'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3',
                       'min': [0, 0, 0], 'max': [1, 2, 3]}],
        'bufferViews': [{'buffer': 0, 'byteLength': 36}],
        'buffers': [{'byteLength': 36, 'uri': uri}]}).encode()


TRIANGLE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 2.0, 3.0)]
OBJ = b'v 0 0 0\nv 1 0 0\nv 0 2 0\n'

# Name: content, and the exact box (low, high) or words of the error.
MESHES = {
    'cube.stl': (stl(cube()), ([0, 0, 0], [1, 1, 1])),
    'truncated.stl': (stl(cube())[:400], 'truncated.stl'),
    'lying_count.stl': (stl(cube(), 4000000000), 'lying_count.stl'),
    'no_byte.stl': (b'', 'no_byte.stl'),
    'no_triangle.stl': (stl([]), 'no_triangle.stl'),
    'nan_vertex.stl': (stl(cube() + [[(NAN, 0, 0), *TRIANGLE[1:]]]), 'not a finite number'),
    'infinite_vertex.stl': (stl(cube() + [[(0, INFINITY, 0), *TRIANGLE[1:]]]),
                            'not a finite number'),
    'one_triangle.stl': (stl([TRIANGLE]), ([0, 0, 0], [1, 2, 3])),
    'flat.stl': (stl([[(0, 0, 0), (10, 0, 0), (10, 10, 0)]]), ([0, 0, 0], [10, 10, 0])),
    'prose.stl': (b'Once upon a time there was no mesh.\n', 'prose.stl'),
    'prose.dae': (b'Once upon a time there was no mesh.\n', 'prose.dae'),
    'no_face.obj': (OBJ, 'no_face.obj'),
    'index_zero.obj': (OBJ + b'f 0 1 2\n', 'index_zero.obj'),
    'index_too_large.obj': (OBJ + b'f 1 2 9\n', 'index_too_large.obj'),
    'far_unused_vertex.obj': (OBJ + b'v 1000 0 0\nf 1 2 3\n', ([0, 0, 0], [1, 2, 0])),
    'material_elsewhere.obj': (b'mtllib /etc/passwd\n' + OBJ + b'f 1 2 3\n',
                               ([0, 0, 0], [1, 2, 0])),
    'index_too_large.ply': (ply(TRIANGLE, [[0, 1, 77]]), 'vertex 77 of 3'),
    'billion_vertices.ply': (ply(TRIANGLE, [[0, 1, 2]], 1000000000), 'billion_vertices.ply'),
    'plain.dae': (dae(), ([0, 0, 0], [1, 2, 0])),
    'recursive.dae': (recursive_dae(), 'recursive.dae'),
    'nested.dae': (nested_dae(), 'nested.dae'),
    'entity_bomb.dae': (entity_bomb(), ([0, 0, 0], [1, 2, 0])),
    'unit_zero.dae': (dae(unit='0'), 'unit of length is zero'),
    'unit_nan.dae': (dae(unit='nan'), 'not a finite number'),
    'matrix_nan.dae': (dae(matrix='nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1'), 'not a finite number'),
    'no_geometry.dae': (dae(geometry='#nowhere'), 'no_geometry.dae'),
    'lines.dae': (dae(primitive='<lines count="1"><input semantic="VERTEX" source="#v" offset="0"/>'
                                '<p>0 1</p></lines>'), 'no triangle'),
    'buffer_elsewhere.gltf': (gltf('/etc/passwd'), 'buffer_elsewhere.gltf'),
}


def main():
    if sys.argv[1:] == ['--check']:
        wrong = [name for name, (content, _) in MESHES.items()
                 if not (FOLDER / name).exists() or (FOLDER / name).read_bytes() != content]
        wrong += sorted({path.name for path in FOLDER.iterdir()} - set(MESHES))
        sys.exit('not as bad_meshes.py makes them: %s' % ', '.join(wrong) if wrong else 0)
    if sys.argv[1:]:
        sys.exit(__doc__)
    FOLDER.mkdir(exist_ok=True)
    for name, (content, _) in MESHES.items():
        (FOLDER / name).write_bytes(content)


if __name__ == '__main__':
    main()
