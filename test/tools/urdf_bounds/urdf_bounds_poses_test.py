#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many poses from a table: urdf_bounds_poses_test.py URDF_BOUNDS"""
import json
import math
import os
import pathlib
import random
import signal
import subprocess
import time
from xml.etree import ElementTree

import urdf_bounds_testing
from bad_inputs import SANITIZED
from page_testing import PACKAGE
from patience import PATIENCE
from urdf_bounds_testing import ARM, UrdfBoundsTest, main, run

ROWS = 60 if SANITIZED else 300
DEMO = pathlib.Path(__file__).parents[3] / 'launch/demo/demo.urdf'
# A box that hangs in the air in front of a slide; the two touch where the slide is at 1.
SLIDE = '''<robot name="slide">
<link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="between"/>
<link name="block"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<joint name="push" type="prismatic"><parent link="base"/><child link="between"/>
  <origin xyz="3 0 0"/><axis xyz="-1 0 0"/>
  <limit lower="-1" upper="2.5" effort="1" velocity="1"/></joint>
<joint name="lift" type="prismatic"><parent link="between"/><child link="block"/>
  <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>'''


def demo_rows(count, seed=1, share=1.0):
    """The names of the demo's joints, and random rows of their values in that share of their
    ranges."""
    chance = random.Random(seed)
    joints = []
    for joint in ElementTree.parse(str(DEMO)).getroot().findall('joint'):
        limit = joint.find('limit')
        if joint.get('type') in ('revolute', 'prismatic') and joint.find('mimic') is None:
            joints.append((joint.get('name'), float(limit.get('lower')), float(limit.get('upper'))))
        elif joint.get('type') == 'continuous' and joint.find('mimic') is None:
            joints.append((joint.get('name'), -math.pi, math.pi))
    rows = [['%.17g' % (share * chance.uniform(lower, upper)) for _, lower, upper in joints]
            for _ in range(count)]
    return [name for name, _, _ in joints], rows


def csv(names, rows):
    return '\n'.join(','.join(row) for row in [names] + rows) + '\n'


