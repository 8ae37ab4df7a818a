#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/get_robots, from a repository made here; xacro is a stand-in. Needs git.

Run as: get_robots_test.py FOLDER_OF_THE_PACKAGE
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from page_testing import tables

PACKAGE = pathlib.Path()
COLUMNS = ['package', 'robot', 'repository', 'commit', 'folder in it', 'made by', 'licence']
LINK = '<link name="%s"><visual><geometry><mesh filename="%s"/></geometry></visual></link>'
ROBOT = '<robot name="arm">' + LINK % ('a', 'package://%s/meshes/a.stl') + '</robot>'
# Prints the file; the arguments and where $(find) looks follow as comments.
XACRO = '#!/bin/sh\ncat "$1" || exit; shift\necho "<!-- $* $ROS_PACKAGE_PATH -->"\n'
ACCESSORY = '<xacro:include filename="$(find lidar)/urdf/lidar.xacro"/>'
OWN = '<xacro:include filename="$(find arm)/urdf/own.xacro"/>'
POINTER = 'version https://git-lfs.github.com/spec/v1\n'


class GetRobotsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.repository, self.programs = self.root / 'repository', self.root / 'bin'
        self.robots = self.root / 'data' / 'robots'
        self.programs.mkdir()
        self.programs.joinpath('git').symlink_to(shutil.which('git'))
        self.git('init', '--quiet', self.repository)
        self.write('robots/arm/urdf/arm.urdf', ROBOT % 'models/robots/arm')
        self.write('robots/arm/urdf/other.urdf', ROBOT % 'arm')
        self.write('robots/arm/meshes/a.stl', 'old')
        self.write('robots/arm/meshes/LICENSE', 'of the meshes')
        self.write('LICENSE', 'of all')

    def git(self, *command):
        return subprocess.run(['git', '-c', 'user.name=n', '-c', 'user.email=e', *command],
                              check=True, stdout=subprocess.PIPE, encoding='utf-8').stdout.strip()

    def write(self, name, text):
        path = self.repository / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def commit(self):
        self.git('-C', self.repository, 'add', '-A')
        self.git('-C', self.repository, 'commit', '--quiet', '-m', 'm')
        return self.git('-C', self.repository, 'rev-parse', 'HEAD')

    def get(self, commit, path='robots/arm', links=1, xacro='-', repository=None):
        """Exit code and what it prints."""
        line = ['arm', 'BSD', repository or self.repository, commit, path, 'urdf/arm.urdf', links,
                xacro]
        self.root.joinpath('list').write_text('# comment\n\n%s\n' % ' '.join(map(str, line)))
        done = subprocess.run([sys.executable, PACKAGE / 'scripts/get_robots', self.root / 'data',
                               self.root / 'list'], env=dict(os.environ, PATH=str(self.programs)),
                              check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              encoding='utf-8')
        return done.returncode, done.stdout

    def put_xacro(self):
        self.programs.joinpath('xacro').write_text(XACRO.replace('cat', shutil.which('cat')))
        self.programs.joinpath('xacro').chmod(0o755)

    def check_missing(self, words, *arguments, **options):
        code, out = self.get(*arguments, **options)
        self.assertEqual(code, 1)
        self.assertRegex(out, '^arm: NOT THERE: .*%s.*\n$' % words)
        self.assertEqual(os.listdir(self.robots), [])

    def test_a_robot_of_an_older_commit(self):
        commit = self.commit()
        self.write('robots/arm/meshes/a.stl', 'new')
        self.commit()
        self.assertEqual(self.get(commit), (0, 'arm: got urdf/arm.urdf\n'))
        arm = self.robots / 'arm'
        self.assertEqual(sorted(str(path.relative_to(arm)) for path in arm.rglob('*.*')),
                         ['meshes/a.stl', 'package.xml', 'urdf/arm.urdf'])
        self.assertEqual((arm / 'meshes/a.stl').read_text(), 'old')
        self.assertEqual((arm / 'meshes/LICENSE').read_text(), 'of the meshes')
        self.assertEqual((arm / 'urdf/arm.urdf').read_text(), ROBOT % 'arm')
        self.assertIn('<name>arm</name>', (arm / 'package.xml').read_text())
        self.assertEqual(os.listdir(self.robots), ['arm'])

    def test_what_is_there_stays(self):
        self.robots.joinpath('arm').mkdir(parents=True)
        self.assertEqual(self.get('unknown'), (0, 'arm: is there already\n'))

    def test_the_licence_of_the_repository(self):
        self.repository.joinpath('robots/arm/meshes/LICENSE').unlink()
        self.get(self.commit())
        self.assertEqual((self.robots / 'arm/LICENSE').read_text(), 'of all')

    def test_xacro(self):
        self.put_xacro()
        self.write('robots/arm/package.xml', '<name>arm</name>')
        self.write('robots/arm/urdf/arm.xacro',
                   (ROBOT % 'arm').replace('<link', ACCESSORY + '<!--' + OWN + '--><link'))
        commit = self.commit()
        self.assertEqual(self.get(commit, xacro='urdf/arm.xacro hand:=true')[0], 0)
        text = (self.robots / 'arm/urdf/arm.urdf').read_text()
        self.assertNotIn('lidar', text)
        self.assertIn(OWN, text)
        self.assertRegex(text, '<!-- hand:=true %s/.*/clone -->' % self.robots)
        self.assertEqual((self.robots / 'arm/package.xml').read_text(), '<name>arm</name>')

    def test_xacro_fails(self):
        self.put_xacro()
        self.check_missing('xacro: .*No such file', self.commit(), xacro='urdf/none.xacro')

    def test_no_xacro(self):
        self.check_missing('program xacro', self.commit(), xacro='urdf/arm.xacro')

    def test_no_git(self):
        commit = self.commit()
        self.programs.joinpath('git').unlink()
        self.check_missing('program git', commit)

    def test_no_repository(self):
        self.check_missing('git: fatal: .*none', self.commit(), repository=self.root / 'none')

    def test_no_commit(self):
        self.commit()
        self.check_missing('git: ', '0' * 40)

    def test_no_folder(self):
        self.check_missing('no folder robots/leg', self.commit(), path='robots/leg')

    def test_another_robot(self):
        self.check_missing('1 links instead of 2', self.commit(), links=2)

    def test_a_mesh_that_is_not_there(self):
        for text in (POINTER, None):
            if text:
                self.write('robots/arm/meshes/a.stl', text)
            else:
                self.repository.joinpath('robots/arm/meshes/a.stl').unlink()
            self.check_missing('meshes/a.stl', self.commit())

    def test_the_soak_names_the_script_that_gets_its_robot(self):
        text = (PACKAGE / 'scripts/soak').read_text()
        text = text.replace('$(dirname "${BASH_SOURCE[0]}")', str(PACKAGE / 'scripts'))
        done = subprocess.run(['bash', '-c', text.replace('\nmain "$@"\n', '\nchoose_robot\n')],
                              env=dict(os.environ, LINK_BOUNDS_DATA=str(self.root)), check=False,
                              stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1)
        self.assertIn('scripts/get_robots gets it', done.stderr)

    def test_the_page_has_the_list(self):
        """Of each package the file of the robot, where it is from, and what makes it."""
        rows = []
        for line in (PACKAGE / 'scripts/robot_sources.txt').read_text('utf-8').splitlines():
            if not line.startswith('#'):
                name, license_name, repository, commit, path, urdf, _, *xacro = line.split()
                made = '' if xacro == ['-'] else ' '.join(['xacro', *xacro])
                rows.append([name, urdf, repository, commit, path, made, license_name])
        page = tables((PACKAGE / 'doc/robots.md').read_text('utf-8'))
        self.assertEqual(next(table[1:] for table in page if table[0] == COLUMNS), rows)


if __name__ == '__main__':
    PACKAGE = pathlib.Path(sys.argv.pop())
    if not shutil.which('git'):
        print('skipped: get_robots: git is missing')
        sys.exit(4)
    unittest.main()
