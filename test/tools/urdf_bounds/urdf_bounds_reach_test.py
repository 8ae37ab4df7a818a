#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdf_bounds --reach prints, in every format, and how it ends early.

Run as: urdf_bounds_reach_test.py PATH_OF_urdf_bounds
"""
import csv
import functools
import io
import json
import math
import os
import pty
import re
import signal
import subprocess
import unittest

import yaml

import urdf_bounds_testing
from bad_inputs import SANITIZED
from urdf_bounds_testing import UrdfBoundsTest, boxes, main, run

FACES = ('min_x', 'min_y', 'min_z', 'max_x', 'max_y', 'max_z')
ROUNDING = 1e-12  # metres
INCOMPLETE = 4  # exit code
PACKAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../..')
LONG = 12 if SANITIZED else 40  # joints, more than a minute's work for the accuracy that is asked for


def arm(joints, limit='', kind='continuous'):
    """Links l0, l1, ... 1 m apart along x, which turn about z; a ball of 0.1 m on the last one."""
    links = ''.join('<link name="l%d"/>' % i for i in range(joints))
    ball = ('<link name="l%d"><visual><origin xyz="1 0 0"/><geometry><sphere radius="0.1"/>'
            '</geometry></visual></link>' % joints)
    text = ''.join('''<joint name="j%d" type="%s"><parent link="l%d"/><child link="l%d"/>
<origin xyz="%d 0 0"/><axis xyz="0 0 1"/>%s</joint>''' % (i, kind, i, i + 1, i > 0, limit)
                   for i in range(joints))
    return '<robot name="arm">' + links + ball + text + '</robot>'


@functools.lru_cache(maxsize=None)
def reach(*arguments, urdf):
    """The JSON of a run that must succeed with an empty standard error."""
    code, out, err = run('-', '--reach', '--format', 'json', *arguments, urdf=urdf)
    assert (code, err) == (0, ''), (code, err)
    return json.loads(out)


class ReachTest(UrdfBoundsTest):
    def test_json(self):
        found = reach(urdf=arm(2))
        self.assertEqual(list(found), ['frame', 'accuracy', 'reach', 'groups', 'incomplete'])
        self.assertEqual((found['frame'], found['accuracy'], found['incomplete']),
                         ('l0', 0.01, {}))
        self.assertEqual((list(found['reach']), list(found['groups'])), (['l2'], ['robot']))
        self.assertEqual(found['groups']['robot'], found['reach']['l2'])
        box = found['reach']['l2']
        self.assertEqual(list(box), ['min', 'max', 'gap', 'attained'])
        for low, high, exact in zip(box['min'], box['max'], (2.1, 2.1, 0.1)):
            self.assertTrue(exact <= -low <= exact + 0.01 and exact <= high <= exact + 0.01, box)
        self.assertTrue(all(0 <= gap <= 0.01 for gap in box['gap']), box)

    def test_each_pose_attains_its_face(self):
        urdf = arm(3, '<limit lower="-1" upper="0.7" effort="1" velocity="1"/>', 'revolute')
        box = reach('j1:=0.1..0.5', '--accuracy', '0.001', urdf=urdf)['reach']['l3']
        for face, (gap, pose) in enumerate(zip(box['gap'], box['attained'])):
            corner = ('min', 'max')[face // 3]
            self.assertTrue(0.1 <= pose['j1'] <= 0.5 and -1 <= pose.get('j0', 0) <= 0.7, pose)
            there = boxes(*('%s:=%r' % joint for joint in pose.items()), urdf=urdf)
            self.assertAlmostEqual(abs(there['boxes']['l3'][corner][face % 3]
                                       - box[corner][face % 3]), gap, delta=ROUNDING)
            self.assertLessEqual(gap, 0.001)

    def test_csv(self):
        rows = list(csv.DictReader(io.StringIO(
            run('-', '--reach', '--format=csv', urdf=arm(2))[1])))
        self.assertEqual([row['link'] for row in rows], ['l2', 'group:robot'])
        box = reach(urdf=arm(2))['reach']['l2']
        for row in rows:
            self.assertEqual([float(row[face]) for face in FACES], box['min'] + box['max'])
            self.assertEqual([float(row['gap_' + face]) for face in FACES], box['gap'])

    def test_table(self):
        code, out, err = run('-', '--reach', urdf=arm(1))
        self.assertEqual((code, err), (0, ''))
        self.assertRegex(out, r'^frame: l0    unit: m    .* never leave')
        self.assertRegex(out, r'\nlink +min x .* max z +gap\nl1 +-1\.10')
        self.assertRegex(out, r'\ngroup:robot +-1\.10')

    def test_markers(self):
        box = reach(urdf=arm(2))['reach']['l2']
        code, out, _ = run('-', '--reach', '--format=markers', urdf=arm(2))
        markers = yaml.safe_load(out)['markers']
        self.assertEqual((code, [marker['ns'] for marker in markers]), (0, ['l2', 'robot']))
        for marker in markers:
            self.assertEqual((marker['type'], marker['header']['frame_id']), (5, 'l0'))
            self.assertEqual(len(marker['points']), 24)
            for axis, low, high in zip('xyz', box['min'], box['max']):
                self.assertEqual({point[axis] for point in marker['points']}, {low, high})

    @unittest.skipIf(SANITIZED, 'the numbers of the page are those of the other builds, too')
    def test_example_of_the_page(self):
        with open(os.path.join(PACKAGE, 'launch/demo/demo.urdf'), encoding='utf-8') as file:
            urdf = file.read().replace('package://link_bounds', 'file://' + os.path.realpath(PACKAGE))
        out = run('-', '--reach', urdf=urdf)[1]
        with open(os.path.join(PACKAGE, 'doc/tools.md'), encoding='utf-8') as file:
            text = file.read()
        example = text[text.index(out.splitlines()[0]):].split('```')[0]
        self.assertEqual(len(out.split()), len(example.split()))
        for found, shown in zip(out.split(), example.split()):
            if re.fullmatch(r'-?\d+\.\d{6}', shown):
                self.assertAlmostEqual(float(found), float(shown), delta=1e-4)
            else:
                self.assertEqual(found, shown)

    def test_mimic_joint_without_its_leader(self):
        """Poses name the joints that can be set."""
        urdf = arm(1).replace('</robot>', '''<link name="other"/><joint name="m" type="prismatic">
<parent link="l0"/><child link="other"/><axis xyz="1 0 0"/><mimic joint="j0"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>''')
        self.check_refused('joint "j0" has no limits, and joint "m" that mimics it is elsewhere.*'
                           'j0:=', '-', '--reach', urdf=urdf)
        self.assertEqual(list(reach('j0:=0..1', urdf=urdf)['reach']), ['l1'])

    def test_incomplete(self):
        urdf = arm(1).replace('<link name="l0"/>', '''<link name="l0"><visual><geometry>
<mesh filename="file:///no/such/file.stl"/></geometry></visual></link>''')
        code, out, err = run('-', '--reach', '--strict', '--format=json', urdf=urdf)
        self.assertEqual((code, list(json.loads(out)['incomplete'])),
                         (INCOMPLETE, ['l0', 'group:robot']))
        self.assertEqual(list(json.loads(out)['reach']), ['l1'])
        self.assertRegex(err, 'was answered: incomplete names: 2; --allow-incomplete')
        self.assertEqual(run('-', '--reach', '--allow-incomplete', '--strict', urdf=urdf)[0], 2)
        code, out, _ = run('-', '--reach', urdf=urdf)
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('\n  group:robot: link "l0" is incomplete\n', out)
        code, out, _ = run('-', '--reach', '--allow-incomplete', '--format=csv', urdf=urdf)
        self.assertEqual(code, 0)
        self.assertIn('\nincomplete:group:robot' + 12 * ',' + '\n', out)


class EarlyEndTest(UrdfBoundsTest):
    """The result is then less accurate, but proven, and says so."""

    goal = ('-', '--reach', '--accuracy', '1e-12', '--format', 'json')

    def check(self, code, out, err, cause):
        self.assertEqual(code, INCOMPLETE, err)
        self.assertRegex(err, 'not everything was answered: --accuracy was not reached')
        self.assertRegex(err, 'warning: the boxes are proven, but a face may be too far out by up '
                              r'to [0-9.e-]+ m, more than --accuracy 1e-12 m: ' + cause)
        box = json.loads(out)['reach']['l%d' % LONG]
        self.assertGreaterEqual(min(box['max'][:2] + [-x for x in box['min'][:2]]), LONG + 0.1)
        self.assertGreater(max(box['gap']), 1e-12)
        self.assertEqual(len(box['attained']), 6)

    def test_budget(self):
        for budget in ('1e-9', '0.5'):
            self.check(*run(*self.goal, '--budget', budget, urdf=arm(LONG)), 'raise --budget')

    def test_interrupt(self):
        """Once a bar is drawn, the search is under way."""
        master, slave = pty.openpty()
        with os.fdopen(master, 'rb', buffering=0) as terminal, subprocess.Popen(
                [urdf_bounds_testing.URDF_BOUNDS, *self.goal, '--budget', '1e6'],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=slave) as program:
            os.close(slave)
            program.stdin.write(arm(LONG).encode())
            program.stdin.close()
            text = ''
            while 'largest gap' not in text:
                text += terminal.read(4096).decode()
            program.send_signal(signal.SIGINT)
            out = program.stdout.read().decode()
            while 'not everything was answered' not in text:
                text += terminal.read(4096).decode()
            self.check(program.wait(), out, text, 'interrupted')
        self.assertIn('0/1 links, the largest gap is ', text)


class RefusalTest(UrdfBoundsTest):
    def test_options_that_do_not_go_together(self):
        for text, arguments in (
                ('only one of them', ['--reach', '--pairs']),
                ('--accuracy is an option of --reach or --pairs', ['--accuracy', '1']),
                ('--budget is an option of --reach, --pairs or --path', ['--budget', '1']),
                ('--clearance is an option of --pairs or --path', ['--reach', '--clearance', '1']),
                ('--srdf is an option of --pairs or --path', ['--reach', '--srdf', 'a.srdf']),
                ('--format srdf is an option of --pairs', ['--reach', '--format', 'srdf']),
                ('--format markers is an option of --reach', ['--format', 'markers']),
                ('--volume is about one pose', ['--reach', '--volume', 'sphere']),
                ('--distances is about one pose', ['--reach', '--distances', '1']),
                ('--representation is about one pose', ['--reach', '--representation', 'min-max'])):
            self.check_refused(text, '-', *arguments)

    def test_values(self):
        for option, values in (('--accuracy', ('0', '-1', 'nan', 'x', '')), ('--budget', ('0',))):
            for value in values:
                self.check_refused(option + ' is "%s"' % value, '-', '--reach', option, value)
        self.check_refused('"turn" is given a range, which is for --reach', '-', 'turn:=0..1')
        for text in ('1..0', '0..', '..1', '0..nan', '0..1..2', '0...1x', '0...1', '-1...0.5'):
            self.check_refused('"turn" is "%s"' % text, '-', '--reach', 'turn:=' + text)
        self.check_refused('"elbow" is no movable joint', '-', '--reach', 'elbow:=0..1')

    def test_limits_of_the_urdf(self):
        limit = '<limit lower="%s" upper="%s" effort="1" velocity="1"/>'
        self.check_refused('the lower limit of joint "j0" is above its upper limit.*j0:=', '-',
                           '--reach', urdf=arm(1, limit % (1, -1), 'revolute'))
        for kind in ('revolute', 'prismatic'):
            urdf = arm(1, limit % ('nan', 1), kind)
            self.check_refused('j0|nan', '-', '--reach', urdf=urdf)
            self.check_refused('', '-', '--reach', urdf=arm(1, '', kind))
        self.assertEqual(run('-', '--reach', 'j0:=-1..1',
                             urdf=arm(1, limit % (1, -1), 'revolute'))[0], 0)

    def test_warnings(self):
        limit = '<limit %s effort="1" velocity="1"/>'
        narrow = arm(1, limit % 'lower="-1" upper="1"', 'revolute')
        code, out, err = run('-', '--reach', 'j0:=0..2', '--format=json', urdf=narrow)
        self.assertIn('"j0" at 0 to 2 (limits -1 to 1); the proof is about these values', err)
        self.assertLess(json.loads(out)['reach']['l1']['min'][0], math.cos(2) - 0.1)
        err = run('-', '--reach', urdf=arm(1, limit % '', 'revolute'))[2]
        self.assertRegex(err, 'lower limit is equal to the upper one.*"j0"')
        self.assertEqual(run('-', '--reach', urdf=narrow)[2], '')


if __name__ == '__main__':
    main()
