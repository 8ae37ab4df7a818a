#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_certificate accepts what urdf_bounds --reach --certificate writes, and nothing that
is false.

Run as: certificate_reach_test.py PATH_OF_wrong_urdf_bounds PATH_OF_urdf_bounds
"""
import json
import os
import random
from unittest import mock

from certificate_testing import (ARM, BASE_RANGES, DAMAGES, DEMO, INCOMPLETE, LONG_AXES, MOBILE,
                                 NOT_COUNTED, PUBLIC, REFUSED, UNUSABLE, box, check, lines_of, main,
                                 write_lines, write_wrong)
from urdf_bounds_pairs_test import joint, link
from urdf_bounds_testing import UrdfBoundsTest, run

import certificate_robot  # of scripts, which certificate_testing adds to the path

REACH = ('--reach', '--accuracy', '0.05', '--budget', '1000', '--format', 'json')


class ReachTest(UrdfBoundsTest):
    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)

    def certificate(self, urdf, *arguments):
        """The file, and the JSON that is printed."""
        file = os.path.join(self.folder, 'reach.cert')
        code, out, err = run(urdf, *REACH, '--certificate', file, *arguments)
        self.assertEqual(code, 0, err)
        return file, json.loads(out)

    def test_all_kinds_of_joints_and_shapes(self):
        file, result = self.certificate(self.urdf)
        code, text = check(file, self.urdf, '--all')
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r'^arm, visual geometry: 5 links; (\d+) of \1 supports were checked')
        self.assertRegex(check(file, self.urdf, '--sample', '1')[1],
                         r' 5 links; \d+ of \d+ supports were checked \(--all checks the others\)')
        for entry in lines_of(file)[1:-1]:
            proven = result['reach'][entry['link']]
            for i in range(3):
                for inner, outer in ((proven['min'][i], entry['min'][i]),
                                     (-proven['max'][i], -entry['max'][i])):
                    self.assertGreaterEqual(inner, outer)
                    self.assertLessEqual(inner - outer, entry['slack'] + 1e-9)
            self.assertLessEqual(entry['slack'], float(REACH[2]))

    def test_a_link_without_a_part_of_its_geometry(self):
        part = link('tip', box('0.1 0.1 0.1') +
                    '</visual><visual><geometry><mesh filename="gone.stl"/></geometry>')
        urdf = self.write('part.urdf', '<robot name="part"><link name="root"/>' + part +
                          joint('turn', 'revolute', 'root', 'tip') + '</robot>')
        file = os.path.join(self.folder, 'part.cert')
        self.assertEqual(run(urdf, *REACH, '--certificate', file)[0], INCOMPLETE)
        code, text = check(file, urdf, '--all')
        self.assertEqual(code, INCOMPLETE, text)
        self.assertIn('links that are not in the file: 1', text)

    def test_a_joint_that_follows_itself(self):
        joints = [joint(name, 'revolute', parent, child).replace(
            '<axis', '<mimic joint="%s"/><axis' % other)
                  for name, parent, child, other in (('one', 'a', 'b', 'two'), ('two', 'b', 'c', 'one'))]
        urdf = self.write('circle.urdf', '<robot name="circle"><link name="a"/><link name="b"/>'
                          '<link name="c"/>%s</robot>' % ''.join(joints))
        with self.assertRaisesRegex(certificate_robot.NotCovered, 'follows itself'):
            certificate_robot.Robot(urdf, {}).lead('one')

    def test_ranges_that_the_user_gave(self):
        given = ('elbow:=0..0.5', 'push:=0.1')
        file, _ = self.certificate(self.urdf, *given)
        self.assertEqual(check(file, self.urdf, *given, '--all')[0], 0)
        self.assertEqual(check(file, self.urdf)[0], REFUSED)

    def test_floating_and_planar_joints(self):
        for given in (BASE_RANGES, ('--base', 'fixed')):
            with self.subTest(given):
                file, result = self.certificate(MOBILE, *given)
                code, text = check(file, MOBILE, *given, '--sample', '100')
                self.assertEqual(code, 0, text)
                self.assertIn(': %d links; ' % len(result['reach']), text)
                lines = lines_of(file)
                part = next(line for line in lines if line.get('link') == 'part')
                part['min'][2] += 1e-3
                write_lines(file, lines)
                self.assertEqual(check(file, MOBILE, *given)[0], REFUSED)

    def test_axes_of_any_length(self):
        for axis in LONG_AXES + ('1e200 0 1e200', '2e-308 1e-320 -3e-310'):
            with self.subTest(axis):
                urdf = self.write('long.urdf', ARM.replace('0 0 1"/>', axis + '"/>'))
                file, _ = self.certificate(urdf)
                code, text = check(file, urdf, '--sample', '100')
                self.assertEqual(code, 0, text)

    def test_what_the_box_rests_on_is_checked(self):
        """The box and the first table are too small along +x alone, by 0.3 m. A joint that slides
        along x needs one entry for that, one that turns about z those around it."""
        for first, axis, second in (('prismatic', '1 0 0', 'revolute'),
                                    ('revolute', '0 0 1', 'prismatic')):
            urdf = self.write('gantry.urdf', '<robot name="gantry">%s</robot>' % ''.join([
                link('base'), link('car'), link('arm', box('1 0.1 0.1', '0.5 0 0')),
                joint('first', first, 'base', 'car').replace('0 0 1', axis),
                joint('second', second, 'car', 'arm')]))
            file, _ = self.certificate(urdf)
            self.assertEqual(check(file, urdf)[0], 0)
            lines = lines_of(file)
            side, table = lines[1]['cells'] + 1, lines[1]['tables'][0]
            middle = side // 2
            for j in range(middle - 1, middle + 2):  # of the first face
                table[j * side + middle] -= round(0.3 / lines[1]['step'])
            lines[1]['max'][0] -= 0.29 if first == 'prismatic' else 0
            write_lines(file, lines)
            for seed in range(5):
                code, text = check(file, urdf, '--seed', str(seed))
                self.assertEqual((code, 'before joint 1' in text), (REFUSED, True), text)

    def test_a_joint_that_follows_a_fixed_one(self):
        """It stands at its offset, in proofs of reach and of pairs."""
        urdf = self.write('rest.urdf', '<robot name="rest">%s</robot>' % ''.join([
            link('base'), link('hand', box('1 0.1 0.1', '2 0 0')), link('arm', box('1 1 1')),
            link('plate'), joint('bolt', 'fixed', 'base', 'plate'),
            joint('swing', 'revolute', 'plate', 'hand'),
            joint('turn', 'revolute', 'base', 'arm').replace(
                '</joint>', '<mimic joint="bolt" multiplier="2" offset="0.3"/></joint>')]))
        file, _ = self.certificate(urdf)
        self.assertEqual(check(file, urdf, '--all')[0], 0)
        run(urdf, '--pairs', '--certificate', file)
        code, text = check(file, urdf)
        self.assertEqual((code, '1 NEVER; ' in text), (0, True), text)

    def test_a_loop_of_joints(self):
        """Beside the tree; urdf_bounds refuses it."""
        file, _ = self.certificate(self.urdf)
        urdf = self.write('loop.urdf', '<robot name="arm">%s</robot>' % ''.join([
            link('base'), link('a'), link('b'), joint('first', 'revolute', 'a', 'b'),
            joint('second', 'revolute', 'b', 'a')]))
        for options in ('--base', 'fixed'), ():
            code, text = check(file, urdf, *options)
            self.assertEqual((code, 'are a loop' in text), (UNUSABLE, True), text)

    def test_a_box_of_which_two_readers_see_another(self):
        """A file with a member twice, and one whose corners have six numbers in all."""
        file, _ = self.certificate(self.urdf)
        with open(file, encoding='utf-8') as lines:
            text = lines.read()
        for wrong in '"max": [0, 0, 0], "max": [', '"min": [0, 0, 0], "max": [':
            bad = self.write('bad.cert', text.replace('"max": [', wrong, 1))
            self.assertEqual(check(bad, self.urdf)[0], REFUSED, wrong)
        lines = lines_of(file)
        corners = lines[1]
        corners['min'] = [-x for x in corners['max'][2:]] + corners['min']
        corners['max'] = corners['max'][:2]
        write_lines(file, lines)
        code, text = check(file, self.urdf, '--all')
        self.assertEqual((code, 'three numbers' in text), (REFUSED, True), text)

    def test_an_element_with_two_shapes_or_none(self):
        """urdf_bounds takes the first shape, and this program none of both."""
        def urdf(shapes):
            return self.write('two.urdf', '<robot name="two">%s</robot>' % ''.join([
                link('base', box('1 1 1')), link('arm', shapes),
                joint('turn', 'revolute', 'base', 'arm')]))
        cylinder, large = '<cylinder radius="0.1" length="0.2"/>', '<box size="1 1 1"/>'
        file, _ = self.certificate(urdf('<geometry>%s</geometry>' % cylinder))
        self.assertEqual(check(file, urdf('<geometry>%s</geometry>' % cylinder), '--all')[0], 0)
        for shapes in ('<geometry>%s%s</geometry>' % (large, cylinder), '<geometry/>', '<origin/>',
                       '<geometry>%s%s</geometry>' % (cylinder, large)):
            code, text = check(file, urdf(shapes), '--all')
            self.assertEqual((code, 'not checked: arm: ' in text), (INCOMPLETE, True), text)

    def test_a_count_that_is_no_number_of_links(self):
        file, _ = self.certificate(self.urdf)
        *lines, end = lines_of(file)
        for counted in (*NOT_COUNTED, -1, 1, 0.0, False, '0', {}):
            write_lines(file, [*lines, dict(end, not_covered=counted)])
            self.assertEqual(check(file, self.urdf)[0], REFUSED, counted)
        write_lines(file, [*lines[:-1], dict(end, links=4, not_covered=1)])
        self.assertEqual(check(file, self.urdf)[0], INCOMPLETE)

    def test_demo(self):
        file, _ = self.certificate(DEMO)
        code, text = check(file, DEMO)
        self.assertEqual(code, INCOMPLETE, 'OBJ and Collada are not read')
        self.assertRegex(text, r': [1-9]\d* links; ')

    def test_public_robots(self):
        data = os.environ.get('LINK_BOUNDS_DATA')
        if not data:
            print('skipped: certificates of public robots: LINK_BOUNDS_DATA is not set')
            return
        for name in PUBLIC:
            with self.subTest(name), mock.patch.dict(os.environ, ROS_PACKAGE_PATH=data + '/robots'):
                urdf = os.path.join(data, 'robots', name)
                file, _ = self.certificate(urdf, '--geometry', 'collision')
                code, text = check(file, urdf, '--sample', '5')
                self.assertEqual(code, 0, text)
                self.assertNotIn('no links', text)

    def test_an_engine_whose_joints_turn_too_little(self):
        file = os.path.join(self.folder, 'wrong.cert')
        write_wrong(self.urdf, *REACH, '--certificate', file)
        code, text = check(file, self.urdf, '--sample', '100')
        self.assertEqual(code, REFUSED, text)
        self.assertIn('not proven before joint', text)

    def damage(self, lines, choice):
        """Its name. Each one makes the file false or malformed."""
        link = choice.choice([line for line in lines[1:-1] if line['tables']])
        lines.remove(link)
        lines.insert(1, link)  # checked first
        table = choice.choice(link['tables'])
        entry, axis = choice.randrange(len(table)), choice.randrange(3)
        damages = {
            'support': lambda: table.__setitem__(entry, table[entry] - choice.choice((10, 10**7))),
            'no support': lambda: table.pop(entry),
            'further support': lambda: table.append(0),
            'text': lambda: table.__setitem__(entry, 'x'),
            'not a number': lambda: table.__setitem__(entry, float('nan')),
            'infinite': lambda: table.__setitem__(entry, float('inf')),
            'smaller box': lambda: link['max'].__setitem__(axis, link['max'][axis] - 1e-6),
            'smaller box below': lambda: link['min'].__setitem__(axis, link['min'][axis] + 1e-3),
            'no box': lambda: link.pop('min'),
            'flat box': lambda: link['max'].pop(),
            'other corners': lambda: link['min'].insert(0, link['max'].pop()),
            'step': lambda: link.update(step=0.9 * link['step']),
            'negative step': lambda: link.update(step=-link['step']),
            'cells': lambda: link.update(cells=2 * link['cells']),
            'no cells': lambda: link.update(cells=0),
            'no table': lambda: link['tables'].pop(),
            'table twice': lambda: link['tables'].append(table),
            'unknown link': lambda: link.update(link='none'),
            'link twice': lambda: lines.insert(1, link),
            'link missing': lambda: lines.remove(link),
            'other geometry': lambda: lines[0].update(geometry='collision'),
            'other certificate': lambda: lines[0].update(of='pairs'),
            'narrow range': lambda: lines[0]['given'].update(elbow=[0, 0.1]),
            'no end': lines.pop,
            'other end': lambda: lines[-1].update(links=1)}
        name = choice.choice(sorted(damages))
        damages[name]()
        return name

    def test_damages(self):
        file, _ = self.certificate(self.urdf)
        good, bad = lines_of(file), os.path.join(self.folder, 'bad.cert')
        choice, seen = random.Random(2), set()
        for number in range(DAMAGES):
            lines = json.loads(json.dumps(good))
            name = self.damage(lines, choice)
            seen.add(name)
            write_lines(bad, lines)
            with self.subTest(number=number, damage=name):
                code, text = check(bad, self.urdf, '--all')
                self.assertEqual(code, REFUSED, text)
        self.assertGreater(len(seen), 18 if DAMAGES == 200 else 8)


if __name__ == '__main__':
    main()
