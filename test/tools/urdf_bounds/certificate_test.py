#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_certificate accepts what urdf_bounds --pairs --certificate writes, and nothing that
is false: links that never meet.

Run as: certificate_test.py PATH_OF_wrong_urdf_bounds PATH_OF_urdf_bounds
"""
import json
import os
import random
import re
from unittest import mock

from bad_inputs import SANITIZED
from certificate_testing import (ARM, BASE_RANGES, COARSE, DAMAGES, DEMO, INCOMPLETE,
                                 LONG_AXES, MOBILE, NOT_COUNTED, PUBLIC, REFUSED, box, check, cube_at, halved, is_leaf,
                                 lines_of, main, mesh, turned, write_lines, write_wrong)
from urdf_bounds_pairs_test import ball, joint, link
from urdf_bounds_testing import UrdfBoundsTest, run

NEAR = '0.42'  # metres; the base comes as near as 0.435 m
# Joints of the demo.
STILL = ('forearm_roll', 'wrist_roll', 'elbow_bend') + (('wrist_bend',) if SANITIZED else ())


class CertificateTest(UrdfBoundsTest):
    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)

    def certificate(self, urdf, *arguments):
        file = os.path.join(self.folder, 'file.cert')
        code, out, err = run(urdf, *COARSE, '--certificate', file, *arguments)
        self.assertEqual(code, 0, err)
        return file, out

    def accept(self, urdf, *arguments, given=()):
        """What is printed."""
        file, out = self.certificate(urdf, *given)
        joints = [argument for argument in given if ':=' in argument]
        code, text = check(file, urdf, *joints, *arguments)
        self.assertEqual(code, 0, text)
        self.assertIn(': %s NEVER;' % re.search(r'(\d+) NEVER,', out).group(1), text)
        return text

    def test_all_kinds_of_joints_and_shapes(self):
        text = self.accept(self.urdf, '--all')
        self.assertRegex(text, r'^arm, visual geometry, clearance 0 m: [1-9]\d* NEVER; (\d+) of \1 '
                               r'boxes were checked, and all of these hold\n')
        self.assertRegex(self.accept(self.urdf, '--sample', '1'), r' 6 NEVER; 6 of [1-9]\d+ boxes')

    def test_a_joint_that_mimics_with_a_factor_of_zero(self):
        """The range of the joint that it follows does not matter."""
        urdf = self.write('zero.urdf', ARM.replace('multiplier="-2"', 'multiplier="0"'))
        self.accept(urdf, '--all')

    def test_small_gaps(self):
        """A cylinder is a prism here, which must not be much wider."""
        for gap in (5e-5, 2e-4, 1e-3):
            for shape in ('<cylinder radius="0.1" length="0.2"/>', '<box size="0.2 0.2 0.2"/>'):
                urdf = self.write('gap.urdf', '<robot name="gap">%s</robot>' % ''.join([
                    link('base', '<geometry>%s</geometry>' % shape), link('arm'),
                    link('tip', box('0.1 0.1 0.1', '%r 0 0' % (0.15 + gap))),
                    joint('lift', 'prismatic', 'base', 'arm'),
                    joint('turn', 'revolute', 'arm', 'tip', limits=(-1e-4, 1e-4))]))
                self.accept(urdf, '--all')

    def test_a_scale_of_a_box_scales_nothing(self):
        """So the box that is drawn is larger, and comes nearer, than the certificate says."""
        def urdf(name, box_of_base):
            return self.write(name, '<robot name="scale">%s</robot>' % ''.join([
                link('base', '<geometry>%s</geometry>' % box_of_base), link('arm'),
                link('tip', box('0.1 0.1 0.1', '0.3 0 0')),
                joint('lift', 'prismatic', 'base', 'arm'),
                joint('turn', 'revolute', 'arm', 'tip', limits=(-0.1, 0.1))]))
        file, _ = self.certificate(urdf('small.urdf', '<box size="0.2 0.2 0.2"/>'))
        large = urdf('large.urdf', '<box size="1 0.2 0.2" scale="0.2 1 1"/>')
        self.assertEqual(check(file, large, '--all')[0], REFUSED)

    def test_ranges_of_three_dots(self):
        """-1...1 is not -1 to 0.1."""
        file, _ = self.certificate(self.urdf)
        with self.assertRaises(SystemExit) as ended:
            check(file, self.urdf, 'turn:=-1...1')
        self.assertEqual(ended.exception.code, 1)

    def test_pairs_that_were_taken_out(self):
        """The last line counts them; so does who knows the robot."""
        file, _ = self.certificate(self.urdf)
        head, _, *others, end = lines_of(file)
        with open(file, 'w', encoding='utf-8') as out:
            for line in (head, *others, dict(end, pairs=end['pairs'] - 1)):
                out.write(json.dumps(line) + '\n')
        code, text = check(file, self.urdf)
        self.assertEqual((code, 'the robot has 10 other pairs' in text), (REFUSED, True), text)
        alone = {'first': 'slide', 'second': 'slide', 'verdict': 'ALWAYS', 'distance': 1e-7,
                 'variables': [], 'tree': [[[0, 0, 0], [0, 0, 0]]]}
        with open(file, 'w', encoding='utf-8') as out:  # a link with itself, in place of a pair
            for line in (head, alone, *others, end):
                out.write(json.dumps(line) + '\n')
        self.assertEqual(check(file, self.urdf, '--all')[0], REFUSED)

    def test_pairs_that_nothing_counts(self):
        """A NEVER that is taken out is neither adjacent nor any other word."""
        file, _ = self.certificate(self.urdf)
        head, _, *others, end = lines_of(file)
        self.assertEqual(end['not_covered'], {'ADJACENT': 4})
        for counted in ({'ADJACENT': 5}, {'ADJACENT': 4}, {'ADJACENT': 4, 'SOMETIMES': 2},
                        {'ADJACENT': 4, 'SAFE': 1}, {'ADJACENT': 4, 'COLLIDES': 1}, *NOT_COUNTED,
                        *(dict(each, ADJACENT=4) for each in NOT_COUNTED[:8])):
            with self.subTest(counted):
                write_lines(file, [head, *others, dict(end, pairs=end['pairs'] - 1,
                                                       not_covered=counted)])
                code, text = check(file, self.urdf, '--all')
                self.assertEqual(code, REFUSED, text)
        write_lines(file, [head, *others, dict(end, pairs=end['pairs'] - 1, not_covered={
            'ADJACENT': 4, 'NEVER': 1})])
        self.assertEqual(check(file, self.urdf, '--all')[0], INCOMPLETE)

    def test_which_pairs_are_adjacent(self):
        """A link without geometry is looked through, and a fixed joint at it; no other link is."""
        for shape, pairs in (('', 1), (ball(0.05), 3)):
            urdf = self.write('bare.urdf', '<robot name="bare">%s</robot>' % ''.join([
                link('base', ball(0.1)), link('bare', shape), link('arm', ball(0.1, 2.0)),
                link('hand', ball(0.1)), joint('weld', 'fixed', 'base', 'bare', '0 0 0.5'),
                joint('turn', 'revolute', 'bare', 'arm'),
                joint('bend', 'revolute', 'arm', 'hand', '3 0 0')]))
            self.assertIn('pairs that are not in the file: ADJACENT 2\n', self.accept(urdf))
            file = os.path.join(self.folder, 'file.cert')
            head, *others, end = lines_of(file)
            self.assertEqual(len(others), pairs)
            for which in range(pairs):  # is not adjacent
                write_lines(file, [head, *others[:which], *others[which + 1:], dict(
                    end, pairs=pairs - 1, not_covered={'ADJACENT': 3})])
                code, text = check(file, urdf)
                self.assertEqual(code, REFUSED, text)
                self.assertIn('refused: only 2 of the pairs', text)

    def write_slide(self, limits, tree):
        """A box slides toward another one, and meets it 1 m from where its joint is at 0."""
        file = os.path.join(self.folder, 'slide.cert')
        write_lines(file, [
            {'certificate': 1, 'of': 'pairs', 'robot': 'slide', 'geometry': 'visual',
             'clearance': 0, 'touching': 1e-4, 'base': 'free', 'given': {}},
            {'first': 'base', 'second': 'box', 'verdict': 'NEVER', 'distance': 1e-6,
             'variables': ['slide'], 'tree': tree}, {'pairs': 1, 'not_covered': {}}])
        return file, self.write('slide.urdf', '<robot name="slide">%s</robot>' % ''.join([
            link('base', box('0.1 0.1 0.1', '0 0 1')), link('box', box('0.1 0.1 0.1')),
            joint('slide', 'prismatic', 'base', 'box', limits=limits)]))

    def test_boxes_are_drawn_by_their_size(self):
        """One that covers half of the range is seen, among a thousand others."""
        below = [0, 0, -1]
        paths = self.write_slide((-1, 1), [0, *halved(10, below), below])
        for seed in range(10):
            code, text = check(*paths, '--seed', str(seed))
            self.assertEqual((code, "around {'slide': 0.5}" in text), (REFUSED, True), text)
        code, text = check(*self.write_slide((-1, 0), halved(10, below)))
        self.assertEqual(code, 0, text)
        self.assertIn(': 1 NEVER; 20 of 1024 boxes were checked (--all checks the others), and all '
                      'of these hold\n', text)
        self.assertIn('; 1024 of 1024 boxes were checked, and', check(*paths, '--all')[1])
        with self.assertRaises(SystemExit):
            check(*paths, '--sample', '-1')

    def test_what_the_file_is_about_is_said(self):
        both = self.write('both.urdf', re.sub(
            '<visual>(.*?)</visual>', r'\g<0><collision>\1</collision>', ARM))
        for geometry, said in (('collision', 'collision'), ('both', 'visual and collision')):
            file, _ = self.certificate(both, '--geometry', geometry, '--clearance', '0.015625')
            text = check(file, both)[1]
            self.assertIn('arm, %s geometry, clearance 0.015625 m: ' % said, text)
        lines = lines_of(file)
        for geometry in ('inertial', 'none', '', None, ['visual']):
            write_lines(file, [dict(lines[0], geometry=geometry), *lines[1:]])
            self.assertEqual(check(file, both, '--allow-incomplete')[0], REFUSED)

    def test_ranges_that_the_user_gave(self):
        given = ('elbow:=0..0.5', 'push:=0.1')
        self.assertIn('; elbow:=0..0.5; push:=0.1..0.1\n', self.accept(self.urdf, given=given))
        file, _ = self.certificate(self.urdf, *given)
        for other in ((), given[:1], ('elbow:=0..0.6', 'push:=0.1')):
            code, text = check(file, self.urdf, *other)
            self.assertEqual(code, REFUSED)
            self.assertIn('elbow', text)

    def test_ranges_may_come_after_options(self):
        file, _ = self.certificate(self.urdf, 'elbow:=0..0.5')
        self.assertEqual(check(file, self.urdf, '--all', 'elbow:=0..0.5', '--seed', '1')[0], 0)

    def test_names_of_meshes_that_are_encoded(self):
        self.write('a cube.stl', 'solid cube\n%sendsolid\n' % cube_at((0, 0)))
        for name in ('a%20cube.stl', 'file://%s/a%%20cube.stl' % self.folder):
            urdf = self.write('mesh.urdf', '<robot name="mesh">%s</robot>' % ''.join([
                link('base', '<geometry><mesh filename="%s"/></geometry>' % name), link('arm'),
                link('tip', box('0.1 0.1 0.1', '3 0 0')),
                joint('lift', 'prismatic', 'base', 'arm'),
                joint('turn', 'revolute', 'arm', 'tip', limits=(-0.1, 0.1))]))
            self.accept(urdf)

    def test_descriptions_that_it_does_not_read(self):
        """urdf_bounds does."""
        for text in (ARM.replace('<robot ', '<robot xmlns="http://a" ', 1), ARM + '<!-- -->\0',
                     ARM.replace('</robot>', '<gazebo><a:b/></gazebo></robot>'),
                     '<?xml version="1.0" encoding="ISO-8859-1"?>' + ARM):
            urdf = self.write('odd.urdf', text)
            file, _ = self.certificate(urdf)
            code, said = check(file, urdf)
            self.assertEqual((code, 'odd.urdf' in said), (INCOMPLETE, True), said)

    def test_floating_and_planar_joints(self):
        """About a tilted axis, too."""
        with open(MOBILE, encoding='utf-8') as file:
            tilted = file.read().replace('<axis xyz="0 0 1"/>', '<axis xyz="-0.2 0.1 0.9"/>')
        for urdf in (MOBILE, self.write('tilted.urdf', tilted)):
            with self.subTest(urdf):
                text = self.accept(urdf, '--all', given=(*BASE_RANGES, '--clearance', '0.15'))
                self.assertRegex(text, r' 6 NEVER; ([1-9]\d+) of \1 boxes.*; drive.x:=-0.5..0.1; ')
                # The same, but y and yaw of the plane are turned around.
                other = self.write('other.urdf', tilted.replace('-0.2 0.1 0.9', '0 0 -1'))
                code, found = check(os.path.join(self.folder, 'file.cert'), other, *BASE_RANGES, '--all')
                self.assertEqual(code, REFUSED, found)

    def test_axes_of_any_length(self):
        """Squares of these numbers vanish, or are infinite."""
        with open(MOBILE, encoding='utf-8') as file:
            mobile = file.read()
        for axis in LONG_AXES:
            with self.subTest(axis):
                self.accept(self.write('long.urdf', ARM.replace('0 0 1"/>', axis + '"/>')), '--all')
                planar = mobile.replace('<axis xyz="0 0 1"/>', '<axis xyz="%s"/>' % axis)
                self.accept(self.write('planar.urdf', planar), given=BASE_RANGES)

    def test_another_robot(self):
        """What holds would be said of the name in the file."""
        file, _ = self.certificate(self.urdf)
        lines = lines_of(file)
        for name in ('panda', 'arm ', '', 'two\nlines'):
            write_lines(file, [dict(lines[0], robot=name), *lines[1:]])
            code, text = check(file, self.urdf)
            self.assertEqual((code, text), (REFUSED, 'refused: it is about the robot %s, but the robot of '
                                            '%s is "arm"; give its own URDF\n' % (
                                                json.dumps(name), self.urdf)))
        for name in ('t\u00fcr &amp; &quot;tor&quot;', 'two\nlines', ' a\tb '):
            urdf = self.write('name.urdf', ARM.replace('name="arm"', 'name="%s"' % name))
            self.accept(urdf)

    def test_a_base_that_is_fixed(self):
        self.accept(MOBILE, '--all', '--base', 'fixed', given=('--base', 'fixed'))
        code, text = check(os.path.join(self.folder, 'file.cert'), MOBILE)
        self.assertEqual(code, REFUSED)
        self.assertIn('see --base', text)
        # What floats behind a joint is no base, so three pairs are open; the hand is adjacent.
        lines = lines_of(os.path.join(self.folder, 'file.cert'))
        write_lines(os.path.join(self.folder, 'file.cert'), lines[:-1] + [
            dict(lines[-1], not_covered={'ADJACENT': 3, 'SOMETIMES': 1})])
        with open(MOBILE, encoding='utf-8') as file:
            carried = file.read().replace('<parent link="world"/><child link="part"/>',
                                          '<parent link="hand"/><child link="part"/>')
        carried = self.write('carried.urdf', carried)
        code, text = check(os.path.join(self.folder, 'file.cert'), carried, '--base', 'fixed')
        self.assertEqual(code, INCOMPLETE, text)
        self.assertEqual(text.count('joint carry.x has no range'), 3)

    def test_shapes_that_no_direction_tells_apart(self):
        """A ball inside of a ring: only single shapes or triangles show that they are apart."""
        places = [(0.3, 0), (-0.3, 0), (0, 0.3), (0, -0.3)]
        solids = '</visual><visual>'.join(box('0.1 0.1 0.1', '%g %g 0' % place) for place in places)
        stl = self.write('ring.stl', 'solid ring\n%sendsolid\n' % ''.join(map(cube_at, places)))
        for ring, kind in ((solids, list), (
                '<geometry><mesh filename="%s"/></geometry>' % os.path.basename(stl), str)):
            with self.subTest(kind):
                text = '<robot name="ring">%s</robot>' % ''.join([
                    link('ring', ring), link('arm', ball(0.01)), link('ball', ball(0.05)),
                    joint('turn', 'revolute', 'ring', 'arm', '0 0 0.02'),
                    joint('bend', 'revolute', 'arm', 'ball', '0.01 0 0')])
                urdf = self.write('ring.urdf', text)
                self.accept(urdf, '--all')
                path = os.path.join(self.folder, 'file.cert')
                with open(path, encoding='utf-8') as file:
                    head, pair, *rest = [json.loads(line) for line in file]
                leaves = [token for token in pair['tree'] if is_leaf(token)]
                self.assertTrue(all(isinstance(leaf, kind) for leaf in leaves))
                pair['distance'] = 0.21  # metres; farther than the ball is from the ring
                with open(path, 'w', encoding='utf-8') as file:
                    file.writelines(json.dumps(line) + '\n' for line in (head, pair, *rest))
                code, found = check(path, urdf, '--all')
                self.assertEqual(code, REFUSED)
                self.assertIn('not proven around', found)

    def test_demo(self):
        given = tuple('%s:=0.3' % name for name in STILL)
        file, _ = self.certificate(DEMO, *given)
        code, text = check(file, DEMO, *given)
        self.assertEqual(code, INCOMPLETE, 'OBJ and Collada are not read')
        self.assertRegex(text, r': [1-9]\d NEVER[;,] ')
        self.assertIn('.obj is no STL file', text)
        self.assertEqual(check(file, DEMO, *given, '--allow-incomplete')[0], 0)

    def test_public_robots(self):
        data = os.environ.get('LINK_BOUNDS_DATA')
        if not data:
            print('skipped: certificates of public robots: LINK_BOUNDS_DATA is not set')
            return
        for name, sample in PUBLIC.items():
            with self.subTest(name), mock.patch.dict(os.environ, ROS_PACKAGE_PATH=data + '/robots'):
                urdf = os.path.join(data, 'robots', name)
                file, _ = self.certificate(urdf, '--geometry', 'collision')
                code, text = check(file, urdf, '--sample', sample)
                self.assertEqual(code, 0, text)
                self.assertNotIn('no pairs', text)

    def test_what_is_not_in_the_file(self):
        file = os.path.join(self.folder, 'late.cert')
        code, _, err = run(self.urdf, *COARSE[:3], '--certificate', file, '--budget', '1e-9')
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('UNDECIDED pairs', err)
        self.assertEqual(check(file, self.urdf)[0], INCOMPLETE)
        # Before the search: that would warn of what it did not decide.
        self.check_refused('cannot write', self.urdf, *COARSE[:3], '--budget', '1e-9',
                           '--certificate', os.path.join(self.folder, 'none/x'))
        self.check_refused('--certificate is an option of --reach, --pairs or --path', self.urdf,
                           '--certificate', file)

    def test_an_engine_whose_bodies_move_too_little(self):
        """By a tenth, at a clearance for which boxes are as large as they may be."""
        self.assertIn(' 6 NEVER', self.accept(self.urdf, '--all', given=('--clearance', NEAR)))
        file = os.path.join(self.folder, 'wrong.cert')
        write_wrong(self.urdf, *COARSE, '--clearance', NEAR, '--certificate', file)
        code, text = check(file, self.urdf, '--all')
        self.assertEqual(code, REFUSED, text)
        self.assertIn('not proven around', text)


class DamageTest(UrdfBoundsTest):
    """Each damage makes the file false or malformed."""

    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)
        self.file = os.path.join(self.folder, 'good.cert')
        self.assertEqual(run(self.urdf, *COARSE, '--certificate', self.file)[0], 0)
        self.lines = lines_of(self.file)
        self.random = random.Random(1)

    def some(self, tree, kind):
        return self.random.choice([i for i, token in enumerate(tree) if is_leaf(token) == kind])

    def damage(self, lines):
        """Its name."""
        pair = self.random.choice([line for line in lines[1:-1] if len(line['tree']) > 4])
        lines.remove(pair)
        lines.insert(1, pair)  # checked first
        tree = pair['tree']
        leaf, split = self.some(tree, True), self.some(tree, False)
        other = self.random.choice([line for line in lines[1:-1] if line is not pair])
        damages = {
            'turned direction': lambda: tree.__setitem__(leaf, turned(tree[leaf])),
            'no direction': lambda: tree.__setitem__(leaf, [0, 0, 0]),
            'direction of text': lambda: tree.__setitem__(leaf, ['x', 0, 1]),
            'no unit': lambda: tree.__setitem__(leaf, [self.random.choice((1e200, 1e-200)), 0, 0]),
            'not a number': lambda: tree.__setitem__(leaf, [float('nan'), 0, 1]),
            'missing leaf': lambda: tree.pop(leaf),
            'further leaf': lambda: tree.insert(leaf, tree[leaf]),
            'unknown variable': lambda: tree.__setitem__(split, len(pair['variables'])),
            'negative variable': lambda: tree.__setitem__(split, -1),
            'a box is closed too early': lambda: tree.__setitem__(split, [0, 0, 1]),
            'end of the tree': lambda: tree.__delitem__(slice(split, None)),
            'no tree': tree.clear,
            'clearance': lambda: pair.update(distance=self.random.uniform(5, 50)),
            'no clearance': lambda: pair.update(distance=0),
            'other verdict': lambda: pair.update(verdict='ALWAYS'),
            'negative clearance': lambda: lines[0].update(clearance=-1),
            'other goal': lambda: lines[0].update(clearance=100),
            'unknown link': lambda: pair.update(second='none'),
            'same link': lambda: pair.update(second=pair['first']),
            'pair twice': lambda: lines.insert(1, pair),
            'pair missing': lambda: lines.remove(pair),
            'tree of another pair': lambda: pair.update(tree=other['tree'] + [[0, 0, 1]]),
            'narrow range': lambda: lines[0]['given'].update(elbow=[0, 0.1]),
            'other geometry': lambda: lines[0].update(geometry='collision'),
            'fewer variables': lambda: pair['variables'].pop(),
            'other version': lambda: lines[0].update(certificate=2),
            'no end': lines.pop,
            'other end': lambda: lines[-1].update(pairs=1)}
        name = self.random.choice(sorted(damages))
        damages[name]()
        return name

    def test_damages(self):
        self.assertEqual(check(self.file, self.urdf, '--all')[0], 0)
        file, seen = os.path.join(self.folder, 'bad.cert'), set()
        for number in range(DAMAGES):
            lines = json.loads(json.dumps(self.lines))
            name = self.damage(lines)
            seen.add(name)
            write_lines(file, lines)
            with self.subTest(number=number, damage=name):
                code, text = check(file, self.urdf, '--all')
                self.assertEqual(code, REFUSED, text)
        self.assertGreater(len(seen), 20 if DAMAGES == 200 else 8)

    def test_truncated_files(self):
        with open(self.file, 'rb') as file:
            data = file.read()
        bad = os.path.join(self.folder, 'bad.cert')
        for share in (0, 0.1, 0.5, 0.9, 0.999):
            with open(bad, 'wb') as file:
                file.write(data[:int(share * len(data))])
            self.assertEqual(check(bad, self.urdf)[0], REFUSED)


if __name__ == '__main__':
    main()
