#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdf_bounds --volume prints: spheres and oriented boxes in every format.

Run as: urdf_bounds_volumes_test.py PATH_OF_urdf_bounds
"""
import csv
import io
import itertools
import json
import math

from urdf_bounds_testing import UrdfBoundsTest, boxes, main, mesh, run, solid, tetrahedron, tree

LENGTH = 1e-9  # metres
RADIUS = 2e-6  # of a radius
SPHERE_HEADER = ['link', 'center_x', 'center_y', 'center_z', 'radius']
BOX_HEADER = ['link', 'center_x', 'center_y', 'center_z', 'size_x', 'size_y', 'size_z',
              'q_x', 'q_y', 'q_z', 'q_w']
TILTED = '''<robot name="r"><link name="base"><visual><origin rpy="0.3 0.5 0.7" xyz="1 2 3"/>
<geometry><box size="1 2 4"/></geometry></visual></link></robot>'''
BALL = '''<robot name="r"><link name="base"><visual><origin xyz="1 2 3"/><geometry>
<sphere radius="0.5"/></geometry></visual></link></robot>'''


def spheres(*arguments, **options):
    return boxes('--volume', 'sphere', *arguments, **options)


def oriented(*arguments, **options):
    return boxes('--volume=obb', *arguments, **options)


def rotate(q, v):
    """v turned by the quaternion x, y, z, w."""
    x, y, z, w = q
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [sum(a * b for a, b in zip(row, v)) for row in rows]


def corners(box):
    return [[c + d for c, d in zip(box['center'], rotate(box['orientation'], [
        sign * size / 2 for sign, size in zip(signs, box['size'])]))]
            for signs in itertools.product((-1, 1), repeat=3)]


class VolumesTest(UrdfBoundsTest):
    def check_numbers(self, found, expected, delta=LENGTH):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=delta)

    def check_sphere(self, sphere, center, radius):
        self.check_numbers(sphere['center'], center)
        self.assertGreaterEqual(sphere['radius'], radius)
        self.assertLessEqual(sphere['radius'], radius * (1 + RADIUS))

    def test_spheres(self):
        found = spheres()
        self.assertEqual(list(found), ['frame', 'spheres', 'incomplete'])
        self.assertEqual((found['frame'], found['incomplete']), ('base', {}))
        self.assertEqual(list(found['spheres']), ['base', 'bar', 'follower'])
        self.assertEqual(list(found['spheres']['base']), ['center', 'radius'])
        self.check_sphere(found['spheres']['base'], [0, 0, 0], math.sqrt(14) / 2)
        self.check_sphere(found['spheres']['bar'], [1, 0, 1], math.sqrt(5.25) / 2)

    def test_spheres_move_with_joints(self):
        for degrees in (30, 45):
            angle = math.radians(degrees)
            bar = spheres('turn:=%.17g' % angle)['spheres']['bar']
            self.check_sphere(bar, [math.cos(angle), math.sin(angle), 1], math.sqrt(5.25) / 2)

    def test_spheres_of_collision_geometry(self):
        found = spheres('push:=-.5', '--geometry=collision')['spheres']
        self.check_sphere(found['base'], [0, 0, 0], 2)
        self.check_sphere(found['slide'], [-.5, 0, 0], math.sqrt(4.25))
        self.check_sphere(spheres(urdf=BALL)['spheres']['base'], [1, 2, 3], .5)

    def test_oriented_boxes(self):
        found = oriented()
        self.assertEqual(list(found), ['frame', 'oriented_boxes', 'incomplete'])
        self.assertEqual(list(found['oriented_boxes']), ['base', 'bar', 'follower'])
        base = found['oriented_boxes']['base']
        self.assertEqual(list(base), ['center', 'size', 'orientation'])
        self.check_numbers(base['center'], [0, 0, 0])
        self.check_numbers(base['size'], [1, 2, 3])
        self.check_numbers(base['orientation'], [0, 0, 0, 1])

    def test_oriented_boxes_turn_with_joints(self):
        for degrees in (30, 45):
            angle = math.radians(degrees)
            bar = oriented('turn:=%.17g' % angle)['oriented_boxes']['bar']
            self.check_numbers(bar['center'], [math.cos(angle), math.sin(angle), 1])
            self.check_numbers(bar['size'], [2, 1, .5])
            self.check_numbers(bar['orientation'],
                               [0, 0, math.sin(angle / 2), math.cos(angle / 2)])

    def test_volumes_of_a_mesh_contain_its_corners(self):
        path = self.write('t.stl', tetrahedron())
        urdf = tree(solid('base'), mesh('m', 'file://' + path))
        points = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
        sphere = spheres(urdf=urdf)['spheres']['m']
        # The circle around the three points that are not the origin.
        self.check_sphere(sphere, [26 / 196, 160 / 196, 270 / 196], math.sqrt(650) / 14)
        box = oriented(urdf=urdf)['oriented_boxes']['m']
        self.assertLess(math.prod(box['size']), 6 + 1e-9)
        x, y, z, w = box['orientation']
        for point in points:
            offset = [a - b for a, b in zip(point, box['center'])]
            for value, size in zip(rotate((-x, -y, -z, w), offset), box['size']):
                self.assertLessEqual(abs(value), size / 2 + 1e-15)

    def test_axis_aligned_box_of_an_oriented_one_is_the_box_of_the_link(self):
        box = oriented('turn:=0.7')['oriented_boxes']['bar']
        exact = boxes('turn:=0.7')['boxes']['bar']
        self.check_numbers([min(c) for c in zip(*corners(box))], exact['min'])
        self.check_numbers([max(c) for c in zip(*corners(box))], exact['max'])

    def test_csv_has_the_numbers_of_json(self):
        for kind, header, found in (
                ('sphere', SPHERE_HEADER, spheres(urdf=TILTED)['spheres']),
                ('obb', BOX_HEADER, oriented(urdf=TILTED)['oriented_boxes'])):
            code, out, err = run('-', '--format=csv', '--volume', kind, urdf=TILTED)
            self.assertEqual((code, err), (0, ''))
            rows = list(csv.reader(io.StringIO(out, newline='')))
            self.assertEqual(rows[0], header)
            self.assertEqual([row[0] for row in rows[1:]], list(found))
            for name, *texts in rows[1:]:
                volume = found[name]
                numbers = volume['center'] + (
                    [volume['radius']] if kind == 'sphere' else
                    volume['size'] + volume['orientation'])
                self.assertEqual([float(x) for x in texts], numbers)
                self.assertEqual(texts, ['%.17g' % x for x in numbers])

    def test_table(self):
        for kind, name, words in (('sphere', 'sphere', 8), ('obb', 'oriented box', 21)):
            code, out, err = run('-', '--volume', kind)
            self.assertEqual((code, err), (0, ''))
            lines = [line for line in out.splitlines() if line]
            self.assertRegex(lines[0], r'frame: base\s+unit: m\s+volume: %s$' % name)
            self.assertEqual(len(lines[1].split()), words)
            self.assertEqual([line.split()[0] for line in lines[2:]], ['base', 'bar', 'follower'])
            self.assertEqual(len({len(line) for line in lines[1:]}), 1)
        self.assertEqual(lines[2].split()[4:7], ['1.000000', '2.000000', '3.000000'])

    def test_what_is_lost_is_incomplete(self):
        lost = '<visual><geometry><mesh filename="file:///no.stl"/></geometry></visual>'
        urdf = tree(solid('base'), solid('half', lost), mesh('m', 'file:///no.stl'))
        for kind, key in (('sphere', 'spheres'), ('obb', 'oriented_boxes')):
            code, out, _ = run('-', '--volume', kind, '--format=json', '--strict', urdf=urdf)
            self.assertEqual(code, 2)
            expected = run('-', '--format=json', urdf=urdf)[1]
            found = json.loads(out)['incomplete']
            found['group:robot'] = 'link "half" and 1 more are incomplete'
            self.assertEqual(found, json.loads(expected)['incomplete'])
            self.assertIn('\nincomplete:m,,,,',
                          run('-', '--volume', kind, '--format=csv', urdf=urdf)[1])
            self.assertIn('"%s": {\n  "base": ' % key, out)
            self.assertIn('\n  "half": {"center"', out)

    def test_robot_without_geometry(self):
        urdf = tree('<link name="base"></link>')
        self.assertEqual(spheres(urdf=urdf), {'frame': 'base', 'spheres': {}, 'incomplete': {}})
        self.assertIn('(no link has a volume)', run('-', '--volume=obb', urdf=urdf)[1])

    def test_arguments_that_make_no_sense(self):
        self.check_refused('--volume is "cube", but must be one of: obb, sphere', '-',
                           '--volume=cube')
        for kind in ('sphere', 'obb'):
            self.check_refused('--representation .*--volume.* only one', '-', '--volume', kind,
                               '--representation=min-max')


if __name__ == '__main__':
    main()
