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
import re
import xml.etree.ElementTree
from xml.sax.saxutils import quoteattr

from bad_inputs import SANITIZED
from urdf_bounds_testing import UrdfBoundsTest, boxes, main, run

TOUCH = 1e-7  # metres
INCOMPLETE = 4  # exit code
DATA = os.path.abspath('../../data/robots')


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
    coarse = ['--pairs'] if '--accuracy' in arguments else COARSE
    found = boxes(*coarse, *arguments, **options)['pairs']
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
        # Two joints are between base and lower, although no geometry is.
        self.assertEqual(found, {
            ('base', 'welded'): 'ADJACENT', ('lower', 'ring'): 'ADJACENT', ('ring', TIP): 'ADJACENT',
            ('base', 'lower'): 'NEVER', ('base', 'ring'): 'NEVER', ('base', TIP): 'NEVER',
            ('lower', TIP): 'SOMETIMES', ('lower', 'welded'): 'NEVER', ('ring', 'welded'): 'NEVER',
            (TIP, 'welded'): 'NEVER'})

    def test_a_pose_is_confirmed_by_distances(self):
        for (first, second), pair in pairs('--clearance', '0.45', urdf=ARM).items():
            if pair['verdict'] == 'ADJACENT':
                self.assertEqual((pair['clearance'], pair['nearest'], pair['pose']), (0, None, {}))
                continue
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
        self.assertEqual((pair['verdict'], pair['pose']), ('NEVER', {'elbow': 0.5}))
        still = ['--accuracy', '0.02', 'wrist:=0', 'roll:=0', 'slide:=0']
        at_two = pairs(*still, urdf=ARM)[('base', 'lower')]
        at_one = pairs(*still, 'elbow:=0..1', urdf=ARM)[('base', 'lower')]
        self.assertGreater(at_one['clearance'], at_two['nearest'] + 0.1)
        code, out, err = run(self.urdf, *COARSE, '--format', 'csv', 'elbow:=0..3.1')
        self.assertEqual(code, 0)
        self.assertIn('beyond the limits', err)
        self.assertIn('base,lower,SOMETIMES', out)

    def test_a_joint_that_rests_is_part_of_the_pose(self):
        """By a value that was given, also through the joint that mimics it, but not by a factor of
        0."""
        def mimic(leader, factor, *arguments):
            return joint(*arguments, limits=(-9, 9)).replace(
                '<axis', '<mimic joint="%s" multiplier="%r"/><axis' % (leader, factor))

        urdf = '<robot name="r">%s</robot>' % ''.join([
            link('base', ball(0.1)), link('a'), link('b'), link('c', ball(0.1, 0.5)),
            link('d'), link('e'), joint('still', 'revolute', 'base', 'a', '0.5 0 0', (0, 2)),
            mimic('still', 0.5, 'after', 'revolute', 'a', 'b'),
            mimic('beside', 0.0, 'zero', 'revolute', 'b', 'd'),
            joint('free', 'revolute', 'd', 'c'), joint('beside', 'revolute', 'base', 'e')])
        pair, = pairs('--accuracy', '1e-4', 'still:=1', 'beside:=1', urdf=urdf).values()
        self.assertEqual((pair['verdict'], pair['pose']['still']), ('NEVER', 1))
        self.assertEqual(set(pair['pose']), {'still', 'free'})
        distance, = boxes('--distances', '10', *('%s:=%r' % item for item in pair['pose'].items()),
                          urdf=urdf)['distances']
        self.assertAlmostEqual(distance['distance'], pair['nearest'], delta=1e-6)

    def test_table_and_csv(self):
        code, out, err = run(self.urdf, *COARSE)
        self.assertEqual((code, err), (0, ''))
        self.assertIn('links collide where they touch', out)
        self.assertRegex(out, r'base +lower +NEVER +0\.\d{6} +0\.\d{6}  elbow:=2 shoulder:=\S+\n')
        self.assertRegex(out, r'base +welded +ADJACENT +0\.000000 +-\n')
        self.assertIn('\n10 pairs: 6 NEVER, 0 ALWAYS, 0 TOUCHING, 0 CONTACT_SAMPLED, 1 SOMETIMES, '
                      '0 UNDECIDED, 3 ADJACENT\n', out)
        code, out, err = run(self.urdf, *COARSE, '--format', 'csv')
        self.assertEqual((code, err), (0, ''))
        head, *rows = csv.reader(io.StringIO(out))
        self.assertEqual(head, ['first', 'second', 'verdict', 'clearance', 'nearest', 'pose', 'poses'])
        self.assertEqual(rows[2][:3], ['base', TIP, 'NEVER'])
        self.assertEqual(rows[3], ['base', 'welded', 'ADJACENT', '0', '', '', ''])
        self.assertEqual(len(rows), 10)

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
        self.assertEqual(out.count('\n'), 11)
        self.assertIn('which collide at', err)

    def test_a_budget_that_is_used_up_leaves_pairs_undecided(self):
        code, out, err = run(self.urdf, *COARSE, '--budget', '1e-9', '--srdf',
                           self.srdf(('base', 'lower')))
        self.assertEqual(code, 4)
        self.assertIn('disables base and lower, which is not decided: no pose was tried', out)
        self.assertRegex(out, r'\n10 pairs: .* 7 UNDECIDED, 3 ADJACENT\n')
        self.assertRegex(err, 'was answered: UNDECIDED pairs: 7; --allow-incomplete')
        for arguments, expected in ((('--strict',), INCOMPLETE), (('--allow-incomplete',), 0)):
            self.assertEqual(run(self.urdf, *COARSE, '--budget', '1e-9', *arguments)[0], expected)
        # A finding comes first.
        path = self.srdf((TIP, 'lower'))
        self.assertEqual(run(self.urdf, *COARSE, '--srdf', path)[0], 3)

    def test_a_clearance_that_is_not_as_accurate_as_it_should_be(self):
        """Of one pose all is decided at once, but not every distance is measured so accurately."""
        turned = re.sub('<sphere radius="(.*?)"/>', r'<cylinder radius="\1" length="\1"/>', ARM)
        urdf = self.write('turned.urdf', turned)
        still = ['%s:=0.5' % name for name in ('shoulder', 'elbow', 'wrist', 'roll', 'slide')]
        arguments = ('--pairs', '--accuracy', '1e-15', *still)
        code, out, err = run(urdf, *arguments)
        self.assertEqual(code, INCOMPLETE, out)
        self.assertRegex(err, r'clearances that did not reach --accuracy: \d; --allow-incomplete')
        self.assertIn(' 0 UNDECIDED', out)
        self.assertEqual(run(urdf, *arguments, '--allow-incomplete')[0], 0)
        self.assertEqual(run(urdf, '--pairs', '--accuracy', '1e-6', *still)[0], 0)

    def test_exit_codes(self):
        over = [self.urdf, *COARSE, '--budget', '1e-9']
        disabled = self.srdf(('base', 'lower'))
        self.assertEqual(run(*over, '--srdf', disabled)[0], 4)
        self.assertEqual(run(*over, '--srdf', disabled, '--allow-incomplete')[0], 0)
        # It may be a pair that the SRDF forgets.
        self.assertEqual(run(*over, '--srdf', self.srdf())[0], 4)

    def test_the_srdf_of_another_robot(self):
        for name, other in ('arm', False), ('leg', True):
            path = self.write('r.srdf', '<robot name="%s"/>' % name)
            err = run(self.urdf, *COARSE, '--srdf', path)[2]
            warning = 'r.srdf" is that of a robot "leg", the URDF that of "arm"'
            self.assertEqual(warning in err, other)

    def test_undecided_pairs_are_named_in_a_srdf(self):
        code, out, err = run(self.urdf, *COARSE, '--budget', '1e-9', '--format', 'srdf')
        self.assertEqual(code, 4)
        self.assertEqual(out.count('Adjacent'), 3)
        self.assertNotIn('Never', out)
        for names in ('base and lower', 'lower and welded'):
            self.assertIn('<!-- not decided: %s -->' % names, out)
            self.assertIn('%s are not decided, and so not disabled\n' % names, err)

    def test_a_post_that_an_arm_sweeps_into(self):
        urdf = os.path.join(DATA, 'post_and_arm.urdf')
        code, out, err = run(urdf, '--pairs')
        self.assertEqual((code, err), (0, ''))
        self.assertRegex(out, r'\npost +arm +SOMETIMES +0\.000000 +0\.000000  turn:=-1\.\d+\n')
        self.assertRegex(out, r'\nbase +arm +ADJACENT ')
        self.assertNotRegex(out, r'\nbase +post ')
        elements = run(urdf, '--pairs', '--format', 'srdf')[1]
        self.assertIn('link1="base" link2="post" reason="Adjacent"', elements)
        self.assertNotIn('"post" link2="arm"', elements)
        srdf = self.write('post.srdf', '<robot name="post_and_arm"><disable_collisions '
                          'link1="arm" link2="post" reason="Adjacent"/></robot>')
        code, out, err = run(urdf, '--pairs', '--srdf', srdf)
        self.assertEqual((code, err), (3, ''))
        self.assertIn('disables post and arm, which collide at turn:=-1', out)

    def test_adjacent_links_are_examined_on_demand(self):
        found = verdicts('--adjacent', urdf=ARM)
        self.assertEqual(found[('lower', 'ring')], 'ALWAYS')
        self.assertEqual(found[('ring', TIP)], 'ALWAYS')
        self.assertEqual(found[('base', 'welded')], 'NEVER')
        self.assertNotIn('Adjacent', run(self.urdf, *COARSE, '--adjacent', '--format', 'srdf')[1])

    def test_rigid_links_are_in_a_srdf_with_what_is_proven(self):
        text = '<robot name="r">%s</robot>' % ''.join([
            link('a', ball(0.5)), link('b', ball(0.4, 1.0)), link('c', ball(0.3)), link('d', ball(0.2, 3.0)),
            *(joint('j' + child, 'fixed', parent, child) for parent, child in ('ab', 'bc', 'cd'))])
        code, out, err = run('-', *COARSE, '--format', 'srdf', urdf=text)
        self.assertEqual((code, err), (0, ''))
        self.assertEqual(re.findall('link1="(.)" link2="(.)" reason="(.*?)"', out), [
            ('a', 'b', 'Adjacent'), ('b', 'c', 'Adjacent'), ('c', 'd', 'Adjacent'),
            ('a', 'c', 'Always'), ('a', 'd', 'Never'), ('b', 'd', 'Never')])
        code, out, err = run('-', *COARSE, '--format', 'json', urdf=text)
        self.assertEqual((code, json.loads(out)['pairs']), (INCOMPLETE, []), 'none but rigid ones')
        self.assertIn('no pair was examined', err)

    def test_contact_in_all_poses(self):
        wall = '<geometry><box size="3 1 10"/></geometry>'
        puck = '<geometry><box size="1 1 1"/></geometry>'
        text = '<robot name="r">%s</robot>' % ''.join([
            link('wall', wall), link('cart'), link('puck', puck), link('short', puck),
            joint('fast', 'prismatic', 'wall', 'cart', '0 1 0'), joint('fine', 'prismatic', 'cart', 'puck'),
            joint('slow', 'prismatic', 'wall', 'short', '0 -1 0', (0, 0.01))])
        found = pairs('--adjacent', urdf=text)
        self.assertEqual(found[('wall', 'short')]['verdict'], 'TOUCHING')
        still = ('--adjacent', '--touching', '0', 'fast:=0', 'fine:=0')
        self.assertEqual(verdicts(*still, urdf=text)[('wall', 'short')], 'CONTACT_SAMPLED')
        sampled = found[('wall', 'puck')]
        self.assertEqual(sampled['verdict'], 'CONTACT_SAMPLED')
        self.assertGreaterEqual(sampled['poses'], 300)
        urdf = self.write('contact.urdf', text)
        tried = 'wall and puck collided in all %d poses that were tried' % sampled['poses']
        out = run(urdf, *COARSE, '--adjacent', '--format', 'srdf')[1]
        self.assertIn('<!-- not proven: %s -->' % tried, out)
        self.assertEqual(re.findall('link1="wall" link2="(.*?)" reason="(.*?)"', out), [('short', 'Always')])
        out = run(urdf, *COARSE, '--adjacent', '--format', 'srdf', '--accept-sampled')[1]
        self.assertEqual(re.findall('link1="wall" link2="(.*?)" reason="(.*?)"', out),
                         [('puck', 'Always'), ('short', 'Always')])
        printed = []
        for reason, style, code in (('Always', 'table', 0), ('Never', 'csv', 3)):
            srdf = self.write('c.srdf', '<robot><disable_collisions link1="wall" link2="puck" reason="%s"/>'
                              '<disable_collisions link1="wall" link2="short" reason="Always"/></robot>' % reason)
            found, out, _ = run(urdf, *COARSE, '--adjacent', '--srdf', srdf, '--format', style)
            self.assertEqual(found, code, reason)
            printed.append(out)
        self.assertIn(tried, printed[0])
        row, = [line for line in printed[1].splitlines() if 'SAMPLED' in line]
        self.assertEqual(row.split(',')[-1], str(sampled['poses']))

    def test_links_without_checks_by_default(self):
        """All pairs of the link are disabled, but those that are enabled again."""
        text = '<robot name="arm"><disable_default_collisions link="lower"/>%s</robot>'
        path = self.write('arm.srdf', text % '')
        code, out, _ = run(self.urdf, *COARSE, '--srdf', path)
        self.assertEqual(code, 3)
        self.assertRegex(out, 'arm.srdf" disables lower and hand & "tip", which collide at roll:=')
        self.assertNotIn('does not disable base and lower', out)
        merged = self.write('new.srdf', run(self.urdf, *COARSE, '--format', 'srdf', '--srdf', path)[1])
        self.assertEqual(run(self.urdf, *COARSE, '--srdf', merged)[0], 0)
        enabled = '<enable_collisions link1=%s link2="lower"/>' % quoteattr(TIP)
        path = self.write('arm.srdf', text % enabled)
        self.assertEqual(run(self.urdf, *COARSE, '--srdf', path)[0], 0)
        path = self.write('arm.srdf', text.replace('lower', 'nobody') % '')
        self.check_refused('"nobody" is no link', self.urdf, *COARSE, '--srdf', path)

    def test_a_srdf_is_merged(self):
        old = self.write('old.srdf', """<?xml version="1.0"?>
<!--by hand-->
<robot name="arm">
    <group name="all"><chain base_link="base" tip_link="ring"/></group>
    <group_state name="home" group="all"><joint name="elbow" value="1"/></group_state>
    <!--these do not collide-->
    <disable_collisions link1="base" link2="lower" reason="Default"/>
    <disable_collisions link1="hand &amp; &quot;tip&quot;" link2="lower" reason="Never"/>
    <disable_collisions link1="upper" link2="base" reason="Adjacent"/>
    <virtual_joint name="v" type="fixed" parent_frame="world" child_link="base"/>
</robot>
""")
        merge = [self.urdf, *COARSE, '--format', 'srdf', '--srdf', old]
        code, out, err = run(*merge)
        self.assertEqual(code, 3)
        self.assertIn('disables lower and hand & "tip", which collide at roll:=', err)
        self.assertIn('; no longer disabled', err)
        root = xml.etree.ElementTree.fromstring(out)
        self.assertEqual((root.tag, root.get('name')), ('robot', 'arm'))
        self.assertEqual([e.tag for e in root if e.tag != 'disable_collisions'],
                         ['group', 'group_state', 'virtual_joint'])
        found = {(e.get('link1'), e.get('link2')): e.get('reason') for e in root.iter('disable_collisions')}
        self.assertEqual(len(found), 6 + 3 + 1)
        self.assertEqual(found[('base', 'lower')], 'Never')
        self.assertEqual(found[('base', 'upper')], 'Adjacent')
        self.assertNotIn(('lower', TIP), found)
        self.assertIn('<!--by hand-->', out)
        self.assertIn('<!--these do not collide-->\n    <disable_collisions', out)
        code, again, err = run(*merge[:-1], self.write('new.srdf', out))
        self.assertEqual((code, again), (0, out))
        code, out, err = run(*merge, '--budget', '1e-9')
        self.assertEqual(code, 4)
        self.assertIn('; still disabled', err)
        self.assertRegex(out, '<!-- not decided: base and lower -->\n *<disable_collisions link1="base" '
                              'link2="lower" reason="Default"/>')
        self.assertRegex(out, '<!-- not decided: base and ring -->\n *<!--')

    def test_many_links_take_little_memory(self):
        count, budget = (60, '0.01') if SANITIZED else (400, '1')
        names = ['link_of_the_robot_%d' % i for i in range(count)]
        text = '<robot name="r">%s</robot>' % ''.join(
            [link(name, ball(0.1)) for name in names] +
            [joint('j%d' % i, 'revolute', names[(i - 1) // 2], names[i], '0.3 0 0') for i in range(1, count)])
        code, out, err = run('-', '--pairs', '--budget', budget, '--verbose', urdf=text)
        self.assertEqual(code, 4)
        self.assertIn('\n%d pairs: ' % (count * (count - 1) // 2), out)
        if not SANITIZED:
            self.assertLess(int(re.search(r'(\d+) kB of memory at the peak', err).group(1)), 200000)

    def test_coordinates_that_are_too_large(self):
        for xyz in ('1e61 0 0', '1e200 0 0'):
            code, out, err = run('-', '--pairs', urdf=ARM.replace('xyz="1 0 0"', 'xyz="%s"' % xyz))
            self.assertEqual(code, 4)
            self.assertIn('not everything was answered: UNDECIDED pairs: 7', err)
            self.assertRegex(out, r'base +lower +UNDECIDED +0\.000000 +-\n')

    def test_incomplete_links_never_get_a_never(self):
        text = ARM.replace(link('ring', ball(0.2)), link(
            'ring', ball(0.2) + '</visual><visual><geometry><mesh filename="none.stl"/></geometry>'))
        self.assertEqual(run('-', *COARSE, '--strict', urdf=text)[0], 4)
        code, out, err = run('-', *COARSE, '--format', 'json', urdf=text)
        self.assertEqual(code, 4)
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
