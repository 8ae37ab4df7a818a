#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_certificate accepts what urdf_bounds --path --certificate writes, and nothing that
is false.

Run as: certificate_path_test.py PATH_OF_wrong_urdf_bounds PATH_OF_urdf_bounds
"""
import json
import os

from certificate_testing import (ARM, INCOMPLETE, MOBILE, NOT_COUNTED, REFUSED, UNUSABLE, box, check,
                                 halved, is_leaf, lines_of, main, turned, write_lines, write_wrong)
from urdf_bounds_pairs_test import joint, link
from urdf_bounds_testing import UrdfBoundsTest, run

import certificate_path  # of scripts, which certificate_testing adds to the path


def split_pair(lines):
    """Of the first segment, the pair with the most boxes."""
    return max(lines[1]['pairs'], key=lambda pair: len(pair['tree']))


class PathTest(UrdfBoundsTest):
    """The arm passes a ball, which further turns or higher speeds would hit."""
    LINEAR = 'shoulder,elbow,push\n0,0,0.1\n1,0.2,0.2\n0.8,-0.4,0\n'
    CUBIC = ('time,shoulder,shoulder.velocity,elbow,elbow.velocity\n0,0,0,0,0\n1,1,0.2,0.3,-0.5\n'
             '3,0.2,0,0,0\n')
    QUINTIC = ('time,shoulder,shoulder.velocity,shoulder.acceleration\n0,0,0,0\n1,0.7,0.5,-1\n'
               '2,0.5,0,0\n')
    FAST = {LINEAR: ('\n1,', '\n2.2,'), CUBIC: ('1,1,0.2', '1,1,-9'), QUINTIC: ('0.7,0.5,-1', '0.7,0.5,90')}
    OBJECTS = ('ball: {type: SPHERE, pose: {position: {x: -0.2, y: 1.1, z: 0.3}}, '
               'scale: {x: 0.3, y: 0.3, z: 0.3}}\n'
               'block: {type: CUBE, pose: {position: {x: 1.8, y: 0, z: 0.3}, orientation: {z: 1, w: 2}}, '
               'scale: {x: 0.2, y: 0.1, z: 0.3}}\n'
               'post: {type: CYLINDER, pose: {position: {x: 0.9, y: -1.2}}, scale: {x: 0.1, y: 0.1, z: 2}}\n')

    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)
        self.objects = self.write('objects.yaml', self.OBJECTS)
        self.file = os.path.join(self.folder, 'path.cert')

    def check_table(self, table, code, *arguments):
        found, text = check(self.file, self.urdf, '--poses', self.write('checked.csv', table),
                            '--objects', self.objects, '--all', *arguments)
        self.assertEqual(found, code, text)
        return text

    def write_certificate(self, table, *arguments):
        code, out, err = run(self.urdf, '--poses', self.write('path.csv', table), '--path', '--objects',
                             self.objects, '--certificate', self.file, *arguments)
        self.assertEqual(code, 0, out + err)

    def test_a_table_with_remarks(self):
        """And with a column of words, which is no joint."""
        table = '# a remark\nshoulder,label,elbow,push\n0,a,0,0.1\n \n1,b,0.2,0.2\n0.8,,-0.4,0\n'
        self.write_certificate(table)
        self.check_table(table, 0)

    def test_a_table_without_a_line_of_names(self):
        names, rows = self.LINEAR.split('\n', 1)
        self.write_certificate(rows, '--columns', names)
        for table in (rows, '0,0\n0.1,0.2\n', '# a remark\n'):
            text = self.check_table(table, UNUSABLE)
            self.assertRegex(text, r'^error: .*no column of a joint; .* --columns A,B\n$')
        self.check_table(rows, 0, '--columns', names)
        self.check_table(self.LINEAR, 0)
        self.assertIn('not proven', self.check_table(rows, REFUSED, '--columns', 'elbow,shoulder,push'))

    def test_a_quote_in_a_remark_hides_no_row(self):
        remark = '# then, "home\n'
        self.write_certificate(self.LINEAR)
        self.assertIn('3 segments', self.check_table(self.LINEAR + remark + '2.2,0.2,0.2\n', REFUSED))
        first, rest = self.LINEAR.split('\n', 1)
        self.check_table(first + '\n' + remark + rest, 0)

    def test_what_an_srdf_exempts(self):
        file = self.write('arm.srdf', '<robot name="arm"><old><disable_collisions link1="a" link2="b"/></old>'
                          '<disable_collisions link1="c" link2="d"/></robot>')
        self.assertEqual(certificate_path.disabled(file, set()), {frozenset('cd')})

    def test_an_srdf_exempts_no_object(self):
        """urdf_bounds refuses one that names what is no link."""
        ball, others = self.OBJECTS.split('\n', 1)
        self.objects = self.write('others.yaml', others)
        self.write_certificate(self.LINEAR)
        self.objects = self.write('all.yaml', ball + '\n' + others)
        for text in ('<disable_default_collisions link="ball"/>', ''.join(
                '<disable_collisions link1="%s" link2="ball"/>' % name
                for name in ('upper', 'lower', 'slide', 'tower'))):
            srdf = self.write('arm.srdf', '<robot name="arm">%s</robot>' % text)
            self.assertIn('a pair is missing', self.check_table(self.LINEAR, REFUSED, '--srdf', srdf))

    CUBE = 'cube: {type: CUBE, pose: {position: {y: 5.6}}, scale: {x: 8, y: 8, z: 8}}\n'

    def test_numbers_of_objects_are_those_of_urdf_bounds(self):
        """For other readers of YAML, 010 is 8: so large, the cube is 0.4 m away."""
        self.objects = self.write('cube.yaml', self.CUBE)
        self.write_certificate(self.LINEAR)
        self.check_table(self.LINEAR, 0)
        self.objects = self.write('octal.yaml', self.CUBE.replace('8', '010'))
        code, out, _ = run(self.urdf, '--poses', self.write('path.csv', self.LINEAR), '--path',
                           '--objects', self.objects)
        self.assertEqual((code, 'COLLIDES' in out), (3, True), out)
        self.check_table(self.LINEAR, REFUSED)
        self.objects = self.write('same.yaml', self.CUBE.replace('8', '"+08.e+0"'))
        self.write_certificate(self.LINEAR)
        self.check_table(self.LINEAR, 0)

    def test_objects_that_urdf_bounds_refuses(self):
        self.objects = self.write('cube.yaml', self.CUBE)
        self.write_certificate(self.LINEAR)
        scale = 'scale: {x: 8, y: 8, z: 8}'
        for words, old, new in (
                ('must be a number', 'x: 8', 'x: 0x8'), ('must be a number', 'x: 8', 'x: 8_'),
                ('must be a number', 'x: 8', 'x: 0b1000'), ('must be a number', 'y: 5.6', 'y: 5_.6'),
                ('must be a number', 'y: 5.6', 'y: " 5.6"'), ('must be a number', '5.6', '.inf'),
                ('must be a number', ', z: 8', ''), ('there twice', 'x: 8', 'x: 9, x: 8'),
                ('there twice', 'cube', self.CUBE + 'cube'), ('is negative', 'x: 8', 'x: -8'),
                ('may have', scale, 'scale: {<<: {x: 8, y: 8}, z: 8}'),
                ('may have', 'type', 'colour: red, type'), ('may have', scale, 'scale: [8, 8, 8]'),
                ('no size', ', ' + scale, ''), ('no size', 'type', 'mesh_resource: a.stl, type'),
                ('several documents', 'cube', self.CUBE + '---\ncube'), ('is no YAML', 'type', '{'),
                ('has no objects', self.CUBE, '# none\n'), ('of the type "CONE"', 'CUBE', 'CONE')):
            with self.subTest(new):
                self.objects = self.write('bad.yaml', self.CUBE.replace(old, new))
                self.assertIn(words, self.check_table(self.LINEAR, REFUSED))
                code, _, err = run(self.urdf, '--poses', self.write('path.csv', self.LINEAR), '--path',
                                   '--objects', self.objects)
                self.assertEqual(code, 1, err)

    def test_orientations_of_any_length(self):
        for size in ('e-200', 'e200', 'e-320'):
            with self.subTest(size):
                self.objects = self.write('turned.yaml', self.OBJECTS.replace(
                    '{z: 1, w: 2}', '{z: 1%s, w: 2%s}' % (size, size)))
                self.write_certificate(self.LINEAR)
                self.check_table(self.LINEAR, 0)

    def test_interpolations(self):
        for table, (old, new) in self.FAST.items():
            with self.subTest(table):
                self.write_certificate(table)
                self.assertRegex(self.check_table(table, 0), r': 2 segments; (\d+) of \1 boxes were')
                fast = table.replace(old, new)
                code, out, _ = run(self.urdf, '--poses', self.write('fast.csv', fast), '--path',
                                   '--objects', self.objects)
                self.assertIn('COLLIDES', out)
                self.assertIn('not proven', self.check_table(fast, REFUSED))

    def test_a_base_that_drives(self):
        self.urdf = MOBILE
        table = ('drive.x,drive.y,drive.yaw,lift,carry.x,carry.pitch\n-0.5,0,0,0,-0.5,0.2\n'
                 '0,0.2,0.4,0.1,-0.6,-0.3\n0.2,0.1,-0.4,0,-0.6,0\n')
        self.write_certificate(table)
        self.check_table(table, 0)
        self.assertIn('not proven', self.check_table(table.replace('\n0,', '\n0.9,'), REFUSED))

    def test_an_engine_whose_bodies_move_too_little(self):
        for table in self.FAST:
            with self.subTest(table):
                arguments = (self.urdf, '--poses', self.write('path.csv', table), '--path',
                             '--objects', self.objects)
                found = json.loads(run(*arguments, '--format', 'json')[1])
                nearest = min(segment['clearance'] for segment in found['segments'])
                write_wrong(*arguments, '--clearance', repr(0.999 * nearest), '--certificate', self.file)
                self.assertIn('not proven', self.check_table(table, REFUSED))

    def test_damages(self):
        self.write_certificate(self.LINEAR)
        good = lines_of(self.file)
        said = {'no distance': "row 1 and row 2: the file is damaged: 'distance' is missing",
                'no counts': "refused: the file is damaged: 'not_covered' is missing",
                'words': 'row 1 and row 2: the file is damaged: urdf_bounds writes no such value (',
                'no clearance': 'refused: row 1 and row 2: there is no such segment\n'}
        for name, damage in {
                'no distance': lambda lines: lines[1].pop('distance'),
                'no counts': lambda lines: lines[-1].pop('not_covered'),
                'words': lambda lines: lines[1].update(distance='far'),
                'larger clearance': lambda lines: lines[1].update(distance=1),
                'no clearance': lambda lines: lines[1].update(distance=0),
                'other segment': lambda lines: lines[1].update({'from': 3, 'to': 4}),
                'longer segment': lambda lines: lines[1].update(to=3),
                'segment twice': lambda lines: lines.insert(1, lines[1]),
                'segment missing': lambda lines: (lines.pop(1), lines[-1].update(segments=1)),
                'pair missing': lambda lines: lines[1]['pairs'].pop(),
                'pair twice': lambda lines: lines[1]['pairs'].append(lines[1]['pairs'][0]),
                'closed too early': lambda lines: split_pair(lines).update(tree=[[0, 1, 0]]),
                'turned': lambda lines: split_pair(lines).update(
                    tree=[turned(each) if is_leaf(each) else each for each in split_pair(lines)['tree']]),
                'end of the tree': lambda lines: split_pair(lines)['tree'].pop(),
                'further leaf': lambda lines: split_pair(lines)['tree'].append([0, 0, 1]),
                'other variable': lambda lines: split_pair(lines)['tree'].__setitem__(0, 1),
                'other kind': lambda lines: lines[0].update(of='pairs'),
                'no end': lambda lines: lines.pop()}.items():
            with self.subTest(name):
                lines = json.loads(json.dumps(good))
                damage(lines)
                write_lines(self.file, lines)
                text = self.check_table(self.LINEAR, REFUSED)
                self.assertNotRegex(text, 'Error|Refused')  # names of Python
                self.assertIn(said.get(name, 'refused: '), text)

    def test_what_is_not_in_the_file(self):
        table = self.LINEAR + '2.2,0,0\n'
        code, _, err = run(self.urdf, '--poses', self.write('path.csv', table), '--path', '--objects',
                           self.objects, '--certificate', self.file)
        self.assertEqual(code, 3, err)
        self.assertIn('segments that are not in the file: COLLIDES 1', self.check_table(table, 0))
        self.check_table(self.LINEAR, REFUSED)
        self.assertEqual(check(self.file, self.urdf)[0], REFUSED)
        *lines, end = lines_of(self.file)
        for counted in (*NOT_COUNTED, {'NEVER': 1}, {'none': 1}, {'COLLIDES': 2}, {}):
            write_lines(self.file, [*lines, dict(end, not_covered=counted)])
            self.check_table(table, REFUSED)
        write_lines(self.file, [*lines, dict(end, not_covered={'UNDECIDED': 1})])
        self.check_table(table, INCOMPLETE)

    def test_boxes_are_drawn_by_their_size(self):
        """One that covers half of the time is seen, among a thousand others."""
        urdf = self.write('slide.urdf', '<robot name="slide">%s</robot>' % ''.join([
            link('base'), link('box', box('0.1 0.1 0.1')),
            joint('slide', 'prismatic', 'base', 'box')]))
        self.objects = self.write('block.yaml', 'block: {type: CUBE, pose: {position: {z: 1}}, '
                                  'scale: {x: 0.1, y: 0.1, z: 0.1}}\n')
        above = [0, 0, 1]
        for end, tree, code in ((1, [0, *halved(10, above), above], REFUSED),
                                (0, halved(10, above), 0)):
            write_lines(self.file, [
                {'certificate': 1, 'of': 'path', 'robot': 'slide', 'geometry': 'visual',
                 'clearance': 0, 'touching': 1e-4, 'base': 'free', 'given': {}},
                {'from': 1, 'to': 2, 'distance': 1e-6, 'pairs': [
                    {'first': 'box', 'second': 'block', 'tree': tree}]},
                {'segments': 1, 'not_covered': {}}])
            table = self.write('slide.csv', 'slide\n-1\n%d\n' % end)
            for seed in range(4):
                found, text = check(self.file, urdf, '--poses', table, '--objects', self.objects,
                                    '--seed', str(seed))
                self.assertEqual(found, code, text)
        self.assertIn('slide, visual geometry, clearance 0 m: 1 segments; 20 of 1024 boxes were '
                      'checked (--all checks the others), and all of these hold\n', text)


if __name__ == '__main__':
    main()
