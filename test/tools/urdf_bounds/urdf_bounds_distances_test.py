#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdf_bounds --distances prints: which pairs, how far apart, in every format.

Run as: urdf_bounds_distances_test.py PATH_OF_urdf_bounds
"""
import csv
import io
import json
import math
import os

from binary_stl import binary_stl
from urdf_bounds_testing import UrdfBoundsTest, boxes, main, run

ACCURACY = 1e-4  # metres
ROUNDING = 1e-12  # metres
INCOMPLETE = 4  # exit code
CSV_HEADER = ['first', 'second', 'distance', 'distance_max', 'on_first_x', 'on_first_y',
              'on_first_z', 'on_second_x', 'on_second_y', 'on_second_z', 'normal_x', 'normal_y',
              'normal_z', 'level']
PACKAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../..')
CUBE = os.path.join(PACKAGE, 'test/data/meshes/cube.stl')
TOOLS_PAGE = os.path.join(PACKAGE, 'doc/tools.md')
BOX = '<box size="1 1 1"/>'
BALL = '<sphere radius="0.5"/>'


def mesh(path):
    return '<mesh filename="file://%s"/>' % os.path.realpath(path)


def robot(*links):
    """Links (name, geometry, x y z), each two movable joints away from the base: one along x that
    is called after the link, and one that turns."""
    text = '<robot name="r"><link name="base"/>'
    for name, geometry, xyz in links:
        text += '''<link name="via %(name)s"/><link name="%(name)s"><visual>
<geometry>%(geometry)s</geometry></visual></link>
<joint name="%(name)s" type="prismatic"><parent link="base"/><child link="via %(name)s"/>
<origin xyz="%(xyz)s"/><axis xyz="1 0 0"/>
<limit lower="-99" upper="99" effort="1" velocity="1"/></joint>
<joint name="turn %(name)s" type="continuous"><parent link="via %(name)s"/><child link="%(name)s"/>
<axis xyz="0 0 1"/></joint>''' % {'name': name, 'geometry': geometry, 'xyz': xyz}
    return text + '</robot>'


TWO_BOXES = robot(('a', BOX, '0 0 0'), ('b', BOX, '3 0 0'))

# A pair of every kind: rigid, neighbours by one joint, and by two.
CHAIN = '''<robot name="r">%s
<joint name="weld" type="fixed"><parent link="root"/><child link="welded"/></joint>
<joint name="one" type="continuous"><parent link="root"/><child link="next"/>
  <axis xyz="0 0 1"/></joint>
<joint name="two" type="continuous"><parent link="next"/><child link="last"/>
  <axis xyz="0 0 1"/></joint></robot>''' % ''.join(
    '<link name="%s"><visual><geometry>%s</geometry></visual></link>' % (name, BOX)
    for name in ('root', 'last', 'next', 'welded'))


def plate(x):
    """Two triangles across x, 2 m wide."""
    a, b, c, d = [(x, y, z) for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return [(a, b, c), (a, c, d)]


def distances(limit, *arguments, **options):
    return boxes('--distances', str(limit), *arguments, **options)['distances']


class DistancesTest(UrdfBoundsTest):
    def check_vector(self, found, expected, delta=ROUNDING):
        self.assertEqual(len(found), 3)
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=delta)

    def check_pair(self, pair, names, exact):
        self.assertEqual((pair['first'], pair['second']), names)
        self.assertLessEqual(pair['distance'], exact + ROUNDING)
        self.assertGreaterEqual(pair['distance_max'], exact - ROUNDING)
        self.assertLessEqual(pair['distance_max'] - pair['distance'], ACCURACY)
        self.assertAlmostEqual(math.dist(pair['on_first'], pair['on_second']),
                               pair['distance_max'], delta=ROUNDING)

    def test_two_boxes(self):
        found = boxes('--distances', '5', urdf=TWO_BOXES)
        self.assertEqual(list(found), ['frame', 'boxes', 'groups', 'distances', 'incomplete'])
        self.assertEqual(found['incomplete'], {})
        pair, = found['distances']
        self.assertEqual(list(pair), ['first', 'second', 'distance', 'distance_max', 'on_first',
                                      'on_second', 'normal', 'level'])
        self.check_pair(pair, ('a', 'b'), 2)
        self.check_vector(pair['normal'], [1, 0, 0])
        self.assertAlmostEqual(pair['on_first'][0], .5, delta=ROUNDING)
        self.assertAlmostEqual(pair['on_second'][0], 2.5, delta=ROUNDING)
        self.assertEqual(pair['level'], 'HULL')

    def test_everything_else_is_as_without_the_option(self):
        with_distances = boxes('--distances=5', urdf=TWO_BOXES)
        del with_distances['distances']
        self.assertEqual(with_distances, boxes(urdf=TWO_BOXES))

    def test_sphere_and_the_corner_of_a_box(self):
        exact = math.sqrt(3) * 1.5 - .5
        pair, = distances(5, urdf=robot(('box', BOX, '0 0 0'), ('ball', BALL, '2 2 2')))
        self.check_pair(pair, ('box', 'ball'), exact)
        self.check_vector(pair['normal'], [math.sqrt(1 / 3)] * 3, 1e-3)

    def test_joints_move_the_pairs(self):
        pair, = distances(5, 'b:=1', 'turn b:=%.17g' % (math.pi / 4), urdf=TWO_BOXES)
        self.check_pair(pair, ('a', 'b'), 3.5 - math.sqrt(.5))

    def test_meshes(self):
        box = boxes(urdf=robot(('m', mesh(CUBE), '0 0 0')))['boxes']['m']
        low, high = box['min'], box['max']
        away = 2 * (high[0] - low[0])
        pair, = distances(away, urdf=robot(('a', mesh(CUBE), '0 0 0'),
                                           ('b', mesh(CUBE), '%.17g 0 0' % away)))
        self.check_pair(pair, ('a', 'b'), away / 2)

    def test_between_two_plates_the_triangles_decide(self):
        plates = self.write('plates.stl', binary_stl(plate(-1) + plate(1)))
        urdf = robot(('plates', mesh(plates), '0 0 0'), ('ball', BALL, '0.2 0 0'))
        pair, = distances(1, urdf=urdf)
        self.check_pair(pair, ('plates', 'ball'), .3)
        self.assertEqual(pair['level'], 'MESH')
        self.check_vector(pair['on_first'], [1, 0, 0], 1e-2)

    def test_a_mesh_without_triangles_is_its_hull_and_said_so(self):
        far = self.write('far.stl', binary_stl([((0, 0, 0), (1e35, 0, 0), (0, 1, 0))]))
        urdf = robot(('far', mesh(far), '0 0 0'), ('ball', BALL, '0 0 3'))
        code, out, err = run('-', '--format=json', '--distances=4', '--strict', urdf=urdf)
        self.assertEqual(code, INCOMPLETE)
        pair, = json.loads(out)['distances']
        self.assertEqual(pair['level'], 'HULL')
        self.assertLessEqual(pair['distance'], 2.5)
        self.assertRegex(err, '^urdf_bounds: warning: link "far", visual 1 .*: distances are those '
                              'of the convex hull of %s: .*; repair or replace the file\n' % far)
        self.assertIn('not everything was answered: distances less accurate than 0.0001 m: 1;', err)
        self.assertEqual(run('-', urdf=urdf)[2], '', 'boxes need no triangles')

    def test_rigid_and_neighbouring_links_are_no_pair(self):
        names = [(pair['first'], pair['second']) for pair in distances(9, urdf=CHAIN)]
        self.assertEqual(names, [('root', 'last'), ('last', 'welded')])

    def test_pairs_are_sorted_like_the_links(self):
        urdf = robot(*((name, BALL, '%d 0 0' % x) for name, x in zip('dbca', (3, 0, 7, 5))))
        self.assertEqual([pair['first'] + pair['second'] for pair in distances(99, urdf=urdf)],
                         ['db', 'dc', 'da', 'bc', 'ba', 'ca'])

    def test_only_pairs_within_the_limit(self):
        self.assertEqual(distances(1.999, urdf=TWO_BOXES), [])
        self.assertEqual(len(distances(2, urdf=TWO_BOXES)), 1)
        self.assertEqual(len(distances(1e308, urdf=TWO_BOXES)), 1)
        diagonal = robot(('a', BALL, '0 0 0'), ('b', BALL, '2 2 2'))
        self.assertEqual(distances(2, urdf=diagonal), [], 'their boxes are nearer')

    def test_limit_zero_gives_what_may_touch(self):
        self.assertEqual(distances(0, urdf=TWO_BOXES), [])
        self.assertEqual(distances(0, 'b:=-1.9999', urdf=TWO_BOXES), [])
        for value in ('-2', '-2.5'):
            pair, = distances(0, 'b:=' + value, urdf=TWO_BOXES)
            self.assertEqual(pair['distance'], 0)
            self.assertEqual(pair['normal'], [0, 0, 0])

    def check_nothing_to_compare(self, *arguments, urdf):
        code, out, err = run('-', '--format=json', '--distances=9', *arguments, urdf=urdf)
        self.assertEqual((code, json.loads(out)['distances']), (INCOMPLETE, []))
        self.assertIn('no two links were compared; --allow-incomplete accepts that', err)

    def test_geometry(self):
        urdf = TWO_BOXES.replace('</link>\n<joint name="b"', '<collision><geometry>' + BALL.replace(
            '0.5', '2') + '</geometry></collision></link>\n<joint name="b"')
        self.check_pair(distances(9, urdf=urdf)[0], ('a', 'b'), 2)
        self.check_pair(distances(9, '--geometry=both', urdf=urdf)[0], ('a', 'b'), .5)
        self.check_nothing_to_compare('--geometry=collision', urdf=urdf)

    def test_csv_has_the_numbers_of_json(self):
        urdf = TWO_BOXES.replace('"b"', '"b, the second"')
        code, out, err = run('-', '--format=csv', '--distances=9', 'a:=0.1', urdf=urdf)
        self.assertEqual((code, err), (0, ''))
        rows = list(csv.reader(io.StringIO(out, newline='')))
        pair, = distances(9, 'a:=0.1', urdf=urdf)
        self.assertEqual(rows[0], CSV_HEADER)
        numbers = [pair['distance'], pair['distance_max'], *pair['on_first'], *pair['on_second'],
                   *pair['normal']]
        self.assertEqual(rows[1:], [['a', 'b, the second', *('%.17g' % x for x in numbers),
                                     pair['level']]])

    def test_table(self):
        urdf = robot(('a', BOX, '0 0 0'), ('Gelenk ü 链', BOX, '3 0 0'),
                     ('a longer name', BOX, '0 9 0'))
        code, out, err = run('-', '--distances=9', urdf=urdf)
        self.assertEqual((code, err), (0, ''))
        head, pair, *others = out.splitlines()[-4:]
        self.assertEqual({len(line) for line in [head, pair, *others]}, {len(head)})
        self.assertTrue(head.startswith('first       second         '))
        self.assertTrue(pair.startswith('a           Gelenk ü 链     '))
        self.assertEqual(pair.split()[4:6], ['2.000000', '2.000000'])
        self.assertEqual(pair.split()[-1], 'HULL')
        self.assertTrue(out.startswith(run('-', urdf=urdf)[1]), 'the boxes stand before')
        self.assertTrue(run('-', '--distances=0.25', urdf=urdf)[1].endswith(
            '\n\n(no two links are within 0.25 m of each other)\n'))

    def test_what_is_lost_is_incomplete(self):
        lost = '<visual><geometry><mesh filename="file:///no.stl"/></geometry></visual></link>'
        urdf = robot(('a', BOX, '0 0 0'), ('gone', '<mesh filename="file:///no.stl"/>', '2 0 0'),
                     ('b', BOX, '3 0 0')).replace('</link>\n<joint name="b"',
                                                  lost + '\n<joint name="b"')
        code, out, err = run('-', '--format=json', '--distances=9', '--strict', urdf=urdf)
        found = json.loads(out)
        self.assertEqual(code, INCOMPLETE)
        self.check_pair(found['distances'][0], ('a', 'b'), 2)
        self.assertEqual(len(found['distances']), 1)
        self.assertEqual(list(found['incomplete']), ['gone', 'b', 'group:robot'])
        self.assertEqual(len(err.splitlines()), 3, err)
        self.assertIn('incomplete names: 3; --allow-incomplete accepts that', err)
        for arguments, expected in (((), INCOMPLETE), (('--allow-incomplete',), 0),
                                    (('--allow-incomplete', '--strict'), 2)):
            self.assertEqual(run('-', '--distances=9', *arguments, urdf=urdf)[0], expected)
        self.assertEqual(run('-', urdf=urdf)[0], 0, 'boxes alone')
        self.assertRegex(run('-', '--distances=9', urdf=urdf)[1], '\nincomplete:\n  gone: .*no.stl')

    def test_a_link_too_far_away_for_distances(self):
        urdf = robot(('a', BOX, '0 0 0'), ('b', BOX, '1e100 0 0'), ('c', BOX, '3 0 0'))
        code, out, err = run('-', '--format=json', '--distances=1e200', '--strict', urdf=urdf)
        found = json.loads(out)
        self.assertEqual((code, list(found['incomplete'])), (INCOMPLETE, ['b', 'group:robot']))
        self.assertEqual([pair['second'] for pair in found['distances']], ['c'])
        self.assertTrue(err.startswith('urdf_bounds: warning: link "b": its size and pose give no '
                                       'finite distance\n'), err)

    def test_verbose_tells_the_memory_of_the_triangles(self):
        urdf = robot(('a', mesh(CUBE), '0 0 0'), ('b', mesh(CUBE), '9 0 0'))
        lines = run('-', '--verbose', '--distances=1', urdf=urdf)[2].splitlines()
        one = robot(('a', mesh(CUBE), '0 0 0'))
        self.assertRegex(lines[2], r'^urdf_bounds: \d+ bytes in their triangles$')
        self.assertIn(lines[2], run('-', '--verbose', '--distances=1', urdf=one)[2],
                      'links share their triangles')

    def test_help_and_the_page_of_the_program_name_the_columns(self):
        columns = ','.join(CSV_HEADER)
        with open(TOOLS_PAGE, encoding='utf-8') as page:
            self.assertIn('`%s`' % columns, page.read())
        self.assertRegex(run('--help')[1], r'--distances LIMIT(.*\n)+.*csv.*%s, ' % columns[:45])

    def test_robot_without_geometry(self):
        self.check_nothing_to_compare(urdf='<robot name="r"><link name="base"/></robot>')

    def test_arguments_that_make_no_sense(self):
        for text in ('', 'x', '-0.1', 'nan', 'inf', '1e999', '0.1m', ' 1'):
            self.check_refused('--distances is "%s", but must be a number of metres >= 0' % text,
                               '-', '--distances=' + text)
        self.check_refused('--distances needs a value', '-', '--distances')
        for volume in ('sphere', 'obb'):
            self.check_refused('--distances .*--volume .*only one', '-', '--distances=1',
                               '--volume', volume)


if __name__ == '__main__':
    main()
