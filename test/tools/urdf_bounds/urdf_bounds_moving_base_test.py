#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Floating and planar joints: nothing is proven without ranges, and what is proven with ranges
holds in random poses, which numpy computes from its own reading of the URDF.

Run as: urdf_bounds_moving_base_test.py PATH_OF_urdf_bounds
"""
import json
import math
import os
import random
from xml.etree import ElementTree

import numpy
import yaml

from urdf_bounds_testing import UrdfBoundsTest, main, run

ROBOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../data/mobile_arm.urdf')
ROUNDING = 1e-9  # metres
TOUCH = 2e-7  # metres
INCOMPLETE = 4  # exit code
SAMPLES = 1000
TURN = (-math.pi, math.pi)
DRIVE = {'drive.x': (-0.5, 0.7), 'drive.y': (0.1, 0.3)}
CARRY = {'carry.x': (-0.2, 0.1), 'carry.y': (0.3, 0.3), 'carry.z': (0, 0.2),
         'carry.roll': (-2, -1.2), 'carry.pitch': (-0.4, 0.9), 'carry.yaw': (0.5, 1)}
LIMITS = {'lift': (-0.5, 0.5), 'wrist': TURN, 'drive.yaw': TURN}


def given(ranges):
    return ['%s:=%r..%r' % (name, *limits) for name, limits in ranges.items()]


def turn(axis, angle):
    """Rodrigues' formula."""
    x, y, z = axis
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def rpy(roll, pitch, yaw):
    """About the fixed axes x, y, z, in this order."""
    return turn((0, 0, 1), yaw) @ turn((0, 1, 0), pitch) @ turn((1, 0, 0), roll)


def transform(rotation, position):
    result = numpy.eye(4)
    result[:3, :3], result[:3, 3] = rotation, position
    return result


def numbers(element, key):
    text = element.get(key) if element is not None else None
    return [float(word) for word in (text or '0 0 0').split()]


def origin(element):
    found = element.find('origin')
    return transform(rpy(*numbers(found, 'rpy')), numbers(found, 'xyz'))


def motion(joint, values):
    """The pose that the values of a joint give its child."""
    name, kind = joint.get('name'), joint.get('type')

    def value(part):
        return values.get('%s.%s' % (name, part), 0)
    if kind == 'planar':
        return transform(turn((0, 0, 1), value('yaw')), [value('x'), value('y'), 0])
    if kind == 'floating':
        return transform(rpy(*map(value, ('roll', 'pitch', 'yaw'))), [*map(value, 'xyz')])
    return transform(turn(numbers(joint.find('axis'), 'xyz'), values.get(name, 0)), [0, 0, 0])


def balls(values):
    """{link: (centre, radius)} in that pose; joints stand from the root outward in the file."""
    robot = ElementTree.parse(ROBOT).getroot()
    poses = {'world': numpy.eye(4)}
    for joint in robot.findall('joint'):
        parent, child = joint.find('parent').get('link'), joint.find('child').get('link')
        poses[child] = poses[parent] @ origin(joint) @ motion(joint, values)
    return {link.get('name'): ((poses[link.get('name')] @ origin(link.find('visual')))[:3, 3],
                               float(link.find('visual/geometry/sphere').get('radius')))
            for link in robot.findall('link')}


def distance(found, first, second):
    (a, r), (b, s) = found[first], found[second]
    return numpy.linalg.norm(a - b) - r - s


def random_poses(ranges, count=SAMPLES):
    """Often at the ends of ranges."""
    chance = random.Random(31)
    for _ in range(count):
        yield {name: low + min(max(chance.uniform(-0.3, 1.3), 0), 1) * (high - low)
               for name, (low, high) in ranges.items()}


