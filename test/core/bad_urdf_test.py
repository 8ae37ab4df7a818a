#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Broken, hostile and odd robots in $LINK_BOUNDS_DATA/bad, each through urdf_bounds.

Run as: bad_urdf_test.py PATH_OF_urdf_bounds
"""
import json
import math
import os
import resource
import subprocess
import sys
import unittest

URDF_BOUNDS = ''
DATA = os.path.join(os.environ.get('LINK_BOUNDS_DATA', ''), 'bad')
# A program under AddressSanitizer is slow, and claims more address space than any limit allows.
SANITIZED = 'ASAN_OPTIONS' in os.environ
TIMEOUT_SECONDS = 90 if SANITIZED else 20
MEMORY_BYTES = 4000000 * 1024

BASE = ([-.5, -1, -1.5], [.5, 1, 1.5])
GOOD = ([0, 0, 5], [1, 1, 6])
UNIT = ([-.5] * 3, [.5] * 3)


def refused(words):
    """Exit 1, nothing on standard output, one error with these words."""
    return {'exit': 1, 'words': words}


def lost(words):
    """Base and good exact, bad without a box, named with these words."""
    return {'boxes': {'base': BASE, 'good': GOOD}, 'incomplete': ['bad'], 'words': words}


def boxed(**others):
    """Base and good exact, and so are the others; nothing is incomplete."""
    return {'boxes': dict({'base': BASE, 'good': GOOD}, **others)}


def bad_at_ten(low, high):
    """Link bad stands 10 m along x of the base."""
    return boxed(bad=([low[0] + 10] + low[1:], [high[0] + 10] + high[1:]))


def about(row):
    """Decimal text in the file, float32 in our vertices."""
    return dict(row, within=5e-8)


def along_x(prefix, numbers, step):
    """Unit boxes at x = number * step."""
    return {'boxes': {'%s%d' % (prefix, i): ([i * step - .5, -.5, -.5], [i * step + .5, .5, .5])
                      for i in numbers}}


URDF = {
    'good.urdf': boxed(),
    'missing_mesh.urdf': lost('does_not_exist.stl'),
    'missing_package.urdf': lost('no package "no_such_package_xyz"'),
    'file_uri_dev_zero.urdf': lost('/dev/zero is not a regular file'),
    'file_uri_directory.urdf': lost('/tmp is not a regular file'),
    'http_uri.urdf': lost('http://127.0.0.1:9/a.stl'),
    'no_filename.urdf': lost('filename'),
    'relative_uri.urdf': lost('meshes/good_cube.stl'),
    'triple_slash_package.urdf': lost('names no package'),
    'spaces_and_percent.urdf': bad_at_ten([0, 0, 0], [2, 2, 2]),  # %20 stands for a space
    'cycle.urdf': refused('loop'),
    'cycle_no_root.urdf': refused('root'),
    'two_roots.urdf': refused('[a] and [b]'),
    'two_parents.urdf': refused('"c" has two parents'),
    'self_child.urdf': refused('root'),
    'duplicate_links.urdf': refused("'x' is not unique"),
    'duplicate_joints.urdf': refused("'j' is not unique"),
    'empty_string.urdf': refused('empty'),
    'not_xml.urdf': refused('not a usable URDF'),
    'truncated_xml.urdf': refused('not a usable URDF'),
    'root_not_robot.urdf': refused("'robot'"),
    'negative_box.urdf': lost('negative'),
    'zero_box.urdf': bad_at_ten([0, 0, 0], [0, 0, 0]),
    'nan_box.urdf': lost('nan'),
    'negative_radius.urdf': lost('negative'),
    'nan_origin.urdf': lost('nan'),
    'inf_origin.urdf': lost('inf'),
    'comma_decimal.urdf': lost('1,5'),
    'zero_scale.urdf': bad_at_ten([0, 0, 0], [0, 1, 1]),
    'nan_scale.urdf': lost('nan'),
    'negative_scale.urdf': bad_at_ten([-1, -2, 0], [0, 0, 3]),
    'four_number_scale.urdf': lost('scale'),
    'bad_inertial_drops_geometry.urdf': lost('inertial'),
    'one_bad_of_three_visuals.urdf': {
        'boxes': {'base': BASE, 'good': GOOD, 'bad': ([-1] * 3, [1] * 3)},
        'incomplete': ['bad'], 'words': 'visual 2'},
    'floating_planar.urdf': boxed(f=UNIT, p=UNIT),  # no tf here: these joints stand at zero
    'odd_link_names.urdf': {'boxes': {name: UNIT for name in (
        'with space', '/leading_slash', 'a/b', 'ümläut_链接', '"quot"', '.', 'x' * 5000)}},
    'external_entity.urdf': refused('not a usable URDF'),
    'declaration_not_first.urdf': boxed(),
    'latin1_bytes.urdf': boxed(),
    'deep_20000.urdf': along_x('l', range(0, 20000, 100), .001),
    'wide_20000.urdf': along_x('l', range(20000), 1),
    'visuals_10000_in_one_link.urdf': {'boxes': {'base': ([-.1] * 3, [9999.1, .1, .1])}},
    'same_mesh_1000_links.urdf': {'boxes': {'l%d' % i: ([0] * 3, [1] * 3) for i in range(1000)}},
}

# Those that in-process import survives and bounds rightly.
MESH = {
    'good_cube.stl': bad_at_ten([0, 0, 0], [1, 1, 1]),
    'truncated_binary.stl': lost('truncated_binary.stl'),
    'lying_count_huge.stl': lost('lying_count_huge.stl'),
    'lying_count_big.stl': lost('lying_count_big.stl'),
    'lying_count_small.stl': lost('lying_count_small.stl'),
    'empty_0_bytes.stl': lost('empty'),
    'zero_triangles.stl': lost('no facets'),
    'header_only_40_bytes.stl': lost('header_only_40_bytes.stl'),
    'one_inf_vertex.stl': lost('not a finite number'),
    'all_nan.stl': lost('not a finite number'),
    'single_triangle.stl': bad_at_ten([0, 0, 0], [1, 2, 3]),
    'coplanar_z0.stl': bad_at_ten([0, 0, 0], [10, 10, 0]),
    'collinear.stl': bad_at_ten([0, 0, 0], [11, 22, 33]),
    'one_vertex_no_face.obj': lost('one_vertex_no_face.obj'),
    'unreferenced_far_vertex.obj': bad_at_ten([0, 0, 0], [1, 1, 1]),
    'huge_1e30.stl': bad_at_ten([0, 0, 0], [1.0000000150474662e30] * 3),
    'huge_3e38.stl': bad_at_ten([0, 0, 0], [3.000000005497804e38] * 3),
    'denormal_1e-40.stl': bad_at_ten([0, 0, 0], [1e-40] * 3),
    'truncated_ascii.stl': lost('truncated_ascii.stl'),
    'garbage_numbers_ascii.stl': lost('real number'),
    'bad_index_zero.obj': lost('index'),
    'obj_mtllib_etc_passwd.obj': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'ngon_10000.obj': bad_at_ten([-1, -1, 0], [1, 1, 0]),
    'ply_header_1e9_vertices.ply': lost('ply_header_1e9_vertices.ply'),
    'ply_face_index_out_of_range.ply': lost('vertex 77 of 3'),
    'ply_huge_list.ply': lost('ply_huge_list.ply'),
    'dae_nested_5000.dae': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'dae_unit_nan.dae': lost('not a finite number'),
    'dae_node_matrix_nan.dae': lost('not a finite number'),
    'dae_lines_only.dae': lost('no triangle'),
    'dae_missing_geometry.dae': lost('no triangle'),
    'dae_unit_zero.dae': lost('unit of length is zero'),
    'real_igea_tristrips.ply': lost('triangle strips'),
    'dae_billion_laughs.dae': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'text_named.stl': lost('text_named.stl'),
    'text_named.dae': lost('text_named.dae'),
    'random_bytes.obj': lost('random_bytes.obj'),
    'stl_no_extension': lost('stl_no_extension'),
    'gltf_outside_buffer.gltf': lost('could not open'),
    'gltf_huge_accessor.gltf': lost('out of range'),
    'real_r200_lines.dae': about(bad_at_ten([0, 0, -.0006146885], [.13, .02, .0057])),
    'real_iiwa_base_junk_after_end.dae': about(bad_at_ten([-.136, -.121265, 0],
                                                          [.121471, .121325, .1575])),
}


def limit_memory():
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))


def run(urdf):
    """Exit code, parsed standard output (None if there is none), lines of standard error."""
    environment = dict(os.environ, ROS_PACKAGE_PATH=DATA)
    path = os.path.join(DATA, 'bad_inputs', 'urdf', urdf)
    done = subprocess.run([URDF_BOUNDS, path, '--format', 'json'], env=environment,
                          preexec_fn=limit_memory, timeout=TIMEOUT_SECONDS, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    out = done.stdout.decode('utf-8')
    return done.returncode, json.loads(out) if out else None, done.stderr.decode('utf-8')


NEEDS_LIMIT = ['ply_header_1e9_vertices.ply', 'ply_huge_list.ply']


def cases(kind):
    with open(os.path.join(DATA, 'cases.json'), encoding='utf-8') as file:
        return [name for of_kind, name, *_ in json.load(file) if of_kind == kind]


class BadUrdfTest(unittest.TestCase):
    def test_every_urdf_case(self):
        names = cases('urdf')
        self.assertEqual(set(URDF) - set(names), set(), 'cases without a file')
        for name in names:
            with self.subTest(case=name):
                self.check(name, URDF.get(name, {}))

    def test_mesh_cases(self):
        self.assertEqual(set(MESH) - set(cases('mesh')), set(), 'cases without a file')
        for name, expected in MESH.items():
            if SANITIZED and name in NEEDS_LIMIT:
                print('skipped: %s under a sanitizer, where memory cannot be limited' % name)
                continue
            with self.subTest(case=name):
                self.check('mesh__%s.urdf' % name.replace('.', '_'), expected)

    def check(self, urdf, expected):
        code, found, messages = run(urdf)
        self.check_rule(code, found, messages)
        if not expected:
            return
        self.assertEqual(code, expected.get('exit', 0), messages)
        self.assertIn(expected.get('words', ''), messages)
        if code == 0:
            self.check_boxes(found, expected['boxes'], expected.get('within', 1e-9))
            self.assertEqual(list(found['incomplete']), expected.get('incomplete', []))
            self.assertEqual(messages.count('link "'), len(found['incomplete']))

    def check_rule(self, code, found, messages):
        """What holds for every input, also for one that is not in the tables."""
        self.assertIn(code, (0, 1), messages)
        self.assertNotIn('root:x:', '%s%s' % (found, messages))
        if code == 1:
            self.assertIsNone(found)
            self.assertEqual(messages.count('urdf_bounds: error: '), 1)
            return
        self.assertEqual(messages.count('urdf_bounds: error: '), 0)
        for box in list(found['boxes'].values()) + list(found['groups'].values()):
            for low, high in zip(box['min'], box['max']):
                self.assertTrue(math.isfinite(low) and math.isfinite(high) and low <= high, box)
        for name, reason in found['incomplete'].items():
            self.assertNotEqual(reason, '')
            self.assertIn('urdf_bounds: warning: link "%s"' % name, messages)

    def check_boxes(self, found, expected, within):
        self.assertEqual(set(found['boxes']), set(expected))
        for name, (low, high) in expected.items():
            box = found['boxes'][name]
            allowed = within + 1e-12 * max(abs(x) for x in low + high)
            for value, exact in zip(box['min'] + box['max'], low + high):
                self.assertAlmostEqual(value, exact, delta=allowed, msg=name)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not os.environ.get('LINK_BOUNDS_DATA'):
        print('skipped: LINK_BOUNDS_DATA is not set')
        return
    global URDF_BOUNDS
    URDF_BOUNDS = os.path.abspath(sys.argv.pop())
    unittest.main()


if __name__ == '__main__':
    main()
