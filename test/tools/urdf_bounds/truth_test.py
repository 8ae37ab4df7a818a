#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares urdf_bounds with the true boxes of real robots in $LINK_BOUNDS_DATA/robots.

Run as: truth_test.py PATH_OF_urdf_bounds
"""
import json
import os
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

# The truth was computed from decimal texts in double, our vertices are float32.
RELATIVE_TOLERANCE = 4e-6  # of the largest |coordinate| or the size of a box
ABSOLUTE_TOLERANCE = 1e-8  # metres

URDF_BOUNDS = ''
DATA = os.path.join(os.environ.get('LINK_BOUNDS_DATA', ''), 'robots')
SANITIZED = 'ASAN_OPTIONS' in os.environ
MOVED_BUNNY = 'bunny_nested_moved_dae'


def missing():
    """Why nothing can be compared."""
    if not os.environ.get('LINK_BOUNDS_DATA'):
        return 'LINK_BOUNDS_DATA is not set'
    has_truth = os.path.exists(os.path.join(DATA, 'robots.json'))
    return None if has_truth else 'LINK_BOUNDS_DATA has no robots/robots.json'


def load_json(*path):
    with open(os.path.join(DATA, *path), encoding='utf-8') as file:
        return json.load(file)


def run(urdf, geometry, joints):
    """The JSON of urdf_bounds, and its standard error."""
    command = [URDF_BOUNDS, os.path.join(DATA, urdf), '--format', 'json', '--geometry', geometry]
    command += ['%s:=%r' % joint for joint in joints.items()]
    environment = dict(os.environ, ROS_PACKAGE_PATH=DATA)
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=300, check=False)
    if done.returncode != 0:
        raise AssertionError('%s: exit %d: %r' % (command, done.returncode, done.stderr))
    return json.loads(done.stdout.decode('utf-8')), done.stderr.decode('utf-8')


def links_of(urdf):
    """The mesh files of each link, in the order of the text, for each kind of geometry."""
    result = {}
    for link in ElementTree.parse(os.path.join(DATA, urdf)).getroot().findall('link'):
        result[link.get('name')] = {
            kind: [mesh.get('filename').lower() for mesh in link.findall(kind + '/geometry/mesh')]
            for kind in ('visual', 'collision')}
    return result


def tolerance(low, high):
    largest = max(abs(x) for x in low + high)
    size = max(b - a for a, b in zip(low, high))
    return RELATIVE_TOLERANCE * max(largest, size) + ABSOLUTE_TOLERANCE


class Worst:
    """The largest error so far, and where it was."""

    def __init__(self):
        self.error, self.relative, self.where = 0.0, 0.0, 'nowhere'

    def add(self, error, allowed, where):
        self.error = max(self.error, error)
        if error / allowed >= self.relative:
            self.relative, self.where = error / allowed, where

    def __str__(self):
        return '%.3g m (%.2g of the tolerance at %s)' % (self.error, self.relative, self.where)


class TruthTest(unittest.TestCase):
    compared = 0
    worst = Worst()
    worst_exact = Worst()  # of links made of STL, PLY and solids only

    def test_every_box_of_every_robot(self):
        robots = load_json('robots.json')['robots']
        self.assertGreater(len(robots), 0)
        for robot in robots:
            truth = load_json(robot['truth'])
            links = links_of(robot['urdf'])
            self.assertGreater(len(truth['configs']), 0)
            # A program under a sanitizer is slow; the first two configurations run all its code.
            count = min(2, len(truth['configs'])) if SANITIZED else len(truth['configs'])
            for index in range(count):
                for geometry in ('visual', 'collision'):
                    with self.subTest(robot=robot['id'], config=index, geometry=geometry):
                        self.check_robot(robot, truth, index, geometry, links)
        self.assertGreater(TruthTest.compared, 0)

    def check_robot(self, robot, truth, index, geometry, links):
        config = truth['configs'][index]
        joints = {name: config['joints'][name] for name in config['independent']}
        found, messages = run(robot['urdf'], geometry, joints)
        expected = {name: states[index][geometry] for name, states in truth['links'].items()}
        bounded = {name: box for name, box in expected.items() if box}
        self.assertEqual(found['frame'], truth['root_link'])
        self.assertEqual(list(found['boxes']), [n for n in links if loadable(expected.get(n))])
        lost = {name for name, box in bounded.items() if box['unloadable'] > 0}
        self.assertEqual(set(found['incomplete']), lost | ({'group:robot'} if lost else set()))
        for name in lost:
            self.assertIn('"%s"' % name, messages)
        for name, box in found['boxes'].items():
            self.check_box(box, bounded[name], '%s/%s' % (robot['id'], name),
                           links[name][geometry])
        self.check_group(found)

    def check_box(self, box, truth, where, meshes):
        self.assertEqual((len(box['min']), len(box['max'])), (3, 3))
        allowed = tolerance(truth['aabb_min'], truth['aabb_max'])
        error = max(abs(a - b) for a, b in zip(box['min'] + box['max'],
                                               truth['aabb_min'] + truth['aabb_max']))
        self.assertLessEqual(error, allowed, where)
        TruthTest.compared += 1
        TruthTest.worst.add(error, allowed, where)
        if all(mesh.endswith(('.stl', '.ply')) for mesh in meshes):
            TruthTest.worst_exact.add(error, allowed, where)

    def check_group(self, found):
        boxes = list(found['boxes'].values())
        union = {'robot': {'min': [min(v) for v in zip(*(b['min'] for b in boxes))],
                           'max': [max(v) for v in zip(*(b['max'] for b in boxes))]}}
        self.assertEqual(found['groups'], union if boxes else {})

    def test_one_bunny_in_all_formats(self):
        urdf = next(r['urdf'] for r in load_json('robots.json')['robots']
                    if r['id'] == 'bunny_formats')
        boxes = run(urdf, 'visual', {})[0]['boxes']
        moved = boxes.pop(MOVED_BUNNY)
        self.assertEqual(len(boxes), 17)
        reference = boxes['bunny_bin_stl']
        for name, box in boxes.items():
            self.assertLess(difference(box, reference), 1e-6, name)  # float32 at 10 m
        self.assertGreater(difference(moved, reference), 1)


def loadable(truth):
    """Whether the truth has a box of the link, or of a part of it."""
    return bool(truth) and truth['aabb_min'] is not None


def difference(box, other):
    return max(abs(a - b) for a, b in zip(box['min'] + box['max'], other['min'] + other['max']))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if missing():
        print('skipped: %s' % missing())
        return
    global URDF_BOUNDS
    URDF_BOUNDS = os.path.abspath(sys.argv.pop())
    result = unittest.main(exit=False).result
    print('truth: %d boxes compared; worst error %s; STL, PLY and solids only: %s'
          % (TruthTest.compared, TruthTest.worst, TruthTest.worst_exact))
    sys.exit(not result.wasSuccessful())


if __name__ == '__main__':
    main()
