#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_certificate accepts what urdf_bounds --pairs --certificate writes, and nothing that
is false: links that are always in contact.

Run as: certificate_contact_test.py PATH_OF_wrong_urdf_bounds PATH_OF_urdf_bounds
"""
import json
import os

from certificate_testing import (COARSE, REFUSED, box, check, is_leaf, lines_of, main, mesh,
                                 write_lines, write_wrong)
from urdf_bounds_pairs_test import ball, joint, link
from urdf_bounds_testing import UrdfBoundsTest, run


# Links in contact wherever the joints are: a ball, a drum and a mesh in a slab, a block that slides
# along it, and a plate that swings in a post. A link far away is between them, so none is adjacent.
CONTACT = '<robot name="contact">%s</robot>' % ''.join([
    link('base', ball(0.01, -9.0)), link('slab', box('3 3 1', '0.1 0 0', '0 0 0.3')),
    link('ball', ball(0.05, 1.0)), link('mesh', mesh('cube.stl', '0.8 0 0')),
    link('drum', '<origin xyz="0.5 0 0.3"/><geometry><cylinder radius="0.1" length="0.4"/>'
         '</geometry>'),
    link('block', box('1 1 1', '0 0 1')), link('post', ball(0.4, 5.0)),
    link('plate', box('0.2 0.01 0.2', '0.1 0 0')),
    joint('weld', 'fixed', 'base', 'slab'), joint('weld2', 'fixed', 'base', 'post'),
    joint('swing', 'revolute', 'base', 'ball'), joint('spin', 'continuous', 'base', 'drum'),
    joint('turn', 'revolute', 'base', 'mesh', '0 0 0.1', (0, 0.5)),
    joint('glide', 'prismatic', 'base', 'block', limits=(-0.01, 0)).replace('0 0 1', '1 0 0'),
    joint('flap', 'revolute', 'base', 'plate', '5 0 0')])


class ContactTest(UrdfBoundsTest):
    def setUp(self):
        super().setUp()
        self.urdf = self.write('contact.urdf', CONTACT)
        self.file = os.path.join(self.folder, 'contact.cert')

    def certificate(self, *arguments):
        """What is printed, by pair."""
        code, out, err = run(self.urdf, *COARSE, '--format', 'csv', '--certificate', self.file, *arguments)
        self.assertEqual(code, 0, err)
        rows = (line.split(',') for line in out.splitlines()[1:])
        return {(row[0], row[1]): row[2] for row in rows}

    def check_file(self, lines, code=REFUSED):
        write_lines(self.file, lines)
        found, text = check(self.file, self.urdf, '--all')
        self.assertEqual(found, code, text)
        return text

    def test_contact(self):
        found = self.certificate()
        self.assertEqual({found['slab', other] for other in ('ball', 'drum', 'mesh')}, {'ALWAYS'})
        self.assertEqual((found['slab', 'block'], found['post', 'plate']), ('TOUCHING', 'ALWAYS'))
        lines = lines_of(self.file)
        text = self.check_file(lines, 0)
        for verdict in ('NEVER', 'ALWAYS', 'TOUCHING'):
            count = list(found.values()).count(verdict)
            self.assertRegex(text, '[:,] %d %s[,;]' % (count, verdict))
        self.assertIn('TOUCHING: within 0.0001 m in all poses\n', text)
        lifted = self.write('lifted.urdf', CONTACT.replace('xyz="0.8 0 0"', 'xyz="0.8 0 3"'))
        code, text = check(self.file, lifted, '--all')
        self.assertRegex(text, 'refused: slab and mesh: .*not proven')
        self.damage_each(lines)

    def damage_each(self, good):
        for verdict in ('ALWAYS', 'TOUCHING'):
            which = next(i for i, line in enumerate(good)
                         if line.get('verdict') == verdict and len(line['tree']) > 1)
            good.insert(1, good.pop(which))  # checked first
            tree = good[1]['tree']
            leaf, split = (next(i for i, token in enumerate(tree) if is_leaf(token) == kind)
                           for kind in (True, False))
            point, other = tree[leaf]
            corner = [-9.0, -9.0, -9.0]
            for name, change in {
                    'far point': {leaf: [corner, other]},
                    'one point': {leaf: [point]}, 'text': {leaf: [['x', 0, 0], other]},
                    'no number': {leaf: [[float('nan'), 0, 0], other]},
                    'flat': {leaf: [point[:2], other]}, 'mesh': {leaf: 'mesh'},
                    'closed too early': {split: tree[leaf]}, 'unknown variable': {split: 9}}.items():
                with self.subTest(verdict=verdict, damage=name):
                    lines = json.loads(json.dumps(good))
                    for place, token in change.items():
                        lines[1]['tree'][place] = token
                    self.check_file(lines)
            for change in ({'distance': -1}, {'distance': 0.01}, {'verdict': 'NEVER'},
                           {'verdict': 'SOMETIMES'}, {'tree': []}):
                with self.subTest(verdict=verdict, damage=change):
                    lines = json.loads(json.dumps(good))
                    lines[1].update(change)
                    self.check_file(lines)

    def test_contact_of_one_pose_and_of_a_clearance(self):
        given = ['%s:=0.004' % name for name in ('swing', 'spin', 'turn', 'flap')] + ['glide:=0']
        found = self.certificate('--clearance', '0.2', *given)
        self.assertNotIn('TOUCHING', found.values())
        code, text = check(self.file, self.urdf, *given, '--all')
        self.assertEqual(code, 0, text)
        self.assertIn(' %d ALWAYS' % list(found.values()).count('ALWAYS'), text)

    def write_swing(self, solid):
        """A ball swings by up to 0.49 m to each side, 0.2 m below the middle of a solid."""
        self.urdf = self.write('swing.urdf', '<robot name="swing">%s</robot>' % ''.join([
            link('base', ball(0.01, -9.0)), link('large', '<geometry><%s/></geometry>' % solid),
            link('small', ball(0.01, 1.0)), joint('weld', 'fixed', 'base', 'large', '1 0 0.2'),
            joint('swing', 'revolute', 'base', 'small', limits=(-0.5, 0.5))]))

    def test_the_ball_leaves_a_solid_that_is_smaller(self):
        for solid, smaller in (
                ('sphere radius="0.66"', ['sphere radius="0.5"']),
                ('box size="1.32 1.32 1.32"', ['box size="1.32 0.6 1.32"',
                                               'box size="1.32 1.32 0.3"']),
                ('cylinder radius="0.66" length="1.32"', ['cylinder radius="0.45" length="1.32"',
                                                          'cylinder radius="0.66" length="0.3"'])):
            self.write_swing(solid)
            self.assertEqual(self.certificate()['large', 'small'], 'ALWAYS')
            self.assertEqual(check(self.file, self.urdf, '--all')[0], 0)
            for other in smaller:
                with self.subTest(other):
                    self.write_swing(other)
                    self.assertEqual(check(self.file, self.urdf, '--all')[0], REFUSED)

    def test_an_engine_whose_bodies_move_too_little(self):
        self.write_swing('sphere radius="0.66"')
        self.assertEqual(self.certificate()['large', 'small'], 'ALWAYS')
        code, text = check(self.file, self.urdf, '--all')
        self.assertEqual((code, ' 1 ALWAYS; 2 of 2 boxes' in text), (0, True), text)
        write_wrong(self.urdf, *COARSE, '--certificate', self.file)
        code, text = check(self.file, self.urdf, '--all')
        self.assertEqual(code, REFUSED, text)


if __name__ == '__main__':
    main()
