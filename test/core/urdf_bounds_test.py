#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of urdf_bounds: options, formats, joints, meshes, exit codes.

Run as: urdf_bounds_test.py PATH_OF_urdf_bounds
"""
import csv
import io
import json
import math
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import unittest

URDF_BOUNDS = ''
HEADER = ['link', 'a_x', 'a_y', 'a_z', 'b_x', 'b_y', 'b_z']

# A bar of 2 x 1 x 0.5 m that begins at its joint, which is 1 m above the base.
ARM = '''<robot name="arm">
<link name="base"><visual><geometry><box size="1 2 3"/></geometry></visual>
  <collision><geometry><sphere radius="2"/></geometry></collision></link>
<link name="bar"><visual><origin xyz="1 0 0"/><geometry><box size="2 1 0.5"/></geometry></visual>
</link>
<link name="slide"><collision><geometry><cylinder radius="0.5" length="4"/></geometry></collision>
</link>
<link name="follower"><visual><geometry><box size="2 1 1"/></geometry></visual></link>
<link name="bare"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="bar"/>
  <origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/>
</joint>
<joint name="push" type="prismatic"><parent link="base"/><child link="slide"/>
  <axis xyz="1 0 0"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
<joint name="follow" type="continuous"><parent link="base"/><child link="follower"/>
  <axis xyz="0 0 1"/><mimic joint="turn" multiplier="-2" offset="0.25"/></joint>
<joint name="still" type="fixed"><parent link="base"/><child link="bare"/></joint>
</robot>'''


def solid(name, extra=''):
    return '<link name="%s"><visual><geometry><box size="1 1 1"/></geometry></visual>%s</link>' % (
        name, extra)


def mesh(name, uri):
    return '<link name="%s"><visual><geometry><mesh filename="%s"/></geometry></visual></link>' % (
        name, uri)


def tree(*links):
    """A robot whose links all hang on the first one."""
    names = [re.search('name="(.*?)"', link, re.DOTALL).group(1) for link in links]
    joints = ['<joint name="j%d" type="fixed"><parent link="%s"/><child link="%s"/></joint>'
              % (i, names[0], name) for i, name in enumerate(names) if i > 0]
    return '<robot name="r">%s</robot>' % ''.join(list(links) + joints)


def tetrahedron():
    """A binary STL of the corners 0, x = 1, y = 2, z = 3."""
    corners = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    data = b'tetrahedron'.ljust(80) + struct.pack('<I', len(faces))
    for face in faces:
        data += struct.pack('<12f', 0, 0, 0, *(x for i in face for x in corners[i])) + b'\0\0'
    return data


def run(*arguments, urdf=ARM, **options):
    """Exit code, standard output and standard error; the robot comes by standard input."""
    text = urdf if isinstance(urdf, bytes) else urdf.encode('utf-8')
    options.setdefault('stdout', subprocess.PIPE)
    options.setdefault('stderr', subprocess.PIPE)
    done = subprocess.run([URDF_BOUNDS] + list(arguments), input=text, timeout=60, check=False,
                          **options)
    out, err = ((stream or b'').decode('utf-8') for stream in (done.stdout, done.stderr))
    return done.returncode, out, err


def boxes(*arguments, **options):
    """The parsed JSON of a run that must succeed without a word on standard error."""
    code, out, err = run('-', '--format', 'json', *arguments, **options)
    assert (code, err) == (0, ''), (code, err)
    return json.loads(out)


class UrdfBoundsTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'wb') as file:
            file.write(content if isinstance(content, bytes) else content.encode('utf-8'))
        return path

    def check_box(self, box, low, high):
        """Equal to rounding, and never smaller."""
        for found, exact in zip(box['min'], low):
            self.assertLessEqual(found, exact + 1e-15)
            self.assertAlmostEqual(found, exact, delta=1e-12)
        for found, exact in zip(box['max'], high):
            self.assertGreaterEqual(found, exact - 1e-15)
            self.assertAlmostEqual(found, exact, delta=1e-12)

    def check_refused(self, reason, *arguments, **options):
        code, out, err = run(*arguments, **options)
        self.assertEqual((code, out), (1, ''), arguments)
        self.assertRegex(err, '^urdf_bounds: error: .*' + reason)
        self.assertIn('--help', err)


class GeometryTest(UrdfBoundsTest):
    def test_zero_pose(self):
        found = boxes()
        self.assertEqual(found['frame'], 'base')
        self.assertEqual(list(found['boxes']), ['base', 'bar', 'follower'])
        self.check_box(found['boxes']['base'], [-.5, -1, -1.5], [.5, 1, 1.5])
        self.check_box(found['boxes']['bar'], [0, -.5, .75], [2, .5, 1.25])
        half = math.cos(.25) + math.sin(.25) / 2  # the follower is turned by its offset
        self.check_box(found['groups']['robot'], [-half, -1, -1.5], [2, 1, 1.5])
        self.assertEqual(found['incomplete'], {})

    def test_thirty_degrees(self):
        root3 = math.sqrt(3)
        bar = boxes('turn:=%.17g' % (math.pi / 6))['boxes']['bar']
        self.check_box(bar, [-1 / 4, -root3 / 4, .75], [root3 + 1 / 4, 1 + root3 / 4, 1.25])

    def test_forty_five_degrees(self):
        eighth = math.sqrt(2) / 4
        bar = boxes('turn:=%.17g' % (math.pi / 4))['boxes']['bar']
        self.check_box(bar, [-eighth, -eighth, .75], [5 * eighth, 5 * eighth, 1.25])

    def test_prismatic_joint_and_collision(self):
        found = boxes('push:=-.5', '--geometry=collision')
        self.assertEqual(list(found['boxes']), ['base', 'slide'])
        self.check_box(found['boxes']['base'], [-2, -2, -2], [2, 2, 2])
        self.check_box(found['boxes']['slide'], [-1, -.5, -2], [0, .5, 2])

    def test_both_kinds_of_geometry(self):
        found = boxes('--geometry', 'both')
        self.assertEqual(list(found['boxes']), ['base', 'bar', 'slide', 'follower'])
        self.check_box(found['boxes']['base'], [-2, -2, -2], [2, 2, 2])

    def test_mimic_joint_follows(self):
        angle = -2 * .3 + .25
        half = [math.cos(angle) + abs(math.sin(angle)) / 2,
                abs(math.sin(angle)) + math.cos(angle) / 2, .5]
        follower = boxes('turn:=0.3')['boxes']['follower']
        self.check_box(follower, [-x for x in half], half)

    def test_value_for_a_mimic_joint_is_ignored(self):
        code, out, err = run('-', 'turn:=0.3', 'follow:=1', '--format', 'json')
        self.assertEqual(code, 0)
        self.assertEqual(json.loads(out), boxes('turn:=0.3'))
        self.assertRegex(err, '^urdf_bounds: warning: .*"follow".*mimics joint "turn"')

    def test_numbers_as_people_write_them(self):
        for text in ('+0.5', '.5', '5e-1', '0.50'):
            self.assertEqual(boxes('turn:=' + text), boxes('turn:=0.5'))


class FormatTest(UrdfBoundsTest):
    def rows(self, *arguments, **options):
        code, out, err = run('-', '--format', 'csv', *arguments, **options)
        self.assertEqual((code, err), (0, ''))
        self.assertTrue(out.startswith('link,a_x,a_y,a_z,b_x,b_y,b_z\n'))
        return list(csv.reader(io.StringIO(out, newline='')))

    def test_csv_has_the_numbers_of_json(self):
        found = boxes('turn:=0.7')
        expected = dict(found['boxes'], **{'group:robot': found['groups']['robot']})
        rows = self.rows('turn:=0.7')
        self.assertEqual(rows[0], HEADER)
        self.assertEqual([row[0] for row in rows[1:]], ['base', 'bar', 'follower', 'group:robot'])
        for name, *numbers in rows[1:]:
            self.assertEqual([float(x) for x in numbers],
                             expected[name]['min'] + expected[name]['max'])

    def test_csv_representations_contain_the_box(self):
        exact = self.rows('turn:=0.7', '--representation=min-max')[1:]
        widths = self.rows('turn:=0.7', '--representation', 'min-width')[1:]
        radii = self.rows('turn:=0.7', '--representation', 'center-radius')[1:]
        for box, wide, round_ in zip(exact, widths, radii):
            for k in range(1, 4):
                low, high = float(box[k]), float(box[k + 3])
                self.assertEqual(wide[k], box[k])
                self.assertGreaterEqual(float(wide[k]) + float(wide[k + 3]), high)
                self.assertAlmostEqual(float(wide[k + 3]), high - low, delta=1e-15)
                self.assertLessEqual(float(round_[k]) - float(round_[k + 3]), low)
                self.assertGreaterEqual(float(round_[k]) + float(round_[k + 3]), high)
                self.assertAlmostEqual(float(round_[k]), (low + high) / 2, delta=1e-15)

    def test_seventeen_digits(self):
        texts = []
        code, out, _ = run('-', 'turn:=0.7', '--format=json')
        json.loads(out, parse_float=texts.append, parse_int=texts.append)
        texts += [x for row in self.rows('turn:=0.7')[1:] for x in row[1:]]
        self.assertEqual(code, 0)
        self.assertEqual(len(texts), 2 * 4 * 6)
        for text in texts:
            self.assertEqual(text, '%.17g' % float(text))

    def test_json_is_always_min_max_and_exact_in_shape(self):
        found = boxes()
        self.assertEqual(found, boxes('--representation=center-radius'))
        self.assertEqual(list(found), ['frame', 'boxes', 'groups', 'incomplete'])
        self.assertEqual(list(found['groups']), ['robot'])
        for box in list(found['boxes'].values()) + list(found['groups'].values()):
            self.assertEqual(list(box), ['min', 'max'])
            self.assertEqual([len(v) for v in box.values()], [3, 3])

    def test_awkward_names(self):
        awkward = ['a,b', 'say &quot;x&quot;', 'back\\slash', 'two&#10;lines', 'Gelenk ü 链']
        plain = ['base', 'a,b', 'say "x"', 'back\\slash', 'two\nlines', 'Gelenk ü 链']
        urdf = tree(*(solid(name) for name in ['base'] + awkward))
        self.assertEqual(list(boxes(urdf=urdf)['boxes']), plain)
        self.assertEqual([row[0] for row in self.rows(urdf=urdf)],
                         ['link'] + plain + ['group:robot'])
        code, out, _ = run('-', urdf=urdf)
        self.assertEqual(code, 0)
        self.assertIn('two lines', out)

    def test_bytes_that_are_not_utf8(self):
        surrogate_and_overlong = b'\xed\xa0\x80 \xe0\x80\xaf'
        urdf = tree(solid('base'), solid('XX')).encode('utf-8').replace(
            b'XX', b'a\xff\xe2(b' + surrogate_and_overlong + 'ü'.encode('utf-8'))
        name = 'a\ufffd\ufffd(b\ufffd\ufffd\ufffd \ufffd\ufffd\ufffdü'
        self.assertEqual(list(boxes(urdf=urdf)['boxes']), ['base', name])
        self.assertIn(name, run('-', urdf=urdf)[1])

    def test_table(self):
        code, out, err = run('-', '--representation', 'center-radius', 'turn:=0.7')
        self.assertEqual((code, err), (0, ''))
        lines = out.splitlines()
        self.assertRegex(lines[0], r'frame: base\s+unit: m\s+representation: center-radius')
        rows = [line for line in lines[1:] if line]
        self.assertEqual([row.split()[0] for row in rows],
                         ['link', 'base', 'bar', 'follower', 'group:robot'])
        self.assertEqual(len({len(row) for row in rows}), 1)
        self.assertEqual(rows[1].split()[1:],
                         ['0.000000'] * 3 + ['0.500000', '1.000000', '1.500000'])
        self.assertNotIn('incomplete', out)

    def test_default_is_the_table_of_min_max_of_visuals(self):
        self.assertEqual(run('-'), run('-', '--geometry=visual', '--format=table',
                                       '--representation=min-max'))

    def test_robot_without_geometry(self):
        found = boxes(urdf=tree('<link name="base"></link>'))
        self.assertEqual(found, {'frame': 'base', 'boxes': {}, 'groups': {}, 'incomplete': {}})
        self.assertEqual(self.rows(urdf=tree('<link name="base"></link>')), [HEADER])


class MeshTest(UrdfBoundsTest):
    def setUp(self):
        super().setUp()
        self.write('robot/meshes/t.stl', tetrahedron())
        self.urdf = tree(mesh('base', 'meshes/t.stl'), mesh('twin', 'meshes/t.stl'))
        self.file = self.write('robot/r.urdf', self.urdf)

    def check_tetrahedra(self, result):
        code, out, err = result
        self.assertEqual((code, err), (0, ''))
        for box in json.loads(out)['boxes'].values():
            self.check_box(box, [0, 0, 0], [1, 2, 3])

    def test_relative_to_the_folder_of_the_file(self):
        json_ = '--format=json'
        self.check_tetrahedra(run(self.file, json_, cwd='/'))
        self.check_tetrahedra(run('robot/r.urdf', json_, cwd=self.folder))
        self.check_tetrahedra(run('r.urdf', json_, cwd=os.path.dirname(self.file)))

    def test_relative_to_the_current_folder_for_standard_input(self):
        self.check_tetrahedra(run('-', '--format=json', urdf=self.urdf,
                                  cwd=os.path.dirname(self.file)))
        code, out, _ = run('-', '--format=json', urdf=self.urdf, cwd='/')
        self.assertEqual((code, json.loads(out)['boxes']), (0, {}))

    def test_packages(self):
        self.write('pack/package.xml', '<package format="2"><name>pack</name></package>')
        self.write('pack/t.stl', tetrahedron())
        missing = [mesh('m%d' % i, 'package://no_such_pack/t.stl') for i in range(3)]
        urdf = tree(mesh('base', 'package://pack/t.stl'), *missing)
        environment = {'PATH': os.environ['PATH'], 'HOME': self.folder,
                       'ROS_PACKAGE_PATH': self.folder}
        code, out, err = run('-', '--format=json', urdf=urdf, env=environment)
        self.assertEqual(code, 0)
        self.assertEqual(list(json.loads(out)['boxes']), ['base'])
        self.assertEqual(list(json.loads(out)['incomplete']), ['m0', 'm1', 'm2'])
        self.assertEqual(err.count('there is no package "no_such_pack"'), 3)
        self.assertLessEqual(err.count("[rospack] Error: package"), 1)  # looked up once

    def test_verbose_tells_the_memory_of_each_file_once(self):
        code, out, err = run(self.file, '--verbose', '--format=json')
        self.assertEqual((code, out), run(self.file, '--format=json')[:2])
        lines = err.splitlines()
        self.assertEqual(len(lines), 2)
        path = os.path.join(self.folder, 'robot/meshes/t.stl')
        bytes_ = re.fullmatch(r'urdf_bounds: (\d+) bytes, 4 vertices, ' + re.escape(path),
                              lines[0]).group(1)
        self.assertGreaterEqual(int(bytes_), 4 * 3 * 4)
        self.assertEqual(lines[1], 'urdf_bounds: %s bytes in 1 mesh files' % bytes_)

    def test_progress_bar_only_on_a_terminal_and_wiped_out(self):
        self.assertEqual(run(self.file)[2], '')
        master, slave = pty.openpty()
        with os.fdopen(master, 'rb', buffering=0) as terminal:
            self.assertEqual(run(self.file, stderr=slave)[0], 0)
            text = terminal.read(4096).decode('utf-8')
            os.close(slave)
        self.assertIn('1/1 meshes', text)
        self.assertTrue(text.endswith('\r\x1b[K'), repr(text))


class IncompleteTest(UrdfBoundsTest):
    missing = tree(solid('base'), mesh('gone', 'file:///no/such/file.stl'))
    partial = tree(solid('base', '<visual><geometry><mesh filename="file:///no/such/file.stl"/>'
                                 '</geometry></visual>'))

    def test_link_without_any_box(self):
        code, out, err = run('-', '--format=json', urdf=self.missing)
        found = json.loads(out)
        self.assertEqual(code, 0)
        self.assertEqual(list(found['boxes']), ['base'])
        self.assertEqual(list(found['incomplete']), ['gone'])
        self.assertIn('/no/such/file.stl', found['incomplete']['gone'])
        self.assertRegex(err, '^urdf_bounds: warning: link "gone", visual 1 .*no/such/file.stl')

    def test_link_with_a_box_of_a_part(self):
        found = json.loads(run('-', '--format=json', urdf=self.partial)[1])
        self.check_box(found['boxes']['base'], [-.5] * 3, [.5] * 3)
        self.assertEqual(list(found['groups']), ['robot'])
        self.assertEqual(list(found['incomplete']), ['base'])

    def test_only_a_lost_link(self):
        found = json.loads(run('-', '--format=json', urdf=tree(mesh('m', 'file:///no.stl')))[1])
        self.assertEqual((found['boxes'], found['groups']), ({}, {}))

    def test_a_mesh_that_cannot_be_read_adds_nothing_to_the_box(self):
        part = '<visual><origin xyz="9 9 9"/><geometry><mesh filename="%s"/></geometry></visual>'
        urdf = tree(solid('base', part % self.write('broken.stl', 'no mesh')))
        code, out, err = run('-', '--format=json', urdf=urdf)
        self.assertEqual(code, 0)
        self.check_box(json.loads(out)['boxes']['base'], [-.5] * 3, [.5] * 3)
        self.assertRegex(err, '^urdf_bounds: warning: link "base", visual 2 .*broken.stl')

    def test_table_gives_the_reason(self):
        out = run('-', urdf=self.missing)[1]
        self.assertRegex(out, r'\nincomplete:\n  gone: visual 1 .*no/such/file\.stl')

    def test_box_that_is_not_finite(self):
        far = '<origin xyz="1.5e308 0 0"/>'
        urdf = tree(solid('base'), '<link name="far"><visual>%s<geometry>'
                                   '<box size="1e308 1 1"/></geometry></visual></link>' % far)
        code, out, err = run('-', '--strict', '--format=json', urdf=urdf)
        self.assertEqual(code, 2)
        self.assertEqual(list(json.loads(out)['incomplete']), ['far'])
        self.assertIn('"far"', err)

    def test_strict(self):
        for urdf in (self.missing, self.partial):
            plain = run('-', '--format=csv', urdf=urdf)
            strict = run('-', '--format=csv', '--strict', urdf=urdf)
            self.assertEqual((plain[0], strict[0]), (0, 2))
            self.assertEqual(plain[1:], strict[1:])
        self.assertEqual(run('-', '--strict')[0], 0)

    def test_loss_in_geometry_that_was_not_asked_for(self):
        self.assertEqual(run('-', '--strict', '--geometry=collision', urdf=self.missing)[0], 0)


class RefusalTest(UrdfBoundsTest):
    def test_arguments(self):
        self.check_refused('no URDF file')
        self.check_refused('no URDF file', 'turn:=1')
        self.check_refused('empty', '')
        self.check_refused('one file too many', '-', 'other.urdf')
        self.check_refused('no option --bogus', '-', '--bogus')
        self.check_refused('no option -x', '-x', '-')
        self.check_refused('no option --volume', '-', '--volume', 'obb')
        self.check_refused('takes no value', '-', '--strict=1')

    def test_values_of_options(self):
        for option in ('--geometry', '--representation', '--format'):
            self.check_refused(option + ' needs a value', '-', option)
            self.check_refused(option + ' is "odd".* one of: ', '-', option, 'odd')
            self.check_refused(option + ' is "".* one of: ', '-', option + '=')

    def test_joints(self):
        self.check_refused('"elbow" is no movable joint.*turn push', '-', 'elbow:=1')
        self.check_refused('"still" is no movable joint', '-', 'still:=1')
        self.check_refused('"" is no movable joint', '-', ':=1')
        self.check_refused('"turn" is given twice', '-', 'turn:=1', 'push:=1', 'turn:=1')
        for text in ('', ' 1', '1 ', '1x', '1,5', '0x10', '1e', '--1', 'nan', 'inf', '-inf',
                     '1e999', 'one', '1:2'):
            self.check_refused('"turn" is "%s"' % re.escape(text), '-', 'turn:=' + text)

    def test_axis_of_zero_length(self):
        urdf = ARM.replace('<axis xyz="1 0 0"/>', '<axis xyz="0 0 0"/>')
        self.check_refused('"push"', '-', 'push:=1', urdf=urdf)

    def test_unreadable_files(self):
        self.check_refused('cannot read .*directory', self.folder)
        self.check_refused('cannot read .*No such file', os.path.join(self.folder, 'no.urdf'))
        self.check_refused('empty', self.write('empty.urdf', ''))
        self.check_refused('too large', '/dev/zero')

    def test_unusable_robots(self):
        self.check_refused('empty', '-', urdf=' \n')
        self.check_refused('', '-', urdf='no XML')
        self.check_refused('', '-', urdf='<robot name="r"/>')
        self.check_refused('two parents', '-', urdf=ARM.replace('</robot>', (
            '<joint name="again" type="fixed"><parent link="bare"/><child link="bar"/></joint>'
            '</robot>')))

    def test_broken_standard_output(self):
        with open('/dev/full', 'wb') as full:
            for arguments in (['-'], ['--help']):
                code, _, err = run(*arguments, stdout=full)
                self.assertEqual(code, 1)
                self.assertRegex(err, '^urdf_bounds: error: cannot write')

    def test_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        code, _, err = run('-', stdout=writer)
        os.close(writer)
        self.assertEqual(code, 1)
        self.assertIn('cannot write', err)


class OptionTest(UrdfBoundsTest):
    def test_help(self):
        for arguments in (['--help'], ['-h'], ['-', '--strict', '--help']):
            code, out, err = run(*arguments)
            self.assertEqual((code, err), (0, ''))
            for word in ('--geometry', '--representation', '--format', '--verbose', '--strict',
                         'joint:=value', 'center-radius', 'collision', 'json', 'group:'):
                self.assertIn(word, out)

    def test_arguments_mix_in_any_order(self):
        expected = run('-', '--format=csv', '--geometry=both', 'turn:=0.2', 'push:=1')
        self.assertEqual(expected[0], 0)
        self.assertEqual(expected, run('turn:=0.2', '--format', 'csv', '-', 'push:=1',
                                       '--geometry', 'both'))
        self.assertEqual(expected, run('--geometry=both', '--format=csv', '--', 'push:=1', '-',
                                       'turn:=0.2'))
        self.assertEqual(expected, run('turn:=0.2', '--format', 'csv', '-', 'push:=1',
                                       '--geometry=both', env={'POSIXLY_CORRECT': '1'}))

    def test_the_last_of_an_option_counts(self):
        self.assertEqual(run('-', '--format=csv', '--format=json'), run('-', '--format=json'))


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    URDF_BOUNDS = os.path.abspath(sys.argv.pop(1))
    unittest.main()
