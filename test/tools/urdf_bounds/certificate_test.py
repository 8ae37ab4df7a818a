#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_certificate accepts what urdf_bounds --certificate writes with --pairs, --reach and
--path, and nothing that is false.

Run as: certificate_test.py PATH_OF_wrong_urdf_bounds PATH_OF_urdf_bounds
"""
import contextlib
import importlib.machinery
import io
import json
import os
import random
import re
import subprocess
import sys
import types
from unittest import mock

from bad_inputs import SANITIZED
from urdf_bounds_pairs_test import ball, joint, link
from urdf_bounds_testing import UrdfBoundsTest, main, run

PACKAGE = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../..'))
DEMO = os.path.join(PACKAGE, 'launch/demo/demo.urdf')
WRONG = ''
REFUSED, INCOMPLETE = 3, 4  # exit codes
DAMAGES = 20 if SANITIZED else 200  # the checker is the same, and writes no memory itself
NEAR = '0.42'  # metres; the base comes as near as 0.435 m
COARSE = ('--pairs', '--accuracy', '1000', '--budget', '1000')

# With collision geometry in STL files and solids. The others have too many boxes for a test.
PUBLIC = {'ur_description/urdf/ur5e.urdf': '20', 'franka_description/urdf/panda.urdf': '3',
          'husky_description/urdf/husky.urdf': '20'}
if SANITIZED:
    del PUBLIC['franka_description/urdf/panda.urdf']

# A planar and a floating joint, and ranges in which links stay apart for which these turn.
MOBILE = os.path.join(PACKAGE, 'test/data/mobile_arm.urdf')
BASE_RANGES = ('drive.x:=-0.5..0.1', 'drive.y:=-0.1..0.2', 'drive.yaw:=-0.4..0.4', 'lift:=-0.2..0.1',
               'wrist:=-1..1', 'carry.x:=-0.6..-0.5', 'carry.y:=-0.1..0.2', 'carry.z:=-0.1..0.1',
               'carry.yaw:=0.5..0.7', 'carry.pitch:=-0.3..-0.1', 'carry.roll:=-0.1..0.3')

# Joints of the demo.
STILL = ('forearm_roll', 'wrist_roll', 'elbow_bend') + (('wrist_bend',) if SANITIZED else ())
REACH = ('--reach', '--accuracy', '0.05', '--budget', '1000', '--format', 'json')


def lines_of(path):
    with open(path, encoding='utf-8') as file:
        return [json.loads(line) for line in file]


def load_checker():
    folder = os.path.join(PACKAGE, 'scripts')
    sys.path.insert(0, folder)
    path = os.path.join(folder, 'check_certificate')
    loader = importlib.machinery.SourceFileLoader('checker', path)
    module = types.ModuleType('checker')
    module.__file__ = path
    loader.exec_module(module)
    return module


CHECKER = load_checker()


def check(*arguments):
    """Exit code, and what is printed."""
    text = io.StringIO()
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
        code = CHECKER.main(list(arguments))
    return code, text.getvalue()


def write_wrong(*arguments):
    """By an engine whose bodies move too little."""
    subprocess.run([WRONG, *arguments], check=True, stdout=subprocess.DEVNULL)


def box(size, place='0 0 0', turn='0 0 0'):
    return '<origin xyz="%s" rpy="%s"/><geometry><box size="%s"/></geometry>' % (place, turn, size)


def mesh(name, place='0 0 0'):
    path = os.path.join(PACKAGE, 'test/data/meshes', name)
    return ('<origin xyz="%s"/><geometry><mesh filename="file://%s" scale="0.3 0.2 0.2"/>'
            '</geometry>' % (place, path))


def cube_at(place):
    """The triangles of a cube of 0.1 m around it, as the text of an STL file."""
    corners = [[place[0] + x, place[1] + y, z] for x in (-.05, .05) for y in (-.05, .05)
               for z in (-.05, .05)]
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    text = ''
    for a, b, c, d in faces:
        for triangle in ((a, b, c), (a, c, d)):
            text += 'facet normal 0 0 0 outer loop %s endloop endfacet\n' % ' '.join(
                'vertex %r %r %r' % tuple(corners[i]) for i in triangle)
    return text


# Joints of all kinds, backwards and forwards, and shapes of all kinds; nothing collides.
ARM = '<robot name="arm">%s</robot>' % ''.join([
    link('base', box('0.4 0.4 0.2', '0 0 -0.3', '0.1 0.2 0.3')), link('upper', ball(0.05, 0.3)),
    link('lower', mesh('cube.stl', '0.1 0 0')), link('slide', ball(0.03)),
    link('tower', '<origin xyz="0 0 0.2"/><geometry><cylinder radius="0.1" length="0.3"/>'
         '</geometry>'),
    joint('shoulder', 'continuous', 'base', 'upper', '0 0 0.2'),
    joint('elbow', 'revolute', 'upper', 'lower', '0.6 0 0', (-1, 1)),
    joint('push', 'prismatic', 'lower', 'slide', '0.5 0 0.1', (0, 0.3)),
    joint('turn', 'revolute', 'base', 'tower', '-1.9 0 0', (-0.5, 2)).replace(
        '<axis', '<mimic joint="elbow" multiplier="-2" offset="0.5"/><axis')])


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
        self.assertRegex(text, r'arm: [1-9]\d* NEVER; (\d+) of \1 boxes were checked, and all of '
                               r'these hold\n')
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

    def test_ranges_that_the_user_gave(self):
        given = ('elbow:=0..0.5', 'push:=0.1')
        self.assertIn('; elbow:=0..0.5; push:=0.1..0.1\n', self.accept(self.urdf, given=given))
        file, _ = self.certificate(self.urdf, *given)
        for other in ((), given[:1], ('elbow:=0..0.6', 'push:=0.1')):
            code, text = check(file, self.urdf, *other)
            self.assertEqual(code, REFUSED)
            self.assertIn('elbow', text)

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

    def test_a_base_that_is_fixed(self):
        self.accept(MOBILE, '--all', '--base', 'fixed', given=('--base', 'fixed'))
        code, text = check(os.path.join(self.folder, 'file.cert'), MOBILE)
        self.assertEqual(code, REFUSED)
        self.assertIn('see --base', text)
        # What floats behind a joint is no base, so three pairs are open.
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
        stl = self.write('ring.stl', 'solid ring\n%s' % ''.join(map(cube_at, places)))
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


def turned(leaf):
    if leaf == 'mesh':
        return [0, 0, 0]
    return [turned(n) for n in leaf] if isinstance(leaf[0], list) else [-x for x in leaf]


def is_leaf(token):
    return not isinstance(token, int)


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
        self.assertRegex(text, r'arm: 5 links; (\d+) of \1 supports were checked')
        self.assertRegex(check(file, self.urdf, '--sample', '1')[1], ' 5 links; 37 of [0-9]+ supp')
        for entry in lines_of(file)[1:-1]:
            proven = result['reach'][entry['link']]
            for i in range(3):
                for inner, outer in ((proven['min'][i], entry['min'][i]),
                                     (-proven['max'][i], -entry['max'][i])):
                    self.assertGreaterEqual(inner, outer)
                    self.assertLessEqual(inner - outer, entry['slack'] + 1e-9)
            self.assertLessEqual(entry['slack'], float(REACH[2]))

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
                with open(file, 'w', encoding='utf-8') as out:
                    out.writelines(json.dumps(line) + '\n' for line in lines)
                self.assertEqual(check(file, MOBILE, *given)[0], REFUSED)

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
            with open(bad, 'w', encoding='utf-8') as out:
                out.writelines(json.dumps(line) + '\n' for line in lines)
            with self.subTest(number=number, damage=name):
                code, text = check(bad, self.urdf, '--all')
                self.assertEqual(code, REFUSED, text)
        self.assertGreater(len(seen), 18 if DAMAGES == 200 else 8)


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
        with open(self.file, 'w', encoding='utf-8') as file:
            file.writelines(json.dumps(line) + '\n' for line in lines)
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

    def write_certificate(self, table):
        code, out, err = run(self.urdf, '--poses', self.write('path.csv', table), '--path', '--objects',
                             self.objects, '--certificate', self.file)
        self.assertEqual(code, 0, out + err)

    def test_a_table_with_remarks(self):
        """And with a column of words, which is no joint."""
        table = '# a remark\nshoulder,label,elbow,push\n0,a,0,0.1\n \n1,b,0.2,0.2\n0.8,,-0.4,0\n'
        self.write_certificate(table)
        self.check_table(table, 0)

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
        for name, damage in {
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
                with open(self.file, 'w', encoding='utf-8') as file:
                    file.writelines(json.dumps(line) + '\n' for line in lines)
                self.check_table(self.LINEAR, REFUSED)

    def test_what_is_not_in_the_file(self):
        table = self.LINEAR + '2.2,0,0\n'
        code, _, err = run(self.urdf, '--poses', self.write('path.csv', table), '--path', '--objects',
                           self.objects, '--certificate', self.file)
        self.assertEqual(code, 3, err)
        self.assertIn('segments that are not in the file: COLLIDES 1', self.check_table(table, 0))
        self.check_table(self.LINEAR, REFUSED)
        self.assertEqual(check(self.file, self.urdf)[0], REFUSED)


def split_pair(lines):
    """Of the first segment, the pair with the most boxes."""
    return max(lines[1]['pairs'], key=lambda pair: len(pair['tree']))


class DamageTest(UrdfBoundsTest):
    """Each damage makes the file false or malformed."""

    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', ARM)
        self.file = os.path.join(self.folder, 'good.cert')
        self.assertEqual(run(self.urdf, *COARSE, '--certificate', self.file)[0], 0)
        with open(self.file, encoding='utf-8') as file:
            self.lines = [json.loads(line) for line in file]
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
            with open(file, 'w', encoding='utf-8') as out:
                out.writelines(json.dumps(line) + '\n' for line in lines)
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
    WRONG = sys.argv.pop(1)
    main()