class MovingBaseTest(UrdfBoundsTest):
    def report(self, *arguments, code=0, err=''):
        found, out, text = run(ROBOT, '--format=json', *arguments)
        self.assertEqual(found, code, text)
        self.assertRegex(text, err or '^$')
        return json.loads(out)

    def pairs(self, *arguments, **options):
        found = self.report('--pairs', '--accuracy', '0.3', *arguments, **options)
        return {(pair['first'], pair['second']): pair for pair in found['pairs']}

    def check_reach(self, found, ranges):
        self.assertEqual(set(found['reach']), {'world', 'base', 'arm', 'hand', 'part'})
        for values in random_poses(dict(LIMITS, **ranges)):
            for link, (center, radius) in balls(values).items():
                box = found['reach'][link]
                inside = (center - radius >= numpy.array(box['min']) - ROUNDING,
                          center + radius <= numpy.array(box['max']) + ROUNDING)
                self.assertTrue(numpy.all(inside), (link, values))

    def test_boxes_of_a_pose(self):
        self.assertEqual(self.report()['boxes'], self.report('drive.x:=0', 'carry.yaw:=0')['boxes'])
        for values in random_poses(dict(LIMITS, **DRIVE, **CARRY), 20):
            found = self.report(*('%s:=%r' % item for item in values.items()))['boxes']
            for link, (center, radius) in balls(values).items():
                self.check_box(found[link], center - radius, center + radius)

    def test_reach_holds_in_random_poses(self):
        found = self.report('--reach', '--accuracy', '0.1', *given(DRIVE), *given(CARRY))
        self.assertEqual(found['incomplete'], {})
        self.check_reach(found, dict(DRIVE, **CARRY))

    def test_each_face_is_attained(self):
        found = self.report('--reach', '--accuracy', '0.1', *given(DRIVE), *given(CARRY))
        names = set()
        for link, box in found['reach'].items():
            for face, (values, gap) in enumerate(zip(box['attained'], box['gap'])):
                names |= set(values)
                self.assertLessEqual(gap, 0.1)
                center, radius = balls(values)[link]
                side = (center - radius if face < 3 else center + radius)[face % 3]
                self.assertAlmostEqual(abs(side - (box['min'] + box['max'])[face]), gap,
                                       delta=ROUNDING)
        self.assertEqual(names, set(LIMITS) | set(DRIVE) | set(CARRY))

    def test_angles_that_are_not_given_take_a_full_turn(self):
        lengths = {name: limits for name, limits in CARRY.items() if name[-1] in 'xyz'}
        found = self.report('--reach', '--accuracy', '0.1', *given(DRIVE), *given(lengths))
        angles = {'carry.' + name: TURN for name in ('roll', 'pitch', 'yaw')}
        self.check_reach(found, dict(DRIVE, **lengths, **angles))

    def test_verdicts_hold_in_random_poses(self):
        ranges = dict(LIMITS, **DRIVE, **CARRY)
        found = self.pairs('--adjacent', *given(DRIVE), *given(CARRY))
        self.assertEqual(found['world', 'arm']['verdict'], 'NEVER')
        self.assertEqual(found['world', 'hand']['verdict'], 'SOMETIMES')
        self.assertEqual(found['base', 'part']['verdict'], 'NEVER')
        for values in random_poses(ranges):
            there = balls(values)
            for names, pair in found.items():
                self.assertGreaterEqual(max(0, distance(there, *names)),
                                        pair['clearance'] - ROUNDING)
        for names, pair in found.items():
            for name, value in pair['pose'].items():
                self.assertTrue(ranges[name][0] <= value <= ranges[name][1], (name, value))
            pose = dict({'carry.y': 0.3}, **pair['pose'])  # those with ranges
            there = max(0, distance(balls(pose), *names))
            self.assertLessEqual(there, pair['nearest'] + ROUNDING)
            self.assertTrue(pair['verdict'] != 'SOMETIMES' or there < TOUCH, pair)

    def test_pairs_without_ranges_are_undecided(self):
        found = self.pairs(code=INCOMPLETE, err='not decided: it depends on "drive"')
        for names in (('world', 'arm'), ('world', 'hand'), ('arm', 'part'), ('base', 'part')):
            self.assertEqual(found[names]['verdict'], 'UNDECIDED')
            self.assertEqual((found[names]['clearance'], found[names]['pose']), (0, {}))
        self.assertRegex(found['world', 'arm']['reason'], '"drive".*drive.x:=.*or --base fixed')
        self.assertNotIn('carry', found['world', 'arm']['reason'])
        self.assertRegex(found['arm', 'part']['reason'], '"drive", "carry".*drive.y:=.*carry.z:=')
        self.assertEqual(found['base', 'hand']['verdict'], 'NEVER')
        self.assertNotIn('reason', found['base', 'hand'])
        # One range is not enough.
        found = self.pairs('drive.x:=0..1', code=INCOMPLETE, err='drive.y:=')
        self.assertEqual(found['world', 'arm']['verdict'], 'UNDECIDED')
        self.assertNotIn('drive.x', found['world', 'arm']['reason'])
        code, out, _ = run(ROBOT, '--pairs', '--accuracy', '0.1')
        self.assertEqual(code, INCOMPLETE)
        self.assertRegex(out, r'UNDECIDED .*\n(.*\n)*2 UNDECIDED: it depends on "drive", whose')
        out = run(ROBOT, '--pairs', '--accuracy', '0.1', '--format=srdf')[1]
        self.assertNotIn('link1="world" link2="arm"', out)

    def test_reach_without_ranges_says_so_in_every_format(self):
        arguments = ('--reach', '--accuracy', '0.1')
        found = self.report(*arguments, code=INCOMPLETE, err='link "arm": it depends on "drive"')
        self.assertEqual(list(found['reach']), ['world'])
        self.assertEqual(list(found['incomplete']), ['base', 'arm', 'hand', 'part', 'group:robot'])
        self.assertIn('drive.x:=-1..1', found['incomplete']['hand'])
        self.assertIn('"carry"', found['incomplete']['part'])
        for form in ('table', 'csv', 'markers'):
            code, out, _ = run(ROBOT, '--format', form, *arguments)
            self.assertEqual(code, INCOMPLETE)
            for name in ('hand', 'part', 'group:robot'):
                line = {'table': '\n  %s: ', 'csv': '\nincomplete:%s,,',
                        'markers': '\n# incomplete: %s: '}
                self.assertIn(line[form] % name, out)
        self.assertEqual([m['ns'] for m in yaml.safe_load(out)['markers']], ['world', 'robot'])
        self.assertEqual(run(ROBOT, '--allow-incomplete', *arguments)[0], 0)

    def test_a_fixed_base(self):
        zeros = [name + ':=0' for name in [*DRIVE, 'drive.yaw', *CARRY]]
        for mode in ('--reach', '--pairs'):
            arguments = (mode, '--accuracy', '0.1')
            self.assertEqual(self.report('--base', 'fixed', *arguments),
                             self.report(*zeros, *arguments))
        self.check_refused('--base fixed keeps "drive.x" at 0', ROBOT, '--reach', '--base', 'fixed',
                           'drive.x:=0..1')
        self.check_refused('--base is "free", but must be one of: fixed', ROBOT, '--reach',
                           '--base', 'free')
        self.check_refused('--base is an option of --reach or --pairs', ROBOT, '--base', 'fixed')

    def test_only_joints_of_the_root_are_of_the_base(self):
        with open(ROBOT, encoding='utf-8') as file:
            text = file.read()
        # The part is carried by the hand; the world stands on another link.
        text = text.replace('<parent link="world"/><child link="part"/>',
                            '<parent link="hand"/><child link="part"/>')
        text = text.replace('</robot>', '''<link name="ground"/><joint name="still" type="fixed">
<parent link="ground"/><child link="world"/></joint></robot>''')
        code, out, _ = run('-', '--reach', '--base', 'fixed', '--format=json', urdf=text)
        self.assertEqual(code, INCOMPLETE)
        self.assertEqual(list(json.loads(out)['incomplete']), ['part', 'group:robot'])
        self.assertNotIn('--base fixed', json.loads(out)['incomplete']['part'])

    def test_the_name_of_the_whole_joint_is_refused(self):
        for mode, text in (('--reach', 'drive:=-1..1'), ('--pairs', 'drive:=0'),
                           ('--verbose', 'drive:=0')):
            self.check_refused('"drive" has more than one value; give drive.x, drive.y, '
                               'drive.yaw, or some of them, as in drive.x:=0.5.* drive.x:=-1..1', ROBOT, mode, text)
        self.check_refused('give carry.x, carry.y, carry.z, carry.yaw, carry.pitch, '
                           'carry.roll', ROBOT, '--reach', 'carry:=-1..1')
        self.check_refused('"drive.z" is no movable joint.* drive.x drive.y drive.yaw', ROBOT,
                           '--reach', 'drive.z:=0')


if __name__ == '__main__':
    main()
