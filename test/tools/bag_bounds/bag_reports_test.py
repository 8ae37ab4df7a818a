#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What bag_bounds prints: every format, and what doc/tools.md shows.

Run as: bag_reports_test.py PATH_OF_bag_bounds
"""
import csv
import io
import itertools
import json
import math
import os
import pty
import re
import signal
import subprocess

import bag_bounds_testing
from bag_bounds_testing import (BEGIN, COUNT, ENTERED, UNDERCUT, BagBoundsTest, arms, degrees_at,
                                main, moving_arms, run, seconds, time_of, zone_text)
from bounds_testing import wait_for
from emulation import catches, is_emulated
from node_testing import arm_bounds
from page_testing import PACKAGE, code_block, rows_below
from tf2_msgs.msg import TFMessage
from urdf_tf import UrdfTf

DEMO = PACKAGE / 'launch/demo/demo.urdf'
PAGE = 'doc/tools.md'


class FormatsTest(BagBoundsTest):
    def test_csv_has_the_numbers_of_json(self):
        bag = self.bag(arms(COUNT))
        zones = self.write('zones.yaml', zone_text('door', [0.6, 0.45, -1], [1, 1, 1]))
        arguments = ('--zones', zones, '--distances', '0.3')
        found = self.report(bag, *arguments, code=ENTERED)
        code, out, err = run(bag, '--urdf', self.urdf, '--format', 'csv', *arguments)
        self.assertEqual((code, err), (ENTERED, ''))
        rows = list(csv.reader(io.StringIO(out)))
        self.assertEqual(rows[0], ['kind', 'name', 'other', 'value', 'time', 'stamp'])

        def of_kind(kind):
            return [row[1:] for row in rows[1:] if row[0] == kind]
        for box, (k, axis), side in itertools.product(found['extremes'], enumerate('xyz'),
                                                      ('min', 'max')):
            row = next(r for r in of_kind('%s_%s' % (side, axis)) if r[0] == box['name'])
            self.assertEqual([float(x) for x in row[2:]],
                             [box[side][k], box[side + '_time'][k], box[side + '_stamp'][k]])
        zone = found['zones'][0]
        self.assertEqual([(r[0], float(r[3])) for r in of_kind('zone_entered')],
                         [(s['name'], s['entered']['time']) for s in zone['stays']])
        self.assertEqual(sum(len(of_kind('zone_' + how)) for how in ('left', 'report_ended')),
                         len(zone['stays']))
        self.assertEqual([float(r[2]) for r in of_kind('zone_nearest')],
                         [zone['nearest']['distance']])
        self.assertEqual([(r[0], r[1], float(r[2])) for r in of_kind('distance')],
                         [(p['first'], p['second'], p['distance']) for p in found['distances']])

    def test_series(self):
        """Each box when it changed, once; each distance within the limit."""
        path = self.path('series.csv')
        bag = self.bag(arms(10) + [moving_arms(210)])
        found = self.report(bag, '--distances', '0.3', '--series', path, code=UNDERCUT)
        with open(path, encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        boxes = [row for row in rows if not row['other']]
        self.assertEqual(len([row for row in boxes if row['name'] == 'mast']), 1)
        left = [row for row in boxes if row['name'] == 'left']
        self.assertEqual([float(row['time']) for row in left if row['min_x']],
                         [seconds(i) for i in [*range(10), 210]])
        self.assertEqual([row['min_x'] for row in left].index(''), 10)  # it was lost
        keys = ['%s_%s' % key for key in itertools.product(('min', 'max'), 'xyz')]
        for row, index in zip([row for row in left if row['min_x']], [*range(10), 210]):
            for key, expected in zip(keys, arm_bounds('left', degrees_at(index))):
                self.assertAlmostEqual(float(row[key]), expected, delta=1e-12)
        pair = next(p for p in found['distances'] if (p['first'], p['second']) == ('left', 'right'))
        self.assertEqual(min(float(row['distance']) for row in rows
                             if (row['name'], row['other']) == ('left', 'right')), pair['distance'])

    def test_table(self):
        code, out, err = run(self.bag(arms(3)), '--urdf', self.urdf)
        self.assertEqual((code, err), (0, ''))
        self.assertRegex(out, r'^frame: base    unit: m    times: s after 1000\.000000000, '
                         r'from 0\.000 to 0\.040\n')
        self.assertRegex(out, r'\nmast +x +-0\.106066 +0\.000 +0\.106066 +0\.000\n')

    def test_a_terminal_shows_how_far_it_came(self):
        """The bar is erased before the report."""
        master, terminal = pty.openpty()
        command = [bag_bounds_testing.BAG_BOUNDS, self.bag(arms(600)), '--urdf', self.urdf]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=terminal, timeout=60)
        os.close(terminal)
        with open(master, 'rb', buffering=0) as file:
            shown = file.read(1 << 16).decode('ascii')
        self.assertRegex(shown, r'\r\[#* *\] \d+/100 % of the bags')
        self.assertTrue(shown.endswith('\r\033[K'), repr(shown))

    def test_interrupt_reports_what_was_read(self):
        """The signal comes while the program waits for the robot."""
        command = [bag_bounds_testing.BAG_BOUNDS, self.bag(arms(50)), '--urdf', '-']
        process = subprocess.Popen(command + ['--format', 'json'], encoding='utf-8',
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        wait_for(lambda: catches(process.pid, signal.SIGINT), 'the program catches Ctrl-C')
        if is_emulated(process.pid):
            process.kill()
            process.communicate()
            self.skipTest('skipped: an emulator catches all signals before the program does')
        process.send_signal(signal.SIGINT)
        with open(self.urdf, encoding='utf-8') as file:
            out, err = process.communicate(file.read(), timeout=60)
        self.assertEqual(process.returncode, 4, err)
        self.assertRegex(err, 'interrupted 0.000 s after the begin, .* % of the bags were read')
        self.assertLess(json.loads(out)['messages'], 50)


class PageTest(BagBoundsTest):
    """The example and the tables of doc/tools.md."""

    def demo_bag(self, name='demo.bag', indices=range(600)):
        """The joints of the demo robot swing."""
        demo = UrdfTf(DEMO.read_text('utf-8'))
        messages = [('/tf_static', TFMessage(demo.static()), time_of(BEGIN + indices[0] / 100))]
        for index in indices:
            time = index / 100
            values = dict({name: 0 for name in demo.movable}, shoulder_pan=math.sin(time),
                          elbow_bend=1.9 + .5 * math.sin(2 * time),
                          shoulder_lift=.3 * math.sin(.7 * time))
            stamp = time_of(BEGIN + time)
            messages.append(('/tf', TFMessage(demo.moving(stamp, values)), stamp))
        return self.bag(messages, name)

    def test_the_example_prints_what_the_page_shows(self):
        self.write('zones.yaml', code_block(PAGE, '## bag_bounds', 'yaml'))
        command = code_block(PAGE, '## bag_bounds', 'sh').splitlines()[-1]
        arguments = command.split(' bag_bounds demo.bag ')[1].replace(
            'launch/demo/demo.urdf', str(DEMO)).split()
        code, out, err = run(self.demo_bag(), *arguments, cwd=self.folder)
        self.assertEqual((code, err), (ENTERED, ''))
        page = (PACKAGE / PAGE).read_text('utf-8')
        shown = re.search(r'^```\n(frame: base    unit: m    times.*?)^```$', page,
                          re.DOTALL | re.MULTILINE).group(1)
        begin, end = shown.split('...\n')
        self.assertTrue(out.startswith(begin), out)
        self.assertTrue(out.endswith(end), out)

    def test_the_example_of_many_bags_prints_what_the_page_shows(self):
        self.demo_bag('run_1.bag')
        self.demo_bag('run_2.bag', range(500, 520))
        cut = self.demo_bag('run_3.bag', range(500, 530))
        os.truncate(cut, os.path.getsize(cut) // 2)
        page = (PACKAGE / PAGE).read_text('utf-8').split('### Many bags')[1]
        for line in page.split('```sh\n')[1].split('```')[0].splitlines():
            line = line.replace('rosrun link_bounds bag_bounds', bag_bounds_testing.BAG_BOUNDS)
            done = subprocess.run(['sh', '-c', line.replace('robot.urdf', str(DEMO))],
                                  cwd=self.folder, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, encoding='utf-8')
            self.assertEqual(done.returncode, UNDERCUT, done.stderr)
        shown = page.split('```\n')[2].split('```')[0]
        self.assertEqual(re.sub(r'byte \d+', '', done.stdout), re.sub(r'byte \d+', '', shown))

    def test_help_names_all_options_of_the_page(self):
        code, out, _ = run('--help')
        self.assertEqual(code, 0)
        synopsis = (PACKAGE / PAGE).read_text('utf-8').split('## bag_bounds')[1].split('```')[1]
        for option in re.findall('--[a-z-]+', synopsis):
            self.assertIn('  ' + option if option != '--help' else ', --help', out)

    def test_keys_of_json_are_those_of_the_page(self):
        section = (PACKAGE / PAGE).read_text('utf-8').split('## bag_bounds')[1].split('\n## ')[0]
        rows = rows_below(section, ['key', 'value'])
        keys = [key for row in rows for key in row[0].split(', ')]
        found = self.report(self.bag(arms(3)), '--distances', '0.01')
        self.assertEqual(sorted(keys), sorted(found))

    def test_exit_codes_are_those_of_help(self):
        rows = rows_below((PACKAGE / PAGE).read_text('utf-8'), [
            'exit code', 'meaning; the first that applies', 'urdf_bounds', 'bag_bounds'])
        self.assertEqual([row[0] for row in rows], re.findall(r'^  (\d)  ', run('--help')[1], re.M))


if __name__ == '__main__':
    main()
