#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How urdf_bounds treats meshes, missing geometry, bad arguments and options.

Run as: urdf_bounds_faults_test.py PATH_OF_urdf_bounds
"""
import json
import os
import pty
import re
import resource
import select
import shutil
import struct
import subprocess

import urdf_bounds_testing
from urdf_bounds_testing import (ARM, UrdfBoundsTest, main, mesh, run, solid, tetrahedron, tree)


BALLAST = 200 << 20  # bytes; urdf_bounds takes less, also with a sanitizer


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
        self.assertEqual(list(json.loads(out)['incomplete']), ['m0', 'm1', 'm2', 'group:robot'])
        self.assertEqual(err.count('there is no package "no_such_pack"'), 3)
        self.assertLessEqual(err.count("[rospack] Error: package"), 1)  # looked up once

    def test_a_broken_manifest_harms_no_other_package(self):
        self.write('pack/package.xml', '<package format="2"><name>pack</name></package>')
        self.write('pack/t.stl', tetrahedron())
        broken = self.write('other/package.xml', '<package><name>other')
        self.write('odd/package.xml', '<package><name/></package>')
        urdf = tree(mesh('base', 'package://pack/t.stl'), mesh('gone', 'package://other/t.stl'))
        code, out, err = run('-', '--format=json', urdf=urdf, env={
            'PATH': os.environ['PATH'], 'HOME': self.folder, 'ROS_PACKAGE_PATH': self.folder})
        self.assertEqual(code, 0, err)
        found = json.loads(out)
        self.assertEqual((list(found['boxes']), list(found['incomplete'])),
                         (['base'], ['gone', 'group:robot']))
        self.assertIn(broken, found['incomplete']['gone'])

    def test_verbose_tells_the_memory_of_each_file_once(self):
        ballast = b'.' * BALLAST
        code, out, err = run(self.file, '--verbose', '--format=json')
        self.assertEqual((code, out), run(self.file, '--format=json')[:2])
        lines = err.splitlines()
        self.assertEqual(len(lines), 3)
        path = os.path.join(self.folder, 'robot/meshes/t.stl')
        pattern = r'urdf_bounds: (\d+) bytes, 4 vertices that can be extreme, ' + re.escape(path)
        bytes_ = re.fullmatch(pattern, lines[0]).group(1)
        self.assertGreaterEqual(int(bytes_), 4 * 3 * 4)
        self.assertEqual(lines[1], 'urdf_bounds: %s bytes in 1 mesh files' % bytes_)
        peak = re.fullmatch(r'urdf_bounds: (\d+) kB of memory at the peak', lines[2]).group(1)
        self.assertLess(int(peak) * 1024, len(ballast), 'that of this process is not its own')

    def test_progress_bar_only_on_a_terminal_and_wiped_out(self):
        self.assertEqual(run(self.file)[2], '')
        master, slave = pty.openpty()
        with os.fdopen(master, 'rb', buffering=0) as terminal:
            self.assertEqual(run(self.file, stderr=slave)[0], 0)
            text = read_until(terminal, '\r\x1b[K')
            os.close(slave)
        self.assertIn('1/1 meshes', text)


def read_until(terminal, end):
    """What was written to a terminal, which comes in pieces; fails if it does not end with that."""
    text = ''
    while not text.endswith(end):
        if not select.select([terminal], [], [], 20)[0]:
            raise AssertionError('%r does not end with %r' % (text, end))
        text += terminal.read(4096).decode('utf-8')
    return text


class RemedyTest(UrdfBoundsTest):
    """The remedy depends on the cause, and names no parameter or service of the node."""

    def refusal(self, mesh_file, program=None):
        urdf = tree(mesh('base', 'file://' + mesh_file)).encode()
        done = subprocess.run([program or urdf_bounds_testing.URDF_BOUNDS, '-', '--format=json'],
                              input=urdf, stdout=subprocess.PIPE, timeout=60, check=True)
        reason = json.loads(done.stdout)['incomplete']['base']
        for word in ('mesh_timeout', 'max_mesh_bytes', 'reload'):
            self.assertNotIn(word, reason)
        return reason

    def refusal_by(self, commands):
        """The error of a copy of the program with a script in place of mesh_worker."""
        worker = self.write('bin/mesh_worker', '#!/bin/sh\n' + commands)
        os.chmod(worker, 0o755)
        program = shutil.copy(urdf_bounds_testing.URDF_BOUNDS, os.path.dirname(worker))
        return self.refusal(self.write('t.stl', tetrahedron()), program)

    def check(self, reason, cause, remedy):
        self.assertRegex(reason, cause + '.*; ' + remedy + '$')

    def test_a_broken_file(self):
        self.check(self.refusal(self.write('t.stl', 'no mesh')), 'assimp cannot read it',
                   'repair or replace the file')

    def test_a_file_above_the_limit(self):
        large = self.write('large.stl', '')
        os.truncate(large, 2**29 + 1)
        self.check(self.refusal(large), '536870913 bytes', 'simplify the mesh')

    def test_a_reader_that_takes_too_long(self):
        self.check(self.refusal_by('kill -XCPU $$'), 'longer than 30 s', 'simplify the mesh')

    def test_a_reader_that_is_killed(self):
        self.check(self.refusal_by('kill -KILL $$'), 'was killed',
                   'end some other programs and try again')

    def test_a_reader_that_does_not_start(self):
        for commands in ('exit 127', 'echo "This is some other program that has this name."'):
            self.check(self.refusal_by(commands), 'mesh reader', 'install link_bounds as a whole')

    def test_a_file_that_changes_while_it_is_read(self):
        self.check(self.refusal_by('echo >>"$1"; exec "%s" "$@"' % os.path.join(
            os.path.dirname(urdf_bounds_testing.URDF_BOUNDS), 'mesh_worker')),
                   'changed while it was read', 'try again when it is complete')


    def gltf(self, triangles, triangle):
        """A small file whose vertices are in a large one beside it; all but the last triangle are
        points at the origin, which take no disk."""
        size = triangles * len(triangle)
        with open(self.write('t.bin', ''), 'r+b') as buffer:
            buffer.truncate(size)
            buffer.seek(size - len(triangle))
            buffer.write(triangle)
        return self.write('t.gltf', json.dumps({
            'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
            'nodes': [{'mesh': 0}], 'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
            'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3 * triangles,
                           'type': 'VEC3', 'min': [0, 0, 0], 'max': [1, 2, 3]}],
            'bufferViews': [{'buffer': 0, 'byteLength': size}],
            'buffers': [{'byteLength': size, 'uri': 't.bin'}]}))

    triangle = struct.pack('<9f', 0, 0, 0, 1, 2, 0, 0, 0, 3)

    def test_a_large_file_beside_the_mesh_gives_the_reader_memory(self):
        if 'ASAN_OPTIONS' in os.environ or 'TSAN_OPTIONS' in os.environ:
            print('skipped: no limit of memory under a sanitizer')
            return
        gltf = self.gltf(4000000, self.triangle)
        code, out, err = run('-', '--format=json', urdf=tree(mesh('base', 'file://' + gltf)))
        self.assertEqual((code, err), (0, ''))
        self.check_box(json.loads(out)['boxes']['base'], [0, 0, 0], [1, 2, 3])

    def test_a_file_beside_the_mesh_above_the_limit(self):
        gltf = self.gltf(2**29 // 36 + 1, self.triangle)
        self.check(self.refusal(gltf), r't\.bin has 536870916 bytes', 'simplify the mesh')


class IncompleteTest(UrdfBoundsTest):
    missing = tree(solid('base'), mesh('gone', 'file:///no/such/file.stl'))
    partial = tree(solid('base', '<visual><geometry><mesh filename="file:///no/such/file.stl"/>'
                                 '</geometry></visual>'))

    def test_link_without_any_box(self):
        code, out, err = run('-', '--format=json', urdf=self.missing)
        found = json.loads(out)
        self.assertEqual(code, 0)
        self.assertEqual(list(found['boxes']), ['base'])
        self.assertEqual(list(found['incomplete']), ['gone', 'group:robot'])
        self.assertEqual(found['incomplete']['group:robot'], 'link "gone" is incomplete')
        self.assertIn('/no/such/file.stl', found['incomplete']['gone'])
        self.assertRegex(err, '^urdf_bounds: warning: link "gone", visual 1 .*no/such/file.stl')

    def test_link_with_a_box_of_a_part(self):
        found = json.loads(run('-', '--format=json', urdf=self.partial)[1])
        self.check_box(found['boxes']['base'], [-.5] * 3, [.5] * 3)
        self.assertEqual(list(found['groups']), ['robot'])
        self.assertEqual(list(found['incomplete']), ['base', 'group:robot'])

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
        self.assertRegex(out, r'\nincomplete:\n  gone: visual 1 .*no/such/file\.stl.*\n'
                              r'  group:robot: link "gone" is incomplete\n$')

    def test_csv_names_what_is_incomplete_in_rows_without_numbers(self):
        code, out, _ = run('-', '--format=csv', urdf=self.missing)
        self.assertEqual(code, 0)
        self.assertEqual([line.split(',')[0] for line in out.splitlines()],
                         ['link', 'base', 'group:robot', 'incomplete:gone',
                          'incomplete:group:robot'])
        self.assertEqual({line.count(',') for line in out.splitlines()}, {6})

    def test_box_that_is_not_finite(self):
        far = '<origin xyz="1.5e308 0 0"/>'
        urdf = tree(solid('base'), '<link name="far"><visual>%s<geometry>'
                                   '<box size="1e308 1 1"/></geometry></visual></link>' % far)
        code, out, err = run('-', '--strict', '--format=json', urdf=urdf)
        self.assertEqual(code, 2)
        self.assertEqual(list(json.loads(out)['incomplete']), ['far', 'group:robot'])
        self.assertIn('"far"', err)

    def test_strict(self):
        for urdf in (self.missing, self.partial):
            plain = run('-', '--format=csv', urdf=urdf)
            strict = run('-', '--format=csv', '--strict', urdf=urdf)
            self.assertEqual((plain[0], strict[0]), (0, 2))
            self.assertEqual(plain[1:], strict[1:])
        self.assertEqual(run('-', '--strict')[0], 0)

    def test_where_nothing_is_looked_at_nothing_holds(self):
        """A robot without geometry of that kind, one whose only pair is adjacent, and one link."""
        pair = tree(solid('base'), solid('tip'))
        srdf = self.write('pair.srdf', '<robot><disable_collisions link1="base" link2="tip" '
                          'reason="Never"/></robot>')
        modes = {'no pair was examined': (['--pairs'], ['--pairs', '--format', 'srdf'],
                                          ['--pairs', '--srdf', srdf]),
                 'no two links were compared': (['--distances', '1'],)}
        for reason, modes_of in modes.items():
            for mode in modes_of:
                for urdf in (pair, tree(solid('base'))):
                    if '--srdf' in mode and urdf is not pair:
                        continue
                    for geometry in ('visual', 'collision'):
                        arguments = ['-', '--geometry', geometry, *mode]
                        code, _, err = run(*arguments, urdf=urdf)
                        self.assertEqual(code, 4, arguments)
                        self.assertIn(reason, err)
                        self.assertEqual(run(*arguments, '--allow-incomplete', urdf=urdf)[0], 0)
        code, _, err = run('-', '--geometry', 'collision', '--reach', urdf=pair)
        self.assertEqual(code, 4)
        self.assertIn('no link has a box', err)
        self.assertEqual(run('-', '--geometry', 'collision', urdf=pair)[0], 0, 'boxes alone')
        moving = pair.replace('fixed', 'continuous')
        table = self.write('t.csv', 'j1\n0\n1\n')
        code, _, err = run('-', '--geometry', 'collision', '--poses', table, urdf=moving)
        self.assertEqual(code, 4)
        self.assertIn('no link has a box', err)

    def test_a_warning_of_the_urdf_leaves_verdicts_open(self):
        """What a macro that was not expanded stands for is not looked at."""
        whole = tree(solid('base'), solid('tip'), solid('end')).replace('fixed', 'continuous')
        urdf = whole.replace('<link', '<xacro:gripper name="g"/><link', 1).replace(
            '<robot', '<robot xmlns:xacro="http://ros.org/wiki/xacro"')
        table = self.write('t.csv', 'j1\n0\n1\n')
        for mode in (['--distances', '0.1'], ['--reach'], ['--pairs', '--adjacent'],
                     ['--poses', table, '--distances', '0'], ['--poses', table, '--path']):
            code, _, err = run('-', *mode, '--allow-incomplete', urdf=urdf)
            self.assertIn(code, (0, 3), mode)
            self.assertIn('xacro', err)
            code, _, err = run('-', *mode, urdf=urdf)
            self.assertIn(code, (3, 4), mode)
            if code == 4:
                self.assertIn('warnings of the URDF: 1', err)
        self.assertEqual(run('-', urdf=urdf)[0], 0, 'boxes alone')
        self.assertEqual(run('-', '--strict', urdf=urdf)[0], 2)

    def test_loss_in_geometry_that_was_not_asked_for(self):
        self.assertEqual(run('-', '--strict', '--geometry=collision', urdf=self.missing)[0], 0)


class RefusalTest(UrdfBoundsTest):
    def test_arguments(self):
        self.check_refused('no URDF file')
        self.check_refused('no URDF file', 'turn:=1')
        self.check_refused('empty', '')
        self.check_refused('one file too many', '-', 'other.urdf')
        self.check_refused('no option --bogus', '-', '--bogus')
        self.check_refused('no option -x; see', '-x', '-')
        self.check_refused('no option -x; write -- before joints whose name begins with -', '-x:=1',
                           '-')
        self.check_refused('takes no value', '-', '--strict=1')

    def test_standard_input_is_read_once(self):
        reason = ' cannot both come from standard input'
        self.check_refused('the URDF and --poses' + reason, '-', '--poses', '-')
        self.check_refused('the URDF and --srdf' + reason, '-', '--pairs', '--srdf', '-')
        self.check_refused('--poses and --objects' + reason,
                           'robot.urdf', '--path', '--poses', '-', '--objects', '-')

    def test_values_of_options(self):
        for option in ('--geometry', '--representation', '--format', '--volume'):
            self.check_refused(option + ' needs a value', '-', option)
            self.check_refused(option + ' is "odd".* one of: ', '-', option, 'odd')
            self.check_refused(option + ' is "".* one of: ', '-', option + '=')
        for option in '--poses', '--columns', '--objects', '--series', '--srdf', '--certificate':
            self.check_refused(option + ' is empty', '-', option, '')

    def test_joints(self):
        self.check_refused('"elbow" is no movable joint.*turn push', '-', 'elbow:=1')
        self.check_refused('"still" is no movable joint', '-', 'still:=1')
        self.check_refused('"" is no movable joint', '-', ':=1')
        self.check_refused('"turn" is given twice', '-', 'turn:=1', 'push:=1', 'turn:=1')
        for text in ('', ' 1', '1 ', '1x', '1,5', '0x10', '1e', '--1', 'nan', 'inf', '-inf',
                     '1e999', 'one', '1:2'):
            self.check_refused('"turn" is "%s"' % re.escape(text), '-', 'turn:=' + text)

    def test_joints_beyond_limits_are_warned_of_once(self):
        for values, texts in ((['turn:=3.5'], ['"turn" at 3.5 (limits -3 to 3)']),
                              (['push:=-3.25', 'turn:=4'], ['"push" at -3.25 (limits -3 to 3)',
                                                            '"turn" at 4 (limits -3 to 3)'])):
            code, out, err = run('-', *values, '--format', 'json')
            self.assertEqual((code, len(err.splitlines())), (0, 1), err)
            self.assertRegex(err, '^urdf_bounds: warning: ')
            for text in texts:
                self.assertIn(text, err)
            self.assertIn('bar', json.loads(out)['boxes'])
        without_limits = ARM.replace('revolute', 'continuous')
        for urdf, value in ((ARM, '3'), (ARM, '-3'), (without_limits, '9')):
            self.assertEqual(run('-', 'turn:=' + value, urdf=urdf)[::2], (0, ''))

    def test_axis_of_zero_length(self):
        urdf = ARM.replace('<axis xyz="1 0 0"/>', '<axis xyz="0 0 0"/>')
        self.check_refused('standard input: joint "push" .*zero; correct its <axis>', '-', 'push:=1',
                           urdf=urdf)

    def test_joints_that_mimic_nothing(self):
        for leader, words in (('none', 'is no joint of the robot; correct its <mimic>'),
                              ('push', 'in a circle; correct a <mimic>')):
            urdf = ARM.replace('<axis xyz="1 0 0"/>', '<axis xyz="1 0 0"/><mimic joint="%s"/>' % leader)
            for mode in (), ('--reach',), ('--pairs',):
                self.check_refused('arm.urdf: joint "push" mimics .*' + words,
                                   self.write('arm.urdf', urdf), *mode)

    def test_unreadable_files(self):
        self.check_refused('cannot read .*directory', self.folder)
        self.check_refused('cannot read .*No such file', os.path.join(self.folder, 'no.urdf'))
        self.check_refused('empty.urdf: .*empty', self.write('empty.urdf', ''))
        self.check_refused('/dev/null: .*empty', '/dev/null')
        self.check_refused('standard input: .*empty', '-', urdf='')
        for code in 'utf-16', 'utf-16-be', 'utf-16-le':
            self.check_refused('u.urdf is UTF-16; save it as UTF-8',
                               self.write('u.urdf', ARM.encode(code)))
            self.check_refused('u.csv is UTF-16; save it as UTF-8', '-', '--poses',
                               self.write('u.csv', 'turn,push\n0,0\n'.encode(code)))
        self.check_refused('too large', '/dev/zero')

    def test_unusable_robots(self):
        self.check_refused('empty', '-', urdf=' \n')
        self.check_refused('', '-', urdf='no XML')
        self.check_refused('', '-', urdf='<robot name="r"/>')
        self.check_refused('two parents', '-', urdf=ARM.replace('</robot>', (
            '<joint name="again" type="fixed"><parent link="bare"/><child link="bar"/></joint>'
            '</robot>')))

    def test_inputs_are_not_overwritten(self):
        urdf = self.write('r.urdf', '<robot name="r"><link name="a"/></robot>')
        table = self.write('t.csv', 'joint\n0\n')
        linked = os.path.join(self.folder, 'link.csv')
        os.symlink(table, linked)
        for option, file, *others in (('--series', table, '--poses', table),
                                      ('--series', linked, '--poses', table),
                                      ('--series', urdf, '--poses', table),
                                      ('--certificate', urdf, '--pairs'),
                                      ('--certificate', urdf, '--reach')):
            with self.subTest(option=option, file=file):
                with open(file, encoding='utf-8') as opened:
                    before = opened.read()
                self.check_refused(option + ' is .*, which is read', urdf, *others, option, file)
                with open(file, encoding='utf-8') as opened:
                    self.assertEqual(opened.read(), before)

    def test_meshes_are_not_overwritten(self):
        part = self.write('part.stl', tetrahedron())
        robot_mesh, broken = self.write('t.stl', tetrahedron()), self.write('broken.stl', 'none')
        urdf = self.write('r.urdf', tree(solid('a'), mesh('b', 't.stl'), mesh('c', 'broken.stl'))
                          .replace('fixed', 'continuous'))
        table = self.write('t.csv', 'j1\n0\n1\n')
        objects = self.write('o.yaml', 'o: {type: MESH_RESOURCE, mesh_resource: part.stl}')
        path = ('--poses', table, '--path', '--objects', objects)
        for file, option, *others in ((robot_mesh, '--series', '--poses', table),
                                      (robot_mesh, '--certificate', '--reach'),
                                      (broken, '--certificate', '--pairs'),
                                      (robot_mesh, '--certificate', *path),
                                      (part, '--certificate', *path),
                                      (table, '--certificate', *path),
                                      (objects, '--certificate', *path)):
            with self.subTest(option=option, file=file):
                with open(file, 'rb') as opened:
                    before = opened.read()
                code, _, err = run(urdf, *others, option, file)
                self.assertEqual(code, 1)
                self.assertIn('error: %s is %s, which is read' % (option, file), err)
                with open(file, 'rb') as opened:
                    self.assertEqual(opened.read(), before)

    def test_broken_standard_output(self):
        with open('/dev/full', 'wb') as full:
            for arguments in (['-'], ['--help']):
                code, _, err = run(*arguments, stdout=full)
                self.assertEqual(code, 1)
                self.assertRegex(err, '^urdf_bounds: error: cannot write')

    def test_a_limit_of_the_size_of_files(self):
        urdf, file = self.write('r.urdf', ARM), os.path.join(self.folder, 'r.cert')
        limit = (resource.RLIMIT_FSIZE, (0, 0))
        code, _, err = run(urdf, '--reach', '--certificate', file,
                           preexec_fn=lambda: resource.setrlimit(*limit))
        self.assertEqual(code, 1)
        self.assertRegex(err, 'urdf_bounds: error: .*r.cert')

    def test_warnings_get_into_no_file_where_standard_error_is_closed(self):
        urdf = self.write('r.urdf', ARM.replace('type="prismatic"', 'type="floating"'))
        file = os.path.join(self.folder, 'r.cert')
        arguments = (urdf, '--geometry', 'both', '--reach', '--certificate', file)
        code, _, err = run(*arguments)
        self.assertIn('warning: link "slide"', err)
        with open(file, encoding='utf-8') as lines:
            expected = lines.read()
        self.assertEqual(run(*arguments, stderr=None, preexec_fn=lambda: os.close(2))[0], code)
        with open(file, encoding='utf-8') as lines:
            self.assertEqual(re.sub(r'"seconds": [^,}]*', '', lines.read()),
                             re.sub(r'"seconds": [^,}]*', '', expected))

    def test_certificates_that_cannot_be_written(self):
        for file, reason in (('/dev/full', 'No space left on device'),
                             (self.folder + '/none/c', 'No such file or directory')):
            self.check_refused('cannot write %s: %s' % (file, reason), '-', '--reach',
                               '--certificate', file)

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

    def test_an_option_with_a_value_is_given_once(self):
        for option, value in (('--format', 'csv'), ('--geometry', 'both'), ('--accuracy', '1'),
                              ('--poses', 'a'), ('--objects', 'a'), ('--series', 'a'),
                              ('--srdf', 'a'), ('--certificate', 'a'), ('--distances', '1')):
            self.check_refused(option + ' is given twice; give it once', '-', option, value, option,
                               value)
        self.assertEqual(run('-', '--verbose', '--strict', '--strict')[0], 0)


if __name__ == '__main__':
    main()
