#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/get_robots gets what a table names, and says what it could not get; the table of
doc/measurements.md is that of the script.

Run as: get_robots_test.py
"""
import os
import pathlib
import subprocess
import tempfile
import unittest

from page_testing import PACKAGE

PAGE = 'doc/measurements.md'
URDF = ('<robot name="r"><link name="l"><visual><geometry>'
        '<mesh filename="package://of_a_repository/robots/two/ball.stl"/>'
        '</geometry></visual></link></robot>')
XACRO = '#!/bin/sh\ncat "$1"; echo "<!-- $2 in $ROS_PACKAGE_PATH -->"\n'


def git(folder, *arguments):
    names = ['-c', 'user.name=n', '-c', 'user.email=e@example.org']
    return subprocess.run(['git', *names, '-C', str(folder), *arguments], check=True,
                          stdout=subprocess.PIPE, universal_newlines=True).stdout.strip()


class GetRobotsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text, mode=0o644):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, 'utf-8')
        path.chmod(mode)
        return path

    def repository(self):
        """Where it is, and the commit before the last one."""
        for package in ('one', 'two'):
            self.write('source/robots/%s/package.xml' % package, '<package/>')
            self.write('source/robots/%s/a.urdf' % package, URDF)
        source = self.folder / 'source'
        git(source, 'init', '--quiet')
        git(source, 'config', 'uploadpack.allowAnySHA1InWant', 'true')
        git(source, 'add', '.')
        git(source, 'commit', '--quiet', '-m', 'first')
        commit = git(source, 'rev-parse', 'HEAD')
        self.write('source/robots/one/a.urdf', 'later')
        git(source, 'commit', '--quiet', '-a', '-m', 'second')
        return source, commit

    def get(self, *rows):
        """Exit code, and what is printed."""
        table = self.write('table.txt', '# a comment\n\n' + '\n'.join(rows) + '\n')
        environment = dict(os.environ, PATH='%s:%s' % (self.folder / 'bin', os.environ['PATH']))
        done = subprocess.run([str(PACKAGE / 'scripts/get_robots'), str(self.folder / 'data'),
                               str(table)], env=environment, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, universal_newlines=True)
        return done.returncode, done.stdout

    def test_packages_at_a_commit(self):
        source, commit = self.repository()
        self.write('bin/xacro', XACRO, 0o755)
        rows = ['%s file://%s %s robots/%s MIT %s' % (name, source, commit, name, rest)
                for name, rest in (('one', 'b/made.urdf a.urdf x:=1'), ('two', 'a.urdf -'))]
        code, text = self.get(*rows)
        self.assertEqual(code, 0, text)
        robots = self.folder / 'data/robots'
        self.assertIn('<!-- x:=1 in %s:' % robots, (robots / 'one/b/made.urdf').read_text())
        self.assertIn('"package://two/ball.stl"', (robots / 'two/a.urdf').read_text())
        self.assertEqual(sorted(path.name for path in robots.iterdir()), ['one', 'two'])
        self.assertIn('one: MIT, file://%s at %s\n' % (source, commit), text)
        code, text = self.get(*rows)
        self.assertEqual((code, text.count('is there')), (0, 2))

    def test_what_cannot_be_got(self):
        source, commit = self.repository()
        self.write('bin/xacro', '#!/bin/sh\necho "no package arms" >&2; exit 1\n', 0o755)
        code, text = self.get(
            'gone file:///no/such/repository %s . MIT a.urdf -' % commit,
            'old file://%s %s . MIT a.urdf -' % (source, 'f' * 40),
            'one file://%s %s robots/one MIT b.urdf a.urdf' % (source, commit),
            'two file://%s %s robots/two MIT a.urdf -' % (source, commit))
        self.assertEqual(code, 1)
        for name in ('gone', 'old', 'one'):
            self.assertIn('not got: %s: ' % name, text)
        self.assertIn('no package arms', text)
        self.assertIn('1 robots are in', text)
        self.assertEqual([path.name for path in (self.folder / 'data/robots').iterdir()], ['two'])

    def test_the_page_has_the_table(self):
        page = (PACKAGE / PAGE).read_text('utf-8')
        lines = (PACKAGE / 'scripts/robots.txt').read_text('utf-8').splitlines()
        rows = [line.split() for line in lines if line and not line.startswith('#')]
        self.assertGreater(len(rows), 5)
        for package, repository, commit, folder, licence, urdf, *_ in rows:
            self.assertIn('| `%s/%s` | %s | `%s` | `%s` | `%s` |\n' % (
                package, urdf, repository, commit[:10], folder, licence), page)


if __name__ == '__main__':
    unittest.main()
