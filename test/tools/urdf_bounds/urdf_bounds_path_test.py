#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proofs about the motion between way points: urdf_bounds_path_test.py URDF_BOUNDS"""
import json

from page_testing import PACKAGE
from urdf_bounds_testing import UrdfBoundsTest, main, run, tetrahedron

# A block that slides along x above a bump: where the slide is at 2, they are 0.1 apart if the
# block is not lifted.
SLIDE = '''<robot name="slide">
<link name="base"><visual><geometry><box size="0.2 1 1"/></geometry></visual></link>
<link name="between"/>
<link name="block"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<joint name="push" type="prismatic"><parent link="base"/><child link="between"/>
  <origin xyz="2 0 1.1"/><axis xyz="-1 0 0"/>
  <limit lower="-1" upper="5" effort="1" velocity="1"/></joint>
<joint name="lift" type="prismatic"><parent link="between"/><child link="block"/>
  <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>'''
SRDF = '''<robot name="slide"><disable_collisions link1="base" link2="block" reason="User"/></robot>'''
POST = 'post: {type: CUBE, pose: {position: {x: 2, y: 0, z: %g}}, scale: {x: 0.2, y: 0.2, z: 1}}\n'


class PathTest(UrdfBoundsTest):
    def segments(self, table, *arguments, code=0, urdf=SLIDE):
        path = self.write('path.csv', table)
        found, out, err = run('-', '--poses', path, '--path', '--format', 'json', *arguments,
                              urdf=urdf)
        self.assertEqual(found, code, err)
        result = json.loads(out)
        return result['segments'] if not result['incomplete'] else result

    def verdicts(self, *arguments, **options):
        return [segment['verdict'] for segment in self.segments(*arguments, **options)]

    def test_what_passes_between_way_points_is_seen(self):
        """In both rows the block is 1.4 m away."""
        table = 'push,lift\n0,0\n4,0\n'
        segment, = self.segments(table)
        self.assertEqual((segment['verdict'], segment['from'], segment['to']), ('SAFE', 1, 2))
        self.assertLessEqual(segment['clearance'], 0.1)
        self.assertGreater(segment['clearance'], 0.0899)
        self.assertAlmostEqual(segment['nearest'], 0.1, delta=0.001)
        self.assertEqual((segment['first'], segment['second']), ('base', 'block'))
        segment, = self.segments('push,lift\n0,-0.11\n4,-0.11\n', code=3)
        self.assertEqual(segment['verdict'], 'COLLIDES')
        self.assertAlmostEqual(segment['pose']['push'], 4 * segment['at'], delta=1e-12)
        self.assertEqual(segment['pose']['lift'], -0.11)
        pose = ['%s:=%.17g' % item for item in segment['pose'].items()]
        alone = json.loads(run('-', '--distances', '1', '--format', 'json', *pose, urdf=SLIDE)[1])
        self.assertEqual(alone['distances'][0]['distance'], 0)

    def test_clearance_is_a_demand(self):
        table = 'push,lift\n0,0\n4,0\n'
        self.assertEqual(self.verdicts(table, '--clearance', '0.09'), ['SAFE'])
        self.assertEqual(self.verdicts(table, '--clearance', '0.11', code=3), ['COLLIDES'])

    def test_the_path_is_that_of_the_controller(self):
        """From rest to rest the block stays; with a speed it goes beyond its way points."""
        rest = 'time,push,lift,push.velocity,lift.velocity\n0,0,0.5,0,0\n1,0,0.5,0,0\n'
        dive = 'time,push,lift,push.velocity,lift.velocity\n0,2,0.3,0,%g\n1,2,0.3,0,0\n'
        self.assertEqual(self.verdicts(rest), ['SAFE'])
        # lift = 0.3 + v (s - 2 s^2 + s^3), at most 4/27 v away, where s = 1/3.
        segment, = self.segments(dive % -2)
        self.assertAlmostEqual(segment['nearest'], 0.4 - 8 / 27, delta=0.011)
        self.assertEqual(self.verdicts(dive % -3, code=3), ['COLLIDES'])
        self.assertEqual(self.verdicts(dive.replace('1,2,0.3', '2,2,0.3') % -2, code=3),
                         ['COLLIDES'])
        quintic = ('time,push,lift,push.velocity,lift.velocity,push.acceleration,'
                   'lift.acceleration\n0,2,0.3,0,0,0,%g\n1,2,0.3,0,0,0,0\n')
        # lift = 0.3 + a/2 s^2 (1 - s)^3, at most 0.03456 a/2 away.
        self.assertEqual(self.verdicts(quintic % -20), ['SAFE'])
        self.assertEqual(self.verdicts(quintic % -24, code=3), ['COLLIDES'])

    def test_limits_count_between_rows(self):
        """lift = 0.9 + v (s - 2 s^2 + s^3), and the limit is 1."""
        table = 'time,push,lift,push.velocity,lift.velocity\n0,0,%g,0,%g\n1,0,%g,0,0\n'
        reason = 'between row 1 and row 2, joint "lift" leaves the limits -1 to 1: 1.0'
        for values, leaves in (((.9, .6, .9), False), ((.9, .7, .9), True), ((-1, 0, 1), False)):
            path = self.write('path.csv', table % values)
            with self.subTest(values=values):
                for strict, code in ((), 0), (('--strict',), int(leaves)):
                    found, _, err = run('-', '--poses', path, '--path', *strict, urdf=SLIDE)
                    self.assertEqual((found, reason in err), (code, leaves), err)

    def test_objects_stand_in_the_way(self):
        table = 'push,lift\n-1,0\n1,0\n'
        self.assertEqual(self.verdicts(table), ['SAFE'])
        high, low = self.write('high.yaml', POST % 1), self.write('low.yaml', POST % 0)
        segment, = self.segments(table, '--objects', high, code=3)
        self.assertEqual((segment['first'], segment['second']), ('block', 'post'))
        segment, = self.segments(table, '--objects', low)
        self.assertAlmostEqual(segment['nearest'], 0.1, delta=0.001)
        ended = self.write('ended.yaml', POST % 1 + '---\n')  # as rostopic echo ends a message
        self.assertEqual(self.verdicts(table, '--objects', ended, code=3), ['COLLIDES'])
        self.write('t.stl', tetrahedron())
        mesh = 'rock: {type: MESH_RESOURCE, mesh_resource: t.stl, pose: {position: {x: 2}}}\n'
        self.assertEqual(self.verdicts(table, '--objects', self.write('m.yaml', mesh), code=3),
                         ['COLLIDES'])
        missing = self.write('m.yaml', mesh.replace('t.stl', 'none.stl'))
        result = self.segments(table, '--objects', missing, code=4)
        self.assertEqual(list(result['incomplete']), ['rock'])
        self.assertEqual(result['segments'][0]['verdict'], 'UNDECIDED')
        _, _, err = run('-', '--poses', self.write('path.csv', table), '--path', '--objects', missing,
                        urdf=SLIDE)
        self.assertIn(missing + ': object "rock" (none.stl): cannot find', err)

    def test_faulty_objects_are_refused(self):
        table = self.write('path.csv', 'push,lift\n0,0\n1,0\n')
        for reason, text in (
                ('has no objects', ''), ('is no YAML', 'a: ['), ('has no field "size"', 'a: {size: 1}'),
                ('type of object "a" is "CONE".*CUBE', 'a: {type: CONE, scale: {x: 1, y: 1, z: 1}}'),
                ('has no scale', 'a: {type: CUBE}'),
                ('its scale has no z; give', 'a: {type: CUBE, scale: {x: 1, y: 1}}'),
                ('x is "wide"', 'a: {type: CUBE, scale: {x: wide}}'),
                ('has the name of a link', POST.replace('post', 'block') % 1),
                ('mesh_resource is empty', 'a: {type: MESH_RESOURCE}'),
                ('mesh_resource is for the type MESH_RESOURCE, but the type is "CUBE"',
                 'a: {type: CUBE, scale: {x: 1}, mesh_resource: "file:///t.stl"}'),
                ('scale is negative', 'a: {type: CUBE, scale: {x: -1, y: 1, z: 1}}'),
                ('scale is zero', 'a: {type: CUBE, scale: {x: 0, y: 0, z: 0}}'),
                ('has 2 documents', 'a: {type: CUBE, scale: {x: 1}}\n---\nb: {type: CUBE, scale: {x: 1}}'),
                ('it has "scale" twice', 'a: {type: CUBE, scale: {x: 1}, scale: {x: 2}}'),
                ('orientation is zero', 'a: {type: CUBE, pose: {orientation: {x: 0}}, scale: {x: 1}}')):
            self.check_refused(reason, '-', '--poses', table, '--path', '--objects',
                               self.write('o.yaml', text), urdf=SLIDE)

    def test_a_srdf_leaves_pairs_out(self):
        table = 'push,lift\n0,-0.5\n4,-0.5\n'
        self.assertEqual(self.verdicts(table, code=3), ['COLLIDES'])
        srdf = self.write('slide.srdf', SRDF)
        self.assertEqual(self.verdicts(table, '--srdf', srdf, code=4), ['UNDECIDED'])
        post = self.write('low.yaml', POST % -0.5)
        self.assertEqual(self.verdicts(table, '--srdf', srdf, '--objects', post), ['SAFE'])

    def test_results_do_not_depend_on_the_number_of_jobs(self):
        table = 'push,lift\n' + ''.join('%d,%g\n' % (4 * (i % 2), 0.05 * (i % 7) - 0.15)
                                         for i in range(60))
        path = self.write('path.csv', table)
        outputs = {run('-', '--poses', path, '--path', '--format', 'csv', '--jobs', jobs,
                       urdf=SLIDE) for jobs in ('1', '2', '5')}
        (code, out, _), = outputs
        self.assertEqual(code, 3)
        self.assertEqual(out.splitlines()[0],
                         'from,to,verdict,clearance,nearest,first,second,at,pose')
        self.assertEqual(len(out.splitlines()), 60)
        self.assertIn(',SAFE,', out)

    def test_the_table_names_collisions(self):
        path = self.write('path.csv', 'push,lift\n0,0\n4,0\n0,-0.5\n')
        code, out, err = run('-', '--poses', path, '--path', '--verbose', urdf=SLIDE)
        self.assertEqual(code, 3)
        self.assertRegex(err, r'a segment took [0-9.e-]+ ms in the middle of 2, [0-9.e-]+ ms at most')
        self.assertIn('2 segments: 1 SAFE, 1 COLLIDES, 0 UNDECIDED', out)
        self.assertRegex(out, 'from row 2 to row 3, base and block collide at push:=[-0-9.]+ lift')

    def test_the_example(self):
        """The page shows what is printed: the way points are free, the way between two is not."""
        demo = PACKAGE / 'launch/demo'
        plan = (demo / 'plan.csv').read_text('utf-8').splitlines()
        arguments = ['--path', '--objects', str(demo / 'cell.yaml')]
        code, out, err = run(str(demo / 'demo.urdf'), '--poses', str(demo / 'plan.csv'), *arguments)
        self.assertEqual(code, 3, err)
        page = (PACKAGE / 'doc/tools.md').read_text('utf-8')
        self.assertIn('--path --objects launch/demo/cell.yaml\n```\n\n```\n%s```' % out, page)
        for row in plan[1:]:
            rest = self.write('rest.csv', '\n'.join([plan[0], row, row]) + '\n')
            code, out, err = run(str(demo / 'demo.urdf'), '--poses', rest, *arguments)
            self.assertEqual(code, 0, err)

    def test_what_is_no_path_is_refused(self):
        for reason, table in (
                ('a path needs two or more', 'push,lift\n0,0\n'),
                ('row 2 column "lift" is "nan".*needs all', 'push,lift\n0,0\n0,nan\n1,1\n'),
                ('time of row 2 is not after', 'time,push,push.velocity\n1,0,0\n1,0,0\n'),
                ('not "lift.velocity"', 'time,push,lift,push.velocity\n0,0,0,0\n1,0,0,0\n'),
                ('has velocities but no times', 'push,push.velocity\n0,0\n1,0\n'),
                ('motion to row 3 is not finite', 'time,push,push.velocity\n0,0,0\n1,0,0\n3,0,1e308\n')):
            self.check_refused_last(reason, self.write('p.csv', table))
        for name in 'push.velocty', 'push.effort', 'psuh.velocity':
            table = 'time,push,lift,%s\n0,0,0,0\n1,0,0,0\n' % name
            self.check_refused_last('p.csv: column "%s" would be ignored.*name it JOINT.velocity'
                                    % name, self.write('p.csv', table))
        table = 'time,push,lift,hand,hand.velocity\n0,0,0,0,0\n1,0,0,0,0\n'
        self.assertEqual(self.verdicts(table), ['SAFE'])  # of another robot, with its positions
        path = self.write('p.csv', 'push,lift\n0,0\n1,0\n')
        for reason, arguments in (
                ('add --poses FILE', ['--path']),
                ('--objects is an option of --path', ['--poses', path, '--objects', 'x']),
                ('--series writes rows', ['--poses', path, '--path', '--series', 'x.csv']),
                ('different reports', ['--poses', path, '--path', '--pairs'])):
            self.check_refused(reason, '-', *arguments, urdf=SLIDE)

    def check_refused_last(self, reason, path):
        """Warnings may come before the refusal."""
        code, out, err = run('-', '--poses', path, '--path', urdf=SLIDE)
        self.assertEqual((code, out), (1, ''), err)
        self.assertRegex(err.splitlines()[-1], 'error: .*' + reason)

    def test_numbers_too_large_prove_nothing(self):
        """Their squares are infinite. The block meets the bump in the first metres."""
        for far in '1e155', '1e200', '1e308':
            self.assertEqual(self.verdicts('push,lift\n0,-0.11\n%s,-0.11\n' % far,
                                           '--budget', '5', code=4), ['UNDECIDED'])

    def test_without_time_a_segment_is_undecided(self):
        path = self.write('path.csv', 'push,lift\n0,0\n4,0\n')
        code, out, err = run('-', '--poses', path, '--path', '--budget', '1e-9', urdf=SLIDE)
        self.assertEqual(code, 4, err)
        self.assertIn('1 UNDECIDED', out)
        self.assertIn('UNDECIDED segments: 1', err)


if __name__ == '__main__':
    main()