class PosesTest(UrdfBoundsTest):
    def summary(self, table, *arguments, code=0, urdf=SLIDE):
        """The JSON of a table, and standard error."""
        path = self.write('table.csv', table)
        found, out, err = run('-', '--poses', path, '--format', 'json', *arguments, urdf=urdf)
        self.assertEqual(found, code, err)
        return json.loads(out), err

    def series(self, table, *arguments, urdf):
        """The lines after the first one, without their rows, by row."""
        path, series = self.write('table.csv', table), os.path.join(self.folder, 'series.csv')
        run(urdf, '--poses', path, '--series', series, *arguments)
        lines = pathlib.Path(series).read_text().splitlines()
        by_row = {}
        for line in lines[1:]:
            row, rest = line.split(',', 1)
            by_row.setdefault(int(row), []).append(rest)
        return lines[0], by_row

    def test_each_row_has_the_bits_of_a_run_of_its_own(self):
        names, rows = demo_rows(2 if SANITIZED else 6)
        for arguments in (['--distances', '0.2'], ['--distances', '0.2', '--geometry', 'both'], []):
            head, by_row = self.series(csv(names, rows), *arguments, urdf=str(DEMO))
            for number, row in enumerate(rows, 1):
                values = ['%s:=%s' % pair for pair in zip(names, row)]
                _, out, _ = run(str(DEMO), '--format', 'csv', *arguments, *values)
                alone = out.splitlines()
                self.assertEqual(head, 'row,' + alone[0])
                self.assertEqual(by_row.get(number, []), alone[1:], (arguments, number))

    def test_a_slow_motion_has_the_bits_of_single_rows_too(self):
        """Searches begin where those of the row before ended, which must not show."""
        names, ends = demo_rows(2, seed=5)
        rows = [['%.17g' % (float(a) + share / ROWS * (float(b) - float(a)))
                 for a, b in zip(*ends)] for share in range(ROWS)]
        _, by_row = self.series(csv(names, rows), '--distances', '0.2', '--jobs', '1',
                                urdf=str(DEMO))
        for number in (ROWS // 3, ROWS - 1):
            values = ['%s:=%s' % pair for pair in zip(names, rows[number - 1])]
            _, out, _ = run(str(DEMO), '--format', 'csv', '--distances', '0.2', *values)
            self.assertEqual(by_row.get(number, []), out.splitlines()[1:], number)

    def test_the_summary_is_that_of_the_series(self):
        names, rows = demo_rows(ROWS, share=1.3)  # within its limits the arm hardly collides
        table = csv(names, rows)
        path = self.write('table.csv', table)
        _, by_row = self.series(table, '--distances', '0.1', urdf=str(DEMO))
        nearest, contacts = {}, set()
        for number, lines in sorted(by_row.items()):
            for line in lines:
                first, second, distance = line.split(',')[:3]
                found = (float(distance), number)
                nearest[first, second] = min(nearest.get((first, second), found), found)
                if float(distance) == 0:
                    contacts.add(number)
        code, out, _ = run(str(DEMO), '--poses', path, '--distances', '0.1', '--format', 'json')
        summary = json.loads(out)
        self.assertTrue(contacts and len(nearest) > 3)
        self.assertEqual(code, 3)
        self.assertEqual({(pair['first'], pair['second']): (pair['distance'], pair['row'])
                          for pair in summary['pairs']}, nearest)
        self.assertEqual(summary['rows'], {
            'count': ROWS, 'left_out': 0, 'with_contact': len(contacts), 'first': min(contacts),
            'worst': min(nearest.values())[1]})

    def test_results_do_not_depend_on_the_number_of_jobs(self):
        names, rows = demo_rows(ROWS)
        path = self.write('table.csv', csv(names, rows))
        seen = set()
        for jobs in ('1', '7'):
            series = os.path.join(self.folder, jobs)
            for more in ([], ['--series', series]):
                _, out, err = run(str(DEMO), '--poses', path, '--distances', '0.1', '--jobs', jobs,
                                  '--format', 'json', *more)
                seen.add((out, err))
            seen.add(pathlib.Path(series).read_text())
        self.assertEqual(len(seen), 2)

    def test_contacts_are_counted(self):
        table = 'time,push,lift\n0,0,0\n0.5,1.5,0\n1,2,0\n1.5,2.25,0.5\n2,1.75,0\n'
        summary, err = self.summary(table, '--distances', '0.3', code=3)
        self.assertEqual(summary['rows'], {'count': 5, 'left_out': 0, 'with_contact': 2, 'first': 3,
                                           'worst': 3})
        pair, = summary['pairs']
        self.assertEqual((pair['first'], pair['second'], pair['distance'], pair['row'],
                          pair['contacts']), ('base', 'block', 0, 3, 2))
        self.assertEqual(err, '')
        summary, _ = self.summary('push,lift\n0,0\n1.75,0\n', '--distances', '0.3')
        self.assertEqual(summary['rows'],
                         {'count': 2, 'left_out': 0, 'with_contact': 0, 'first': None, 'worst': 2})
        code, out, _ = run('-', '--poses', self.write('t.csv', table), '--distances', '0.3',
                           urdf=SLIDE)
        self.assertEqual(code, 3)
        self.assertIn('rows: 5    with contact: 2    first: row 3 (1 s)    worst: row 3 (1 s)',
                      out.splitlines()[0])
        self.assertIn('in all rows', out)

    def test_rows_that_are_left_out_are_not_in_the_count(self):
        table = 'push,lift\n0,0\n0,nan\n2,0\nx,0\n1,0\n'
        for arguments, code in ((['--distances', '0.3'], 3), ([], 4)):
            summary, _ = self.summary(table, *arguments, code=code)
            self.assertEqual((summary['rows']['count'], summary['rows']['left_out']), (5, 2))
            _, out, _ = run('-', '--poses', self.write('t.csv', table), *arguments, urdf=SLIDE)
            self.assertIn('rows: 3 of 5', out.splitlines()[0])
            self.assertRegex(out, r'\nin 3 of 5 rows +min x')

    def interrupted(self, table, *arguments):
        """The exit code and what is printed where Ctrl-C comes after the first rows."""
        series = os.path.join(self.folder, 'series.csv')
        process = subprocess.Popen(
            [urdf_bounds_testing.URDF_BOUNDS, str(DEMO), '--poses', table, '--distances', '0.1',
             '--series', series, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            encoding='utf-8')
        try:
            while process.poll() is None and not (
                    os.path.exists(series) and os.path.getsize(series) > 1000):
                time.sleep(0.001)
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=60 * PATIENCE)
        finally:
            process.kill()
            process.communicate()
        os.remove(series)
        return process.returncode, out, err

    def test_rows_after_ctrl_c_are_not_in_the_count(self):
        names, rows = demo_rows(ROWS, share=1.3)
        count = ROWS * 100
        table = self.write('table.csv', csv(names, rows * 100))
        code, out, err = self.interrupted(table, '--format', 'json')
        found = json.loads(out)['rows']
        self.assertEqual((code, found['count'], (count - found['left_out']) % 1024), (3, count, 0))
        self.assertGreater(found['left_out'], 0)
        self.assertIn('rows after the interrupt: %d\n' % found['left_out'], err)
        code, out, _ = self.interrupted(table)
        self.assertEqual(code, 3)
        self.assertRegex(out.splitlines()[0], r'rows: \d+ of %d    with contact: ' % count)
        self.assertNotIn('in all rows', out)

    def test_an_interrupted_run_is_never_accepted(self):
        names, rows = demo_rows(ROWS, share=0)
        table = self.write('table.csv', csv(names, rows * 100))
        code, _, err = self.interrupted(table, '--allow-incomplete', '--format', 'csv')
        self.assertEqual(code, 4, err)
        self.assertIn('not everything was answered: rows after the interrupt: ', err)
        self.assertNotIn('--allow-incomplete accepts', err)

    def test_boxes_are_around_all_rows(self):
        summary, _ = self.summary('push,lift\n0,-0.5\n1,0.5\n')
        self.check_box(summary['boxes']['block'], (1.5, -0.5, -1), (3.5, 0.5, 1))
        self.check_box(summary['groups']['robot'], (-0.5, -0.5, -1), (3.5, 0.5, 1))
        self.assertEqual(summary['rows']['with_contact'], None)
        self.assertNotIn('pairs', summary)

    def test_columns_can_be_named_and_values_given_beside_them(self):
        summary, err = self.summary('# a comment\n1\n\n', '--columns', 'push', 'lift:=0.25')
        self.check_box(summary['boxes']['block'], (1.5, -0.5, -0.25), (2.5, 0.5, 0.75))
        self.assertEqual(err, '')

    def test_pages_have_the_first_line_of_csv(self):
        usage, page = run('--help')[1], PACKAGE.joinpath('doc/tools.md').read_text('utf-8')
        table = self.write('t.csv', 'push,lift\n0,0\n')
        for arguments in ([], ['--poses', table], ['--reach']):
            head = run('-', '--format', 'csv', *arguments, urdf=SLIDE)[1].split('\n', 1)[0]
            self.assertIn(head[:len('link,min_x,')], usage)
            self.assertIn('`' + head.split(',gap', 1)[0], page)

    def test_quoted_cells(self):
        """As csv has them where a name has commas or quotes; blanks may stand around them."""
        urdf = ARM.replace('"push"', '"pu,sh &quot;it&quot;"').replace('"turn"', '"turn "')
        names = '"turn ", "pu,sh ""it"""'
        table = self.write('t.csv', names + ' ,time\n0.5,"1" , "0"\n"0.25",2,1\n')
        expected = self.write('e.csv', '0.5,1\n0.25,2\n')
        found = run('-', '--poses', table, '--format=csv', urdf=urdf)
        self.assertEqual(found[0], 0)
        self.assertNotIn('warning', found[2])
        self.assertEqual(found, run('-', '--poses', expected, '--columns', names, '--format=csv',
                                    urdf=urdf))
        for row in '0,"1', '0,1"', '0,"1"2', '0,"1""', '0"0",1':
            found = run('-', '--poses', self.write('w.csv', 'turn,push\n1,1\n%s\n' % row))
            self.assertEqual(found[0], 4, row)
            self.assertIn('row 2 is left out: has quotes that are not around whole cells', found[2])
        self.check_refused('the line of names has quotes', '-', '--poses',
                           self.write('w.csv', 'turn,"push\n1,1\n'))

    def test_a_byte_order_mark_is_no_part_of_the_first_name(self):
        summary, err = self.summary('\ufeffpush\n1\n')
        self.check_box(summary['boxes']['block'], (1.5, -0.5, -0.5), (2.5, 0.5, 0.5))
        self.assertNotIn('no movable joint', err)

    def test_mimic_joints_follow(self):
        summary, err = self.summary('turn,push\n1.5707963267948966,0\n', urdf=ARM)
        alone = json.loads(run('-', '--format', 'json', 'turn:=1.5707963267948966')[1])
        self.assertEqual(summary['boxes'], alone['boxes'])
        self.assertEqual(err, 'urdf_bounds: note: left out are links with collision geometry only: '
                         '"slide"; --geometry both takes them, too\n')
        _, err = self.summary('turn,push,follow\n0,0,9\n', '--strict', urdf=ARM)
        self.assertIn('follow another one are ignored: "follow"', err)

    def test_a_free_base_has_columns(self):
        urdf = SLIDE.replace('type="prismatic"><parent link="base"/>',
                             'type="floating"><parent link="base"/>')
        summary, err = self.summary(
            'push.x,push.y,push.z,push.roll,push.pitch,push.yaw,lift\n0,0,2,0,0,0,0\n', urdf=urdf)
        self.check_box(summary['boxes']['block'], (2.5, -0.5, 1.5), (3.5, 0.5, 2.5))
        self.assertEqual(err, '')

    def check_fault(self, reason, table, code, *arguments):
        """A fault is named; --strict refuses it."""
        _, err = self.summary(table, *arguments, code=code)
        self.assertRegex(err, reason)
        self.check_refused(reason, '-', '--poses', self.write('t.csv', table), '--strict',
                           *arguments, urdf=SLIDE)

    def test_faults_are_named_and_strict_refuses_them(self):
        self.check_fault('joints without a column stay at 0: "lift"', 'push\n0\n', 0)
        high = SLIDE.replace('lower="-1" upper="1"', 'lower="0.5" upper="1"')
        self.assertIn('stay at 0: "lift" (beyond its limits 0.5 to 1);',
                      self.summary('push\n0\n', urdf=high)[1])
        self.check_fault('column "pull" is no movable joint .* push lift',
                         'push,lift,pull\n0,0,0\n', 0)
        self.check_fault('row 2 is left out: column "lift" is "nan".*line 3',
                         'push,lift\n0,0\n0,nan\n', 4)
        self.check_fault('row 1 is left out: has 1 cells instead of 2', 'push,lift\n0\n1,0\n', 4)
        self.check_fault('"push" is outside the limits -1 to 2.5 in 2 rows, first in row 2: 3',
                         'push,lift\n0,0\n3,0\n4,0\n', 0)
        self.check_fault('beyond the limits .*"lift" at 9 .limits -1 to 1', 'push\n0\n', 0,
                         'lift:=9')

    def test_long_cells_are_shown_in_part(self):
        long = 'x' * 10**5
        _, err = self.summary('push,lift,%s\n0,%s,1\n0,0,1\n' % (long, long), code=4)
        self.assertEqual(err.count('x' * 100 + '...'), 2)
        self.assertLess(len(err), 1000)

    def test_limits_of_joints_that_follow(self):
        urdf = SLIDE.replace('</robot>', """<link name="twin"/><joint name="twin" type="prismatic">
            <parent link="base"/><child link="twin"/><limit lower="-2" upper="2" effort="1"
            velocity="1"/><mimic joint="lift" multiplier="-2" offset="0.5"/></joint></robot>""")
        reason = 'joint "twin", which follows "lift", is outside the limits -2 to 2'
        for table, row, *arguments in (('push,lift\n0,0\n0,-0.75\n0,-0.8\n', 3),
                                       ('push\n0\n', 1, 'lift:=-0.8')):
            text = reason + ', first in row %d: 2.1' % row
            self.assertIn(text, self.summary(table, *arguments, urdf=urdf)[1])
            self.check_refused(text, '-', '--poses', self.write('t.csv', table), '--strict',
                               *arguments, urdf=urdf)

    def test_unusable_tables_are_refused(self):
        for reason, table in (
                ('column "push" is there twice', 'push,lift,push\n0,0,0\n'),
                ('is empty', ''),
                ('no row that can be used', 'push,lift\n'),
                ('no row that can be used: row 1 column "push" is "x"', 'push,lift\nx,0\n'),
                *((r't.csv has lines that end in CR alone; save it with LF', table) for table in (
                    'push,lift\r0,0\r', '# log\rpush,lift\r0,0', '# a\r# b', '\rpush,lift')),
                *(('no column of a joint; where it has no line of names, give them by --columns; '
                   'lines that begin with # are remarks; joints .*: push lift', table)
                  for table in ('a,b\n1,2\n', '0,0\n1,2\n', '#push,lift\n1,2\n'))):
            self.check_refused(reason, '-', '--poses', self.write('t.csv', table), urdf=SLIDE)
        for table in ('0,0\r', '0,0 \r\t', '\r\n0,0\r\n'):
            self.summary(table, '--columns', 'push,lift')
        table = self.write('t.csv', 'push,lift\n0,0\n')
        for reason, arguments in (
                ('both come from standard input', ['--poses', '-']),
                ('leave one out', ['--poses', table, 'push:=1']),
                ('--jobs is "0"', ['--poses', table, '--jobs', '0']),
                ('--columns is an option of --poses FILE', ['--columns', 'push']),
                ('--series is an option of --poses FILE', ['--series', 'x.csv']),
                ('give only one of the two', ['--poses', table, '--reach']),
                ('cannot write .*is its folder there',
                 ['--poses', table, '--series', self.folder + '/none/x.csv'])):
            self.check_refused(reason, '-', *arguments, urdf=SLIDE)

    def test_a_missing_mesh_is_incomplete(self):
        urdf = SLIDE.replace('<box size="1 1 1"/>', '<mesh filename="none.stl"/>', 1)
        summary, _ = self.summary('push,lift\n0,0\n', code=4, urdf=urdf)
        self.assertEqual(sorted(summary['incomplete']), ['base', 'group:robot'])
        self.summary('push,lift\n0,0\n', '--allow-incomplete', urdf=urdf)


if __name__ == '__main__':
    main()
