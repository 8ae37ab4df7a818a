#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdf_bounds --pairs prints: verdicts in every format, and the check of a SRDF.

Run as: urdf_bounds_pairs_test.py PATH_OF_urdf_bounds
"""
import csv
import io
import json
import os
import xml.etree.ElementTree
from xml.sax.saxutils import quoteattr

from urdf_bounds_testing import UrdfBoundsTest, boxes, main, run

TOUCH = 1e-7  # metres
INCOMPLETE = 4  # exit code


def link(name, geometry=''):
    visual = '<visual>%s</visual>' % geometry if geometry else ''
    return '<link name=%s>%s</link>' % (quoteattr(name), visual)


def ball(radius, x=0.0):
    return '<origin xyz="%r 0 0"/><geometry><sphere radius="%r"/></geometry>' % (x, radius)


def joint(name, kind, parent, child, xyz='0 0 0', limits=(-1, 1)):
    return '''<joint name="%s" type="%s"><parent link=%s/><child link=%s/><origin xyz="%s"/>
<axis xyz="0 0 1"/><limit lower="%r" upper="%r" effort="1" velocity="1"/></joint>''' % (
        name, kind, quoteattr(parent), quoteattr(child), xyz, *limits)


# The elbow bends the arm back towards the base; the hand turns about the wrist.
ARM = '<robot name="arm">%s</robot>' % ''.join([
    link('base', ball(0.5)), link('upper'), link('lower', ball(0.1, 0.9)), link('ring', ball(0.2)),
    link('hand & "tip"', ball(0.1, 0.15)), link('welded', ball(0.05)),
    joint('shoulder', 'continuous', 'base', 'upper'),
    joint('elbow', 'revolute', 'upper', 'lower', '1 0 0', (0, 2)),
    joint('wrist', 'continuous', 'lower', 'ring', '1 0 0'),
    joint('roll', 'continuous', 'ring', 'hand & "tip"'),
    joint('slide', 'prismatic', 'base', 'welded', '0 0 0.6', (0, 1)),
])
TIP = 'hand & "tip"'
COARSE = ['--pairs', '--accuracy', '0.2']  # takes little time


def pairs(*arguments, **options):
    found = boxes(*COARSE, *arguments, **options)['pairs']
    return {(pair['first'], pair['second']): pair for pair in found}


def verdicts(*arguments, **options):
    return {names: pair['verdict'] for names, pair in pairs(*arguments, **options).items()}


class PairsTest(UrdfBoundsTest):
    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)

    def srdf(self, *disabled):
        text = ''.join('<disable_collisions link1=%s link2=%s reason="User"/>' % tuple(
            map(quoteattr, pair)) for pair in disabled)
        return self.write('arm.srdf', '<robot name="arm"><group name="all"/>%s</robot>' % text)

    def test_each_pair_has_its_verdict(self):
        found = verdicts(urdf=ARM)
        # Not base and welded, lower and ring, ring and hand: neighbours by one joint.
        self.assertEqual(found, {
            ('base', 'lower'): 'NEVER', ('base', 'ring'): 'NEVER', ('base', TIP): 'NEVER',
            ('lower', TIP): 'SOMETIMES', ('lower', 'welded'): 'NEVER', ('ring', 'welded'): 'NEVER',
            (TIP, 'welded'): 'NEVER'})

    def test_a_pose_is_confirmed_by_distances(self):
        for (first, second), pair in pairs('--clearance', '0.45', urdf=ARM).items():
            self.assertEqual(set(pair), {'first', 'second', 'verdict', 'clearance', 'nearest', 'pose'})
            pose = ['%s:=%r' % item for item in pair['pose'].items()]
            near = boxes('--distances', '10', *pose, urdf=ARM)['distances']
            distance, = [d for d in near if (d['first'], d['second']) == (first, second)]
            self.assertLessEqual(distance['distance'], pair['nearest'])
            self.assertLessEqual(pair['clearance'], distance['distance_max'])
            if pair['verdict'] in ('SOMETIMES', 'ALWAYS'):
                self.assertLessEqual(distance['distance'], 0.45 + TOUCH)
            else:
                self.assertGreater(pair['clearance'], 0.45)

    def test_clearance_changes_verdicts(self):
        still = ['wrist:=0', 'roll:=0', 'slide:=0']
        exact = pairs('--accuracy', '1e-4', *still, urdf=ARM)[('base', 'lower')]
        self.assertLessEqual(exact['nearest'] - exact['clearance'], 1e-4)
        below, above = exact['clearance'] - 1e-3, exact['nearest'] + 1e-3
        self.assertEqual(verdicts('--clearance', repr(below), *still, urdf=ARM)[('base', 'lower')], 'NEVER')
        self.assertEqual(verdicts('--clearance', repr(above), *still, urdf=ARM)[('base', 'lower')],
                         'SOMETIMES')

    def test_joint_values_and_ranges(self):
        pair = pairs('shoulder:=0', 'elbow:=0.5', urdf=ARM)[('base', 'lower')]
        self.assertEqual((pair['verdict'], pair['pose']), ('NEVER', {}))
        still = ['--accuracy', '0.02', 'wrist:=0', 'roll:=0', 'slide:=0']
        at_two = pairs(*still, urdf=ARM)[('base', 'lower')]
        at_one = pairs(*still, 'elbow:=0..1', urdf=ARM)[('base', 'lower')]
        self.assertGreater(at_one['clearance'], at_two['nearest'] + 0.1)
        code, out, err = run(self.urdf, *COARSE, '--format', 'csv', 'elbow:=0..3.1')
        self.assertEqual(code, 0)
        self.assertIn('beyond the limits', err)
        self.assertIn('base,lower,SOMETIMES', out)

    def test_table_and_csv(self):
        code, out, err = run(self.urdf, *COARSE)
        self.assertEqual((code, err), (0, ''))
        self.assertIn('links collide where they touch', out)
        self.assertRegex(out, r'base +lower +NEVER +0\.\d{6} +0\.\d{6}  elbow:=2 shoulder:=\S+\n')
        self.assertIn('\n7 pairs: 6 NEVER, 0 ALWAYS, 1 SOMETIMES, 0 UNDECIDED\n', out)
        code, out, err = run(self.urdf, *COARSE, '--format', 'csv')
        self.assertEqual((code, err), (0, ''))
        head, *rows = csv.reader(io.StringIO(out))
        self.assertEqual(head, ['first', 'second', 'verdict', 'clearance', 'nearest', 'pose'])
        self.assertEqual(rows[2][:3], ['base', TIP, 'NEVER'])
        self.assertEqual(len(rows), 7)

    def test_srdf_format_is_accepted_by_its_own_check(self):
        code, out, err = run(self.urdf, *COARSE, '--format', 'srdf')
        self.assertEqual((code, err), (0, ''))
        root = xml.etree.ElementTree.fromstring('<robot>%s</robot>' % out)
        found = {(e.get('link1'), e.get('link2')): e.get('reason') for e in root}
        self.assertEqual({e.tag for e in root}, {'disable_collisions'})
        self.assertEqual(found[('base', 'ring')], 'Never')
        self.assertEqual(found[('ring', TIP)], 'Adjacent')
        self.assertEqual(found[('base', 'welded')], 'Adjacent')
        self.assertNotIn(('lower', TIP), found)
        path = self.write('own.srdf', '<robot name="arm">%s</robot>' % out)
        check = boxes(*COARSE, '--srdf', path, urdf=ARM)['srdf']
        self.assertEqual(check, {'wrong': [], 'undecided': [], 'forgotten': []})

    def test_a_disabled_pair_that_collides_is_an_error_with_its_witness(self):
        path = self.srdf((TIP, 'lower'), ('base', 'lower'), ('base', 'upper'))
        code, out, err = run(self.urdf, *COARSE, '--srdf', path)
        self.assertEqual((code, err), (3, ''))
        self.assertRegex(out, r'arm.srdf" disables lower and hand & "tip", which collide at roll:=')
        self.assertIn('does not disable base and ring, which never collide', out)
        self.assertNotIn('does not disable base and lower', out)
        code, out, err = run(self.urdf, *COARSE, '--srdf', path, '--format', 'json')
        self.assertEqual(code, 3)
        self.assertEqual(json.loads(out)['srdf']['wrong'], [['lower', TIP]])
        self.assertEqual(len(json.loads(out)['srdf']['forgotten']), 5)
        code, out, err = run(self.urdf, *COARSE, '--srdf', path, '--format', 'csv')
        self.assertEqual(code, 3)
        self.assertEqual(out.count('\n'), 8)
        self.assertIn('which collide at', err)

    def test_a_budget_that_is_used_up_leaves_pairs_undecided(self):
        code, out, err = run(self.urdf, *COARSE, '--budget', '1e-9', '--srdf',
                           self.srdf(('base', 'lower')))
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('disables base and lower, which is not decided: they are never nearer than', out)
        self.assertRegex(out, r'\n7 pairs: .* [5-7] UNDECIDED\n')
        self.assertRegex(err, 'was answered: UNDECIDED pairs: [5-7]; --allow-incomplete')
        for arguments, expected in (((), INCOMPLETE), (('--strict',), INCOMPLETE),
                                    (('--strict', '--allow-incomplete'), 0)):
            self.assertEqual(run(self.urdf, *COARSE, '--budget', '1e-9', *arguments)[0], expected)
        # A finding comes first.
        path = self.srdf((TIP, 'lower'))
        self.assertEqual(run(self.urdf, *COARSE, '--srdf', path, '--budget', '5',
                             urdf=ARM)[0], 3)

    def test_a_clearance_that_is_not_as_accurate_as_it_should_be(self):
        """All is decided at once. So accurate a clearance takes much longer."""
        arguments = ('--pairs', '--accuracy', '1e-7', '--budget', '3')
        code, out, err = run(self.urdf, *arguments)
        self.assertEqual(code, INCOMPLETE, out)
        self.assertRegex(err, r'clearances that did not reach --accuracy: \d; --allow-incomplete')
        self.assertIn(' 0 UNDECIDED', out)
        self.assertEqual(run(self.urdf, *arguments, '--allow-incomplete')[0], 0)

    def test_incomplete_links_never_get_a_never(self):
        text = ARM.replace(link('ring', ball(0.2)), link(
            'ring', ball(0.2) + '</visual><visual><geometry><mesh filename="none.stl"/></geometry>'))
        code, out, err = run('-', *COARSE, '--format', 'json', '--strict', urdf=text)
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('none.stl', err)
        self.assertEqual(run('-', *COARSE, '--strict', '--allow-incomplete', urdf=text)[0], 2)
        self.assertEqual(run('-', *COARSE, '--allow-incomplete', urdf=text)[0], 0)
        path = self.srdf((TIP, 'lower'))
        self.assertEqual(run('-', *COARSE, '--srdf', path, urdf=text)[0], 3)
        found = {(p['first'], p['second']): p['verdict'] for p in json.loads(out)['pairs']}
        self.assertEqual(found[('base', 'ring')], 'UNDECIDED')
        self.assertEqual(found[('base', 'lower')], 'NEVER')
        self.assertIn('ring', json.loads(out)['incomplete'])

    def test_a_srdf_that_cannot_be_used(self):
        self.check_refused('none.srdf', self.urdf, '--pairs', '--srdf',
                           os.path.join(self.folder, 'none.srdf'))
        path = self.write('bad.srdf', '<robot><disable_collisions link1="base" link2="nobody"/></robot>')
        self.check_refused('"nobody" is no link of the robot', self.urdf, '--pairs', '--srdf', path)


if __name__ == '__main__':
    main()
