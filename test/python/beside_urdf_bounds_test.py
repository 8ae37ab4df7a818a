#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""link_bounds.Robot gives the bits of urdf_bounds: on the demo robot, on small ones, and on random
rows of the robots in $LINK_BOUNDS_DATA/robots: beside_urdf_bounds_test.py URDF_BOUNDS"""
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import random
import subprocess
import types
import unittest
import warnings
from unittest import mock

import numpy as np

import link_bounds
import urdf_bounds_testing
from urdf_bounds_testing import ARM, UrdfBoundsTest, main, run, solid

DEMO = str(pathlib.Path(__file__).parents[2] / 'launch/demo/demo.urdf')
DATA = os.environ.get('LINK_BOUNDS_DATA')
ROWS = 100
LIMIT = 0.1  # m
# Each link behind the one before.
JOINTS = ['<joint name="%s%s" type="continuous"><parent link="%s"/><child link="%s"/><origin xyz="3 0 0"/>'
          '</joint>' % tuple(pair * 2) for pair in ('ab', 'bc')]
LEVELS = {'BOX': link_bounds.BOX, 'HULL': link_bounds.HULL, 'MESH': link_bounds.MESH}


def random_rows(robot, count, seed=1):
    chance = random.Random(seed)
    return np.array([[chance.uniform(-math.pi, math.pi) for _ in robot.joints]
                     for _ in range(count)])


class RobotTest(UrdfBoundsTest):
    def run_program(self, urdf, *arguments):
        done = subprocess.run([urdf_bounds_testing.URDF_BOUNDS, urdf, *arguments], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8')
        self.assertIn(done.returncode, (0, 3, 4), done.stderr)
        return done.stdout

    def series(self, urdf, joints, rows, *arguments):
        """The lines of --series."""
        lines = [','.join(joints)] + [','.join('%.17g' % value for value in row) for row in rows]
        table, out = self.write('table.csv', '\n'.join(lines) + '\n'), self.folder + '/series.csv'
        self.run_program(urdf, '--poses', table, '--series', out, *arguments)
        with open(out, encoding='utf-8', newline='') as file:
            return list(csv.reader(file))[1:]

    def check_boxes(self, robot, urdf, rows, geometry):
        expected = [line for line in self.series(urdf, robot.joints, rows, '--geometry', geometry)
                    if not line[1].startswith('group:')]
        found = robot.boxes(rows, jobs=2)
        self.assertEqual(found.shape, (len(rows), len(robot.links), 2, 3))
        lines = [[str(row + 1), link] for row in range(len(rows)) for link in robot.links]
        self.assertEqual([line[:2] for line in expected], lines)
        numbers = np.array([[float(x) for x in line[2:]] for line in expected])
        self.assertEqual(numbers.tobytes(), (found + 0.0).tobytes())
        for row in range(0, len(rows), 17):
            self.assertEqual(robot.boxes(rows[row]).tobytes(), found[row].tobytes())

    def check_distances(self, robot, urdf, rows, geometry):
        expected = self.series(urdf, robot.joints, rows, '--geometry', geometry, '--distances',
                               str(LIMIT))
        found = robot.distances(rows, LIMIT, jobs=2)
        self.assertEqual(len(found), len(expected))
        for pair, line in zip(found, expected):
            names = [robot.links[pair['first']], robot.links[pair['second']]]
            self.assertEqual([str(pair['row'] + 1)] + names, line[:3])
            numbers = np.concatenate([[pair['distance'], pair['distance_max']], pair['on_first'],
                                      pair['on_second'], pair['normal']]) + 0.0
            self.assertEqual(numbers.tolist(), [float(x) for x in line[3:-1]])
            self.assertEqual(pair['level'], LEVELS[line[-1]])
        for row in range(0, len(rows), 17):
            alone = robot.distances(rows[row], LIMIT)
            self.assertEqual(alone['distance'].tolist(),
                             found[found['row'] == row]['distance'].tolist())
        return len(found)

    def test_boxes_and_distances_of_the_demo(self):
        for geometry in ('visual', 'collision', 'both'):
            robot = link_bounds.Robot(DEMO, geometry)
            rows = random_rows(robot, ROWS)
            self.check_boxes(robot, DEMO, rows, geometry)
            self.assertGreater(self.check_distances(robot, DEMO, rows, geometry), ROWS)

    def test_boxes_and_distances_of_public_robots(self):
        if not DATA:
            print('skipped: boxes and distances of public robots in Python: LINK_BOUNDS_DATA is not set')
            self.skipTest('LINK_BOUNDS_DATA is not set')
        data = pathlib.Path(DATA, 'robots')
        paths = os.pathsep.join([str(data), os.environ['ROS_PACKAGE_PATH']])
        environment = mock.patch.dict(os.environ, ROS_PACKAGE_PATH=paths)
        environment.start()
        self.addCleanup(environment.stop)
        robots = json.loads((data / 'robots.json').read_text('utf-8'))['robots']
        self.assertTrue(robots)
        for entry in robots:
            with self.subTest(entry['id']), warnings.catch_warnings():
                warnings.simplefilter('ignore')
                urdf = str(data / entry['urdf'])
                robot = link_bounds.Robot(urdf, allow_incomplete=True)
                if not robot.joints or not robot.links:
                    continue
                rows = random_rows(robot, ROWS)
                self.check_boxes(robot, urdf, rows, 'visual')
                self.check_distances(robot, urdf, rows, 'visual')

    def test_reach(self):
        expected = json.loads(self.run_program(DEMO, '--reach', '--format', 'json',
                                               'elbow_bend:=0.1..0.2'))['reach']
        found = link_bounds.Robot(DEMO).reach({'elbow_bend': (0.1, 0.2)})
        self.assertEqual(list(found), list(expected))
        for link, reach in found.items():
            self.assertEqual(reach.box.tolist(), [expected[link]['min'], expected[link]['max']])
            self.assertEqual(reach.gap.ravel().tolist(), expected[link]['gap'])
            self.assertEqual(reach.attained, expected[link]['attained'])

    def test_pairs(self):
        urdf = self.write('arm.urdf', ARM)
        expected = json.loads(self.run_program(urdf, '--pairs', '--adjacent', '--geometry', 'both',
                                               '--format', 'json'))['pairs']
        found = link_bounds.Robot(urdf, 'both').pairs(adjacent=True)
        self.assertEqual([(p.first, p.second, p.verdict, p.clearance, p.pose) for p in found],
                         [(p['first'], p['second'], p['verdict'], p['clearance'], p['pose'])
                          for p in expected])
        self.assertTrue(any(pair.verdict == 'SOMETIMES' for pair in found))

    def check_path(self, urdf, rows, *arguments, columns=None, **options):
        """The segments of both, which are the same."""
        robot = link_bounds.Robot(urdf)
        names, lines = columns or robot.joints, rows
        if 'times' in options:
            lines = [[time, *pose, *speed] for time, pose, speed in
                     zip(options['times'], rows, options['velocities'])]
        table = self.write('path.csv', ','.join(names) + '\n' + ''.join(
            ','.join('%.17g' % value for value in line) + '\n' for line in lines))
        expected = json.loads(self.run_program(urdf, '--poses', table, '--path', '--format', 'json',
                                               *arguments))['segments']
        found = robot.check_path(rows, **options)
        self.assertEqual(
            [{'from': s.start + 1, 'to': s.start + 2, 'verdict': s.verdict,
              'clearance': s.clearance, 'nearest': s.nearest, 'first': s.first,
              'second': s.second, 'at': s.at, 'pose': s.pose} for s in found], expected)
        return [segment.verdict for segment in found]

    def test_paths(self):
        rows = random_rows(link_bounds.Robot(DEMO), 40)
        verdicts = self.check_path(DEMO, rows, '--clearance', '0.01', clearance=0.01)
        self.assertEqual(set(verdicts), {'SAFE', 'COLLIDES'})

    def test_paths_with_velocities_objects_and_a_srdf(self):
        urdf = self.write('arm.urdf', ARM)
        rows = np.array([[0, 0.1], [1, 0.2], [0.5, 0.3]])
        speeds, times = np.array([[0, 0], [0.5, 0.1], [0, 0]]), [0, 1, 2.5]
        columns = ['time', 'turn', 'push', 'turn.velocity', 'push.velocity']
        objects = self.write('o.yaml', 'far: {type: SPHERE, pose: {position: {x: 5}}, '
                                       'scale: {x: 1, y: 1, z: 1}}\n')
        srdf = self.write('arm.srdf', '<robot name="arm"><disable_collisions link1="base" '
                                      'link2="follower" reason="User"/></robot>')
        self.check_path(urdf, rows, columns=columns, velocities=speeds, times=times)
        verdicts = self.check_path(urdf, rows, '--objects', objects, '--srdf', srdf,
                                   columns=columns, velocities=speeds, times=times,
                                   objects=objects, srdf=srdf)
        self.assertEqual(len(verdicts), 2)
        other = self.write('other.srdf', '<robot name="leg"/>')
        with self.assertWarnsRegex(RuntimeWarning, 'other.srdf.*"leg".*"arm"'):
            link_bounds.Robot(urdf).check_path(rows, srdf=other)

    def test_warnings_of_proofs(self):
        """Are those of urdf_bounds."""
        robot = link_bounds.Robot(ARM)
        with self.assertWarnsRegex(RuntimeWarning, '"turn" at 4 .limits -3 to 3'):
            robot.pairs({'turn': 4})
        with self.assertWarnsRegex(RuntimeWarning, '"turn" at -4 to 0 .limits -3 to 3'):
            robot.reach({'turn': (-4, 0)})
        still = link_bounds.Robot(ARM.replace('lower="-3" upper="3"', '', 1))
        with self.assertWarnsRegex(RuntimeWarning, 'joints stay there: "turn"'):
            still.pairs()
        with self.assertWarnsRegex(RuntimeWarning, r'in q\[1\], joint "turn" leaves .*-3 to 3: 4'):
            robot.check_path([[0, 0], [4, 0]])
        with self.assertWarnsRegex(RuntimeWarning, r'between q\[0\] and q\[1\], joint "turn"'):
            robot.check_path([[0, 0], [2, 0]], velocities=[[99, 0], [0, 0]], times=[0, 1])
        every = ''.join('<disable_collisions link1="%s" link2="%s" reason="User"/>' % pair for pair in
                        (('base', 'bar'), ('base', 'follower'), ('bar', 'follower')))
        srdf = self.write('every.srdf', '<robot name="arm">%s</robot>' % every)
        with self.assertWarnsRegex(RuntimeWarning, 'no two bodies were compared'):
            segment, = robot.check_path([[0, 0], [1, 0]], srdf=srdf)
        self.assertEqual(segment.verdict, 'UNDECIDED')
        self.assertEqual(list(robot.reach({'turn': np.array(0.5)})), robot.links)

    def warned(self, call):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter('always')
            call()
        return [str(warning.message) for warning in caught]

    def test_proofs_about_nothing(self):
        """Of no pair, each is NEVER."""
        one, two, three = ('<robot name="r">%s</robot>' % ''.join(
            solid(name) + joint for name, joint in zip('abc'[:count], ('', *JOINTS)))
                           for count in (1, 2, 3))
        no_box, no_pair = ['no link has a box'], ['no pair was examined']
        for urdf, reach, pairs in (
                ('<robot name="r"><link name="a"/></robot>', no_box, no_pair), (one, [], no_pair),
                (two.replace('continuous', 'fixed'), [], no_pair), (two, [], no_pair),
                (three, [], [])):
            robot, path = link_bounds.Robot(urdf), self.write('r.urdf', urdf)
            for option, call, words in (('--reach', robot.reach, reach),
                                        ('--pairs', robot.pairs, pairs)):
                self.assertEqual(self.warned(lambda: call(budget=1, accuracy=1)), words, urdf)
                code, _, err = run(path, option, '--budget', '1', '--accuracy', '1')
                self.assertEqual((code, all(each in err for each in words)),
                                 (4 if words else 0, True), err)
        robot = link_bounds.Robot(two)
        self.assertEqual(self.warned(lambda: robot.pairs(adjacent=True, budget=1)), [])

    def test_forms_of_a_pose(self):
        robot = link_bounds.Robot(ARM)
        self.assertEqual(robot.links, ['base', 'bar', 'follower'])
        self.assertEqual(robot.joints, ['turn', 'push'])
        self.assertEqual(robot.frame, 'base')
        expected = robot.boxes([0.5, 0])
        self.assertEqual(expected.shape, (3, 2, 3))
        for q in ({'turn': 0.5}, (0.5, 0.0), np.array([0.5, 0], 'f4'), np.array([[0.5, 0]])[0],
                  {'turn': np.float64(0.5), 'push': 0}, types.MappingProxyType({'turn': 0.5})):
            self.assertEqual(robot.boxes(q).tobytes(), expected.tobytes())
        for rows in ([{'turn': 0.5}, {}], (types.MappingProxyType({'turn': 0.5}), {}), [[0.5, 0], [0, 0]], np.array([[0.5, 0], [0, 0]]),
                     np.asfortranarray([[0.5, 0], [0, 0]])):
            found = robot.boxes(rows)
            self.assertEqual(found.shape, (2, 3, 2, 3))
            self.assertEqual(found[0].tobytes(), expected.tobytes())
        self.assertEqual(robot.boxes(np.empty((0, 2))).shape, (0, 3, 2, 3))
        self.assertEqual(robot.distances(np.empty((0, 2)), 1).shape, (0,))
        with self.assertWarnsRegex(RuntimeWarning, '"follow" is ignored, it mimics joint "turn"'):
            robot.boxes({'follow': 1})

    def test_a_floating_base(self):
        urdf = ARM.replace('type="prismatic"', 'type="floating"')
        robot = link_bounds.Robot(urdf, 'collision')
        self.assertIn('push.x', robot.joints)
        with self.assertWarnsRegex(RuntimeWarning, 'link "slide": it depends on "push"'):
            self.assertEqual(list(robot.reach()), ['base'])
        ranges = {'push.x': 1, 'push.y': 0, 'push.z': (0, 1)}
        for given in (ranges, types.MappingProxyType(ranges)):
            self.assertEqual(list(robot.reach(given)), ['base', 'slide'])
        self.assertEqual(list(robot.reach(fixed_base=True)), ['base', 'slide'])

    def test_packages(self):
        mesh = self.write('models/box/t.stl', urdf_bounds_testing.tetrahedron())
        urdf = urdf_bounds_testing.tree(urdf_bounds_testing.mesh('a', 'package://models/box/t.stl'))
        folder = os.path.dirname(os.path.dirname(mesh))
        packages = {'models': folder}
        for given in (packages, types.MappingProxyType(packages)):
            robot = link_bounds.Robot(urdf, packages=given)
            np.testing.assert_allclose(robot.boxes([])[0], [[0, 0, 0], [1, 2, 3]], atol=1e-12)

    def test_errors_in_the_words_of_the_command_line(self):
        lost = self.write('lost.urdf', urdf_bounds_testing.tree(
            urdf_bounds_testing.mesh('a', 'file:///no/such.stl')))
        text, arm = self.write('text.urdf', '<robot'), self.write('arm.urdf', ARM)
        for urdf, joint in (('/no/such.urdf', None), (text, None), (lost, None), (arm, 'elbow')):
            error = ValueError if joint else link_bounds.RobotError
            with self.subTest(urdf), self.assertRaises(error) as raised:
                link_bounds.Robot(urdf).boxes({joint: 0} if joint else {})
            given = ['%s:=0' % joint] if joint else []
            done = subprocess.run([urdf_bounds_testing.URDF_BOUNDS, urdf, *given], check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8')
            self.assertIn(str(raised.exception), done.stderr)

    def test_two_threads_at_once(self):
        robot = link_bounds.Robot(DEMO)
        rows = random_rows(robot, 200)
        boxes, distances = robot.boxes(rows), robot.distances(rows, LIMIT)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            many = [pool.submit(robot.boxes, rows), pool.submit(robot.distances, rows, LIMIT)] * 3
            one = [pool.submit(robot.boxes, row) for row in rows]
            for number, found in enumerate(many):
                expected = distances if number % 2 else boxes
                self.assertEqual(found.result().tobytes(), expected.tobytes())
            for found, expected in zip(one, boxes):
                self.assertEqual(found.result().tobytes(), expected.tobytes())

    def test_the_stub_names_what_is_there(self):
        import ast
        import inspect
        stub = pathlib.Path(__file__).parents[2] / 'src/python/link_bounds/__init__.pyi'
        classes = {node.name: node for node in ast.parse(stub.read_text('utf-8')).body
                   if isinstance(node, ast.ClassDef)}
        for name in ('Robot', 'Reach', 'Pair', 'Segment'):
            there = {each for each in dir(getattr(link_bounds, name)) if not each.startswith('_')}
            members = {node.name: node for node in classes[name].body}
            self.assertEqual(there, set(members) - {'__init__'}, name)
            for member, node in members.items():
                text = inspect.getdoc(getattr(getattr(link_bounds, name), member))
                self.assertTrue(text and not text.startswith('Initialize self'), member)
                for argument in node.args.args[1:]:
                    self.assertIn('%s: ' % argument.arg, text, member)
        self.assertIn('RuntimeWarning', link_bounds.Robot.__doc__)


if __name__ == '__main__':
    main()
