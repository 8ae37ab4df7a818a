#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdf_bounds prints: boxes of joints and geometry in every format.

Run as: urdf_bounds_test.py PATH_OF_urdf_bounds
"""
import csv
import io
import json
import math

from urdf_bounds_testing import (HEADER, UrdfBoundsTest, boxes, main, run, solid, tree)


class GeometryTest(UrdfBoundsTest):
    def test_zero_pose(self):
        found = boxes()
        self.assertEqual(found['frame'], 'base')
        self.assertEqual(list(found['boxes']), ['base', 'bar', 'follower'])
        self.check_box(found['boxes']['base'], [-.5, -1, -1.5], [.5, 1, 1.5])
        self.check_box(found['boxes']['bar'], [0, -.5, .75], [2, .5, 1.25])
        half = math.cos(.25) + math.sin(.25) / 2  # the follower is turned by its offset
        self.check_box(found['groups']['robot'], [-half, -1, -1.5], [2, 1, 1.5])
        self.assertEqual(found['incomplete'], {})

    def test_thirty_degrees(self):
        root3 = math.sqrt(3)
        bar = boxes('turn:=%.17g' % (math.pi / 6))['boxes']['bar']
        self.check_box(bar, [-1 / 4, -root3 / 4, .75], [root3 + 1 / 4, 1 + root3 / 4, 1.25])

    def test_forty_five_degrees(self):
        eighth = math.sqrt(2) / 4
        bar = boxes('turn:=%.17g' % (math.pi / 4))['boxes']['bar']
        self.check_box(bar, [-eighth, -eighth, .75], [5 * eighth, 5 * eighth, 1.25])

    def test_prismatic_joint_and_collision(self):
        found = boxes('push:=-.5', '--geometry=collision')
        self.assertEqual(list(found['boxes']), ['base', 'slide'])
        self.check_box(found['boxes']['base'], [-2, -2, -2], [2, 2, 2])
        self.check_box(found['boxes']['slide'], [-1, -.5, -2], [0, .5, 2])

    def test_both_kinds_of_geometry(self):
        found = boxes('--geometry', 'both')
        self.assertEqual(list(found['boxes']), ['base', 'bar', 'slide', 'follower'])
        self.check_box(found['boxes']['base'], [-2, -2, -2], [2, 2, 2])

    def test_links_of_the_other_kind_are_named_beside_a_verdict(self):
        for *arguments, other, names in (('--reach', 'collision', '"slide"'),
                                         ('--pairs', '--geometry', 'collision', 'visual',
                                          '"bar", "follower"'),
                                         ('--distances', '1', 'collision', '"slide"')):
            note = 'note: left out are links with %s geometry only: %s;' % (other, names)
            self.assertEqual(run('-', *arguments)[2].count(note), 1, arguments)
        for arguments in ((), ('--distances', '1', '--geometry', 'both')):
            self.assertEqual(run('-', *arguments)[2], '', arguments)

    def test_mimic_joint_follows(self):
        angle = -2 * .3 + .25
        half = [math.cos(angle) + abs(math.sin(angle)) / 2,
                abs(math.sin(angle)) + math.cos(angle) / 2, .5]
        follower = boxes('turn:=0.3')['boxes']['follower']
        self.check_box(follower, [-x for x in half], half)

    def test_value_for_a_mimic_joint_is_ignored(self):
        code, out, err = run('-', 'turn:=0.3', 'follow:=1', '--format', 'json')
        self.assertEqual(code, 0)
        self.assertEqual(json.loads(out), boxes('turn:=0.3'))
        self.assertRegex(err, '^urdf_bounds: warning: .*"follow".*mimics joint "turn"')

    def test_numbers_as_people_write_them(self):
        for text in ('+0.5', '.5', '5e-1', '0.50'):
            self.assertEqual(boxes('turn:=' + text), boxes('turn:=0.5'))


class FormatTest(UrdfBoundsTest):
    def rows(self, *arguments, **options):
        code, out, err = run('-', '--format', 'csv', *arguments, **options)
        self.assertEqual((code, err), (0, ''))
        self.assertTrue(out.startswith('link,a_x,a_y,a_z,b_x,b_y,b_z\n'))
        return list(csv.reader(io.StringIO(out, newline='')))

    def test_csv_has_the_numbers_of_json(self):
        found = boxes('turn:=0.7')
        expected = dict(found['boxes'], **{'group:robot': found['groups']['robot']})
        rows = self.rows('turn:=0.7')
        self.assertEqual(rows[0], HEADER)
        self.assertEqual([row[0] for row in rows[1:]], ['base', 'bar', 'follower', 'group:robot'])
        for name, *numbers in rows[1:]:
            self.assertEqual([float(x) for x in numbers],
                             expected[name]['min'] + expected[name]['max'])

    def test_csv_representations_contain_the_box(self):
        exact = self.rows('turn:=0.7', '--representation=min-max')[1:]
        widths = self.rows('turn:=0.7', '--representation', 'min-width')[1:]
        radii = self.rows('turn:=0.7', '--representation', 'center-radius')[1:]
        for box, wide, round_ in zip(exact, widths, radii):
            for k in range(1, 4):
                low, high = float(box[k]), float(box[k + 3])
                self.assertEqual(wide[k], box[k])
                self.assertGreaterEqual(float(wide[k]) + float(wide[k + 3]), high)
                self.assertAlmostEqual(float(wide[k + 3]), high - low, delta=1e-15)
                self.assertLessEqual(float(round_[k]) - float(round_[k + 3]), low)
                self.assertGreaterEqual(float(round_[k]) + float(round_[k + 3]), high)
                self.assertAlmostEqual(float(round_[k]), (low + high) / 2, delta=1e-15)

    def test_seventeen_digits(self):
        texts = []
        code, out, _ = run('-', 'turn:=0.7', '--format=json')
        json.loads(out, parse_float=texts.append, parse_int=texts.append)
        texts += [x for row in self.rows('turn:=0.7')[1:] for x in row[1:]]
        self.assertEqual(code, 0)
        self.assertEqual(len(texts), 2 * 4 * 6)
        for text in texts:
            self.assertEqual(text, '%.17g' % float(text))

    def test_json_is_always_min_max_and_exact_in_shape(self):
        found = boxes()
        self.assertEqual(found, boxes('--representation=center-radius'))
        self.assertEqual(list(found), ['frame', 'boxes', 'groups', 'incomplete'])
        self.assertEqual(list(found['groups']), ['robot'])
        for box in list(found['boxes'].values()) + list(found['groups'].values()):
            self.assertEqual(list(box), ['min', 'max'])
            self.assertEqual([len(v) for v in box.values()], [3, 3])

    def test_awkward_names(self):
        awkward = ['a,b', 'say &quot;x&quot;', 'back\\slash', 'two&#10;lines', 'Gelenk ü 链']
        plain = ['base', 'a,b', 'say "x"', 'back\\slash', 'two\nlines', 'Gelenk ü 链']
        urdf = tree(*(solid(name) for name in ['base'] + awkward))
        self.assertEqual(list(boxes(urdf=urdf)['boxes']), plain)
        self.assertEqual([row[0] for row in self.rows(urdf=urdf)],
                         ['link'] + plain + ['group:robot'])
        code, out, _ = run('-', urdf=urdf)
        self.assertEqual(code, 0)
        self.assertIn('two lines', out)

    def test_bytes_that_are_not_utf8(self):
        surrogate_and_overlong = b'\xed\xa0\x80 \xe0\x80\xaf'
        urdf = tree(solid('base'), solid('XX')).encode('utf-8').replace(
            b'XX', b'a\xff\xe2(b' + surrogate_and_overlong + 'ü'.encode('utf-8'))
        name = 'a\ufffd\ufffd(b\ufffd\ufffd\ufffd \ufffd\ufffd\ufffdü'
        self.assertEqual(list(boxes(urdf=urdf)['boxes']), ['base', name])
        self.assertIn(name, run('-', urdf=urdf)[1])

    def test_names_that_differ_in_bytes_that_are_not_utf8(self):
        """They would be one name in JSON."""
        links = tree(solid('base'), solid('XX'), solid('YY')).encode()
        joints = tree(solid('base'), solid('a'), solid('b')).encode().replace(
            b'"j1"', b'"XX"').replace(b'"j2"', b'"YY"')
        for urdf, what in (links, 'links'), (joints, 'joints'):
            self.check_refused('two %s of the robot are called "a\ufffd"' % what, '-',
                               urdf=urdf.replace(b'XX', b'a\xfe').replace(b'YY', b'a\xff'))

    def test_table(self):
        code, out, err = run('-', '--representation', 'center-radius', 'turn:=0.7')
        self.assertEqual((code, err), (0, ''))
        lines = out.splitlines()
        self.assertRegex(lines[0], r'frame: base\s+unit: m\s+representation: center-radius')
        rows = [line for line in lines[1:] if line]
        self.assertEqual([row.split()[0] for row in rows],
                         ['link', 'base', 'bar', 'follower', 'group:robot'])
        self.assertEqual(len({len(row) for row in rows}), 1)
        self.assertEqual(rows[1].split()[1:],
                         ['0.000000'] * 3 + ['0.500000', '1.000000', '1.500000'])
        self.assertNotIn('incomplete', out)

    def test_default_is_the_table_of_min_max_of_visuals(self):
        self.assertEqual(run('-'), run('-', '--geometry=visual', '--format=table',
                                       '--representation=min-max'))

    def test_robot_without_geometry(self):
        found = boxes(urdf=tree('<link name="base"></link>'))
        self.assertEqual(found, {'frame': 'base', 'boxes': {}, 'groups': {}, 'incomplete': {}})
        self.assertEqual(self.rows(urdf=tree('<link name="base"></link>')), [HEADER])


if __name__ == '__main__':
    main()
