#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_bounds --each, --resume and --merge: the same lines with any number of jobs, in any order,
after a kill, and one report of them.

Run as: each_bag_test.py PATH_OF_bag_bounds
"""
import collections
import csv
import io
import json
import os
import pathlib
import pty
import random
import re
import signal
import struct
import subprocess
import time

import bag_bounds_testing
from bag_interrupts_test import bomb
from bag_bounds_testing import (BEGIN, ENTERED, INCOMPLETE, BagBoundsTest, arms, main, moving_arms, raw,
                                run, static_arms, time_of, write_bag, zone_text)
from bounds_testing import wait_for
from node_testing import ARMS, arm_transform
from object_testing import marker
from patience import PATIENCE
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

BAGS = 50
PROMPT = 1.0 * PATIENCE  # s
DEADLINE = 60 * PATIENCE  # s
LIMIT = 0.25  # m; the arms come to 0.19 of each other, see calm()
LONG = 60  # MB of what nobody reads


def calm(count):
    """Around the middle of their way the arms are far from each other, and from the zones."""
    return [static_arms()] + [moving_arms(i, angle_index=45 + i) for i in range(count)]


def arms_with_mesh(name):
    """The arms, where the mast has the shape of a mesh file."""
    return re.sub(r'(<link name="mast">.*?<geometry>).*?(</geometry>)',
                  r'\1<mesh filename="%s"/>\2' % name, ARMS, count=1, flags=re.DOTALL)


def of_another_robot():
    transform = arm_transform('mast', time_of(1000), 0)
    transform.header.frame_id, transform.child_frame_id = 'hull', 'rudder'
    return [('/tf', TFMessage([transform]), time_of(1000 + i)) for i in range(3)]


class EachBagTest(BagBoundsTest):
    def setUp(self):
        super().setUp()
        self.zones = self.write('zones.yaml', zone_text('far', [8] * 3, [9] * 3) +
                                zone_text('front', [0.73, 0.43, -1], [1, 0.5, 1]))

    def some_bags(self):
        """Of arms in different parts of their way; every 7th is cut, every 11th of another robot."""
        bags = []
        for number in range(BAGS):
            messages = [static_arms()] + [moving_arms(i, angle_index=i + 4 * number)
                                          for i in range(20)]
            if number % 11 == 5:
                messages = of_another_robot()
            bags.append(self.bag(messages, 'run_%02d.bag' % number))
            if number % 7 == 3:
                os.truncate(bags[-1], os.path.getsize(bags[-1]) * (number % 2 + 1) // 3)
        os.truncate(bags[-1], 40)
        return bags

    def long_bag(self, name='long.bag'):
        """Takes a while: a byte a message would be skipped, a compressed chunk is not."""
        junk = raw(String('0' * 1000000))
        with bag_bounds_testing.rosbag.Bag(self.path(name), 'w', compression='bz2') as bag:
            for topic, message, stamp in calm(5):
                bag.write(topic, message, stamp)
            for number in range(LONG):
                bag.write('/junk', junk, time_of(1000 + number / LONG), raw=True)
        return self.path(name)

    def endless_bag(self):
        """Takes minutes."""
        path = self.bag(calm(3), 'endless.bag')
        with open(path, 'ab') as file:
            file.write(bomb(50 << 20))
        return path

    def arguments(self, bags, *arguments):
        return [*bags, '--each', '--urdf', self.urdf, '--zones', self.zones, '--distances',
                str(LIMIT), *arguments]

    def lines(self, bags, *arguments, code):
        found = run(*self.arguments(bags, *arguments))
        self.assertEqual(found[0], code, found)
        return found[1].splitlines()

    def merged(self, *arguments, code):
        found = run('--merge', *arguments)
        self.assertEqual(found[0], code, found)
        return found[1], found[2]

    def check_refused_each(self, reason, *arguments):
        self.check_refused(reason, *self.arguments(arguments))


class LinesTest(EachBagTest):
    def test_the_same_lines_whatever_the_jobs_and_the_order(self):
        bags = self.some_bags()
        expected = sorted(self.lines(bags, '--jobs', '1', code=1))
        shuffled = random.Random(1).sample(bags, len(bags))
        self.assertEqual(sorted(self.lines(shuffled, '--jobs', '2', code=1)), expected)
        self.assertEqual(sorted(self.lines(bags[::-1], '--jobs', '4', code=1)), expected)
        lines = [json.loads(line) for line in expected]
        self.assertEqual([line['bag'] for line in lines], bags)
        verdicts = collections.Counter(line['verdict'] for line in lines)
        self.assertEqual(set(verdicts), {'CLEAR', 'FOUND', 'INCOMPLETE', 'UNUSABLE'}, verdicts)
        self.check_kill(bags, expected)

    def check_kill(self, bags, expected):
        """kill -9 after some lines, a line that is cut, and --resume."""
        path = self.path('lines.jsonl')
        with open(path, 'wb') as out:
            process = subprocess.Popen([bag_bounds_testing.BAG_BOUNDS,
                                        *self.arguments(bags, '--jobs', '2')], stdout=out)
        try:
            wait_for(lambda: os.path.getsize(path) > 2000, 'some lines', DEADLINE)
        finally:
            process.kill()
            process.wait()
        with open(path, encoding='utf-8') as file:
            text = file.read()
        whole = text[:text.rindex('\n') + 1].splitlines()
        self.assertLess(len(whole), BAGS)
        self.assertLessEqual(set(whole), set(expected))
        cut = '\n'.join(whole)[:-len(whole[-1]) // 2]
        with open(path, 'w', encoding='utf-8') as file:
            file.write(cut)
        with open(path, 'ab') as out:
            done = subprocess.run([bag_bounds_testing.BAG_BOUNDS,
                                   *self.arguments(bags, '--resume', path)], stdout=out,
                                  stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn('line %d was cut; its bag is read again' % len(whole), done.stderr)
        self.assertIn('%d of %d bags have a line already' % (len(whole) - 1, BAGS), done.stderr)
        report, err = self.merged(path, '--format', 'json', code=1)
        self.assertEqual(err, '')
        found = json.loads(report)
        self.assertEqual(found['bags'], [json.loads(line) for line in expected])

    def test_a_line_says_what_the_report_says(self):
        bag = self.bag(arms(100))
        line = json.loads(self.lines([bag], code=ENTERED)[0])
        report = self.report(bag, '--zones', self.zones, '--distances', str(LIMIT), code=ENTERED)
        self.assertEqual((line['bag'], line['size'], line['exit'], line['verdict']),
                         (bag, os.path.getsize(bag), ENTERED, 'FOUND'))
        for key in ('frame', 'begin', 'from', 'to', 'messages', 'incomplete', 'losses'):
            self.assertEqual(line[key], report[key], key)
        self.assertEqual(line['pairs'], len(report['distances']))
        self.assertEqual(line['worst'], min(
            report['distances'], key=lambda d: (d['clearance'], d['distance'])))
        self.assertEqual(line['coverage']['share'],
                         min(box['coverage'] for box in report['extremes']))
        for found, expected in zip(line['zones'], report['zones']):
            first = expected['stays'][0] if expected['stays'] else None
            self.assertEqual(found, {
                **{key: expected[key]
                   for key in ('name', 'nearest', 'clearance', 'coverage', 'undecided', 'entries')},
                'first': first and dict(first['entered'], name=first['name'])})
        self.assertEqual([zone['entries'] > 0 for zone in line['zones']], [False, True])

    def test_bags_that_cannot_be_read(self):
        bags = [self.path('none.bag'), self.write('text.bag', 'text'), self.folder,
                self.bag(calm(3))]
        lines = {json.loads(line)['bag']: json.loads(line) for line in self.lines(bags, code=1)}
        self.assertEqual(set(lines), set(bags))
        for bag, reason in zip(bags, ('No such file', 'is not a bag', 'ordinary file|irectory')):
            self.assertRegex(lines[bag]['reason'], reason)
            self.assertEqual(lines[bag]['verdict'], 'UNUSABLE')
        self.assertEqual(lines[bags[3]]['verdict'], 'CLEAR')

    def test_refused(self):
        bag = self.bag(calm(3))
        os.symlink(bag, self.path('linked.bag'))
        for again in bag, os.path.relpath(bag), self.path('linked.bag'):
            self.check_refused_each('is given twice', bag, again)
        self.check_refused_each('none.bag: is given twice', 'none.bag', 'none.bag')
        self.check_refused_each('--each has no --out', bag, '--out', 'a.bag')
        self.check_refused_each('--each has no --format', bag, '--format', 'csv')
        self.check_refused_each('--each has no --at', bag, '--at', '1')
        self.check_refused_each('cannot read .*none.jsonl', bag, '--resume', self.path('none.jsonl'))
        self.check_refused_each('arms.urdf, line 1 is no line of bag_bounds --each', bag, '--resume',
                                self.urdf)
        self.check_refused('--resume needs --each', bag, '--urdf', self.urdf, '--resume', bag)
        self.check_refused('--urdf does not fit --merge', bag, '--merge', '--urdf', self.urdf)
        self.check_refused('there is no line to merge', '--merge', self.write('empty.jsonl', ''))

    def test_names_that_are_not_utf8(self):
        """They would be one name in the lines."""
        bag = self.bag(arms(3))
        for number in b'\xfe', b'\xff':
            os.link(bag, os.fsencode(self.path('run_')) + number + b'.bag')
        for name in sorted(os.listdir(os.fsencode(self.folder))):
            if name.startswith(b'run_'):
                self.check_refused_each('the name is not UTF-8.*; rename the bag', bag,
                                        os.path.join(self.folder, os.fsdecode(name)))

    def test_standard_output_that_replaces_the_lines(self):
        bag, path = self.bag(calm(3)), self.write('lines.jsonl', '')
        with open(path, 'r+', encoding='utf-8') as out:
            done = subprocess.run([bag_bounds_testing.BAG_BOUNDS,
                                   *self.arguments([bag], '--resume', path)], stdout=out,
                                  stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1)
        self.assertIn('append to it with >>', done.stderr)


class ResumeTest(EachBagTest):
    def test_only_what_is_unchanged_is_left_out(self):
        bags = [self.bag(calm(3 + i), 'bag_%d.bag' % i) for i in range(3)]
        lines = self.lines(bags, code=0)
        path = self.write('lines.jsonl', ''.join(line + '\n' for line in lines))
        again = ('--resume', path)
        self.assertEqual(self.lines(bags, *again, code=0), [])
        self.bag(calm(9), 'bag_1.bag')
        found = self.lines(bags, *again, code=0)
        self.assertEqual([json.loads(line)['bag'] for line in found], [bags[1]])
        self.assertEqual(len(self.lines(bags, *again, '--padding', '0.001', code=0)), 3)
        with open(self.urdf, 'a', encoding='utf-8') as file:
            file.write('<!-- -->')
        self.assertEqual(len(self.lines(bags, *again, code=0)), 3)

    def test_a_file_that_a_mesh_names(self):
        """What was loaded counts, not only the file that the URDF names."""
        corners = [(0, 0, 0), (.1, 0, 0), (0, .1, 0), (0, 0, .1), (.02, .02, .02)]
        self.write('m.gltf', json.dumps({
            'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
            'nodes': [{'mesh': 0}], 'buffers': [{'uri': 'm.bin', 'byteLength': 96}],
            'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
            'bufferViews': [{'buffer': 0, 'byteOffset': 0, 'byteLength': 60},
                            {'buffer': 0, 'byteOffset': 60, 'byteLength': 30}],
            'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 5, 'type': 'VEC3',
                           'min': [0, 0, 0], 'max': [.3, .3, .3]},
                          {'bufferView': 1, 'componentType': 5123, 'count': 15, 'type': 'SCALAR'}]}))

        def write_buffer(points):
            numbers = [number for point in points for number in point]
            with open(self.path('m.bin'), 'wb') as file:
                file.write(struct.pack('<15f18H', *numbers, 0, 1, 2, 0, 2, 3, 0, 1, 3, 1, 2, 3, 0, 1,
                                       4, 0, 0, 0))

        write_buffer(corners)
        self.urdf = self.write('mesh.urdf', arms_with_mesh('m.gltf'))
        bags = [self.bag(calm(3))]
        inner, outer = corners[:4] + [(.03, .02, .02)], [(-.1, 0, 0)] + corners[1:]
        for changed, arguments in (outer, ()), (inner, ('--distances', str(LIMIT))):
            with self.subTest(changed=changed):
                arguments = (*bags, '--each', '--urdf', self.urdf, *arguments)
                write_buffer(corners)
                again = (*arguments, '--resume', self.write('lines.jsonl', run(*arguments)[1]))
                self.assertEqual(run(*again)[1], '')
                write_buffer(changed)
                self.assertNotEqual(run(*again)[1], '')

    def test_the_exit_code_counts_lines_that_are_there(self):
        bags = [self.bag(arms(100), 'a.bag'), self.bag(calm(3), 'b.bag')]
        path = self.write('lines.jsonl', self.lines(bags[:1], code=ENTERED)[0] + '\n')
        self.assertEqual(len(self.lines(bags, '--resume', path, code=ENTERED)), 1)

    def test_a_process_that_dies_is_tried_again(self):
        """Another program kills the process that reads a bag."""
        bags = [self.long_bag(), self.bag(calm(3), 'short.bag')]
        process = subprocess.Popen([bag_bounds_testing.BAG_BOUNDS,
                                    *self.arguments(bags, '--jobs', '1')],
                                   stdout=subprocess.PIPE, encoding='utf-8')
        children = '/proc/%d/task/%d/children' % (process.pid, process.pid)

        def child():
            with open(children, encoding='utf-8') as file:
                return [int(pid) for pid in file.read().split()
                        if open('/proc/%s/comm' % pid).read() == 'bag_bounds\n']
        try:
            wait_for(child, 'a process for the bag', DEADLINE)
            os.kill(child()[0], signal.SIGKILL)
            out = process.communicate(timeout=DEADLINE)[0]
        finally:
            process.kill()
        self.assertEqual(process.returncode, 1)
        lines = {json.loads(line)['bag']: json.loads(line) for line in out.splitlines()}
        self.assertEqual([lines[bag]['verdict'] for bag in bags], ['DIED', 'CLEAR'])
        self.assertIn('ended by signal 9', lines[bags[0]]['reason'])
        path = self.write('lines.jsonl', out)
        again = self.lines(bags, '--resume', path, code=0)
        self.assertEqual([json.loads(line)['verdict'] for line in again], ['CLEAR'])
        other = self.write('other.jsonl', again[0] + '\n')
        for order in ((path, other), (other, path)):
            self.assertIn('2 CLEAR', self.merged(*order, code=0)[0])

    def test_ctrl_c(self):
        bags = [self.bag(calm(3), 'short.bag'), self.endless_bag()]
        path, (master, slave) = self.path('lines.jsonl'), pty.openpty()
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            with open(path, 'wb') as out:
                process = subprocess.Popen([bag_bounds_testing.BAG_BOUNDS,
                                            *self.arguments(bags, '--jobs', '2',
                                                            '--allow-incomplete')],
                                           stdout=out, stderr=slave)
            wait_for(lambda: os.path.getsize(path) > 0, 'the line of the short bag', DEADLINE)
            begin = time.monotonic()
            process.send_signal(signal_number)
            process.wait(DEADLINE)
            self.assertLess(time.monotonic() - begin, PROMPT)
            self.assertEqual(process.returncode, INCOMPLETE)
            with open(path, encoding='utf-8') as file:
                self.assertEqual([json.loads(line)['bag'] for line in file], bags[:1])
        os.close(slave)
        shown = b''
        while True:
            try:
                shown += os.read(master, 1 << 16)
            except OSError:
                break
        os.close(master)
        self.assertRegex(shown.decode(), r'\d+/100 % of the bags, 1 done')
        self.assertIn('interrupted: 1 of 2 bags are done, and have their lines', shown.decode())
        self.assertNotIn('accepts', shown.decode())

    def test_a_full_disk(self):
        if not os.path.exists('/dev/full'):
            self.skipTest('skipped: there is no /dev/full')
        with open('/dev/full', 'wb') as out:
            done = subprocess.run([bag_bounds_testing.BAG_BOUNDS, *self.arguments([self.bag(calm(3))])],
                                  stdout=out, stderr=subprocess.PIPE, encoding='utf-8')
        self.assertEqual(done.returncode, 1)
        self.assertIn('cannot write to standard output', done.stderr)


class MergeTest(EachBagTest):
    def files(self):
        """Lines of three bags in two files: nothing found, a zone entered, no message."""
        bags = [self.bag(calm(3), 'a.bag'), self.bag(arms(100), 'b.bag'), self.bag([], 'c.bag')]
        lines = sorted(self.lines(bags, code=1))
        return bags, lines, [self.write('1.jsonl', lines[0] + '\n' + lines[1] + '\n'),
                             self.write('2.jsonl', lines[2] + '\n')]

    def test_formats(self):
        bags, lines, files = self.files()
        table, err = self.merged(*files, code=1)
        self.assertEqual((self.merged(*files[::-1], code=1)[0], err), (table, ''))
        self.assertIn('3 bags: 1 CLEAR, 1 FOUND, 1 UNUSABLE', table)
        self.assertRegex(table, r'(?m)^front +1 +1$')
        self.assertRegex(table, r'UNUSABLE: .*c.bag: there is no message')
        worst = json.loads(lines[1])['worst']
        self.assertIn('nearest pair of all: %s - %s, %.6f m, in %s' % (
            worst['first'], worst['second'], worst['distance'], bags[1]), table)
        report = json.loads(self.merged(*files, '--format', 'json', code=1)[0])
        self.assertEqual(report['bags'], [json.loads(line) for line in lines])
        self.assertEqual(report['verdicts'], {'CLEAR': 1, 'FOUND': 1, 'UNUSABLE': 1})
        self.assertEqual(report['count'], 3)
        self.assertEqual(report['worst'], {'bag': bags[1], **{
            key: worst[key] for key in ('first', 'second', 'clearance', 'distance', 'time')}})
        self.assertEqual(report['zones'], [{'name': 'far', 'entries': 0, 'bags': 0},
                                           {'name': 'front', 'entries': 1, 'bags': 1}])
        rows = list(csv.DictReader(io.StringIO(self.merged(*files, '--format', 'csv', code=1)[0])))
        self.assertEqual([row['bag'] for row in rows], bags)
        self.assertEqual(float(rows[1]['distance']), worst['distance'])
        self.assertEqual((rows[1]['first'], rows[1]['entries']), (worst['first'], '1'))
        self.assertIn('no message', rows[2]['reason'])

    def test_two_bags_of_one_name_in_one_file(self):
        """As where the lines of two folders are appended. The finding in the first must not go."""
        bags, lines, _ = self.files()
        self.bag(calm(4), 'b.bag')
        other = self.lines(bags[1:2], code=0)[0]
        os.rename(bags[1], bags[1] + '.away')
        gone = self.lines(bags[1:2], code=1)[0]
        for rest in (other,), (gone, other):
            self.check_refused('line %d is of bag .*b.bag, and so is an earlier line with a finding, '
                               'but of another size or content: .*different paths' % (1 + len(rest)),
                               '--merge', self.write('two.jsonl', '\n'.join((lines[1], *rest)) + '\n'))
        hidden = self.write('hidden.jsonl', other + '\n' + lines[1] + '\n')
        self.assertIn('1 bag: 1 FOUND', self.merged(hidden, code=3)[0])

    def test_lines_that_do_not_fit(self):
        bags, lines, files = self.files()
        other = self.lines(bags[:1], '--padding', '0.001', code=0)[0]
        self.check_refused('are of different robots, options or versions', '--merge', *files,
                           self.write('3.jsonl', other + '\n'))
        self.bag(calm(4), 'a.bag')
        changed = self.lines(bags[:1], code=0)[0]
        self.check_refused('a.bag in .* differ; leave the older file out', '--merge', *files,
                           self.write('4.jsonl', changed + '\n'))
        newest = self.write('5.jsonl', lines[0] + '\n' + changed + '\n')
        self.assertIn('1 bag: 1 CLEAR', self.merged(newest, code=0)[0])

    def test_lines_from_another_system(self):
        _, lines, files = self.files()
        expected = self.merged(*files, '--format', 'json', code=1)
        marked = self.write('marked.jsonl', '\ufeff' + '\r\n'.join(lines) + '\r\n')
        self.assertEqual(self.merged(marked, '--format', 'json', code=1), expected)

    def test_names_of_any_length(self):
        """They are keys in a line."""
        text = 'n' * 1100
        post = marker(text + '/1', frame='unknown', frame_locked=True)
        bags = [self.bag(calm(3) + [('/objects', post, time_of(1000))])]
        options = ('--objects', '/objects')
        path = self.write('long.jsonl', self.lines(bags, *options, code=INCOMPLETE)[0] + '\n')
        table, err = self.merged(path, code=INCOMPLETE)
        self.assertIn('--allow-incomplete accepts', err)
        self.assertIn('INCOMPLETE: %s: %s/1 never had a box' % (bags[0], text), table)
        self.assertEqual(self.lines(bags, *options, '--resume', path, code=INCOMPLETE), [])

    def test_a_finding_beside_a_zone_that_is_never_compared(self):
        """It is not lost, and the reason why the rest is not known, neither."""
        with open(self.zones, 'a', encoding='utf-8') as file:
            file.write(zone_text('lost', [0] * 3, [1] * 3, 'wrold'))
        bag = self.bag(arms(100))
        line = self.lines([bag], code=ENTERED)[0]
        found = json.loads(line)
        self.assertEqual((found['verdict'], found['exit']), ('FOUND', ENTERED))
        self.assertEqual([zone['entries'] for zone in found['zones']], [0, 1, 0])
        self.assertIn('zone "lost" was never compared', found['reason'])
        table, _ = self.merged(self.write('lines.jsonl', line + '\n'), code=ENTERED)
        self.assertRegex(table, '(?m)^FOUND: .*arms.bag: zone "lost" was never compared')
        self.assertRegex(table, r'(?m)^front +1 +1$')
        self.report(bag, '--zones', self.zones, code=ENTERED,
                    err='warning: zone "lost" was never compared')
        cut = dict(found, losses=['the file was cut'])  # --merge shows both
        table, _ = self.merged(self.write('cut.jsonl', json.dumps(cut) + '\n'), code=ENTERED)
        self.assertRegex(table, '(?m)^FOUND: .*never compared.*; the file was cut')

    def test_links_of_which_nothing_is_said(self):
        line = json.loads(self.lines([self.bag(calm(5))], code=0)[0])
        self.assertEqual(line['left_out'], '')
        lines = [dict(line, left_out='left out are "a"'), dict(line, bag='b.bag', left_out='')]
        for order in lines, lines[::-1]:
            path = self.write('lines.jsonl', '\n'.join(map(json.dumps, order)) + '\n')
            self.assertEqual(self.merged(path, code=0)[1], 'bag_bounds: note: left out are "a"\n')

    def test_lines_without_what_is_needed(self):
        _, lines, _ = self.files()
        for text in ('{"bag": "a"}', lines[0].replace('"exit"', '"quit"'),
                     lines[0].replace('"size": ', '"size": -')):
            self.check_refused('few.jsonl, line 2 is no line of bag_bounds --each', '--merge',
                               self.write('few.jsonl', lines[1] + '\n' + text + '\n'))
        self.check_refused('no line to merge in .*cut.jsonl', '--merge',
                           self.write('cut.jsonl', lines[0][:300]))

    def test_verdicts_that_contradict_exit_codes(self):
        _, lines, _ = self.files()
        for verdict, code in (('CLEAR', 3), ('FOUND', 0), ('DIED', 0), ('FINE', 0), ('UNUSABLE', 9)):
            wrong = lines[0].replace('"verdict": "CLEAR", "exit": 0',
                                     '"verdict": "%s", "exit": %d' % (verdict, code))
            self.assertNotEqual(wrong, lines[0])
            self.check_refused('wrong.jsonl, line 2 has the verdict "%s", but the exit code %d'
                               % (verdict, code), '--merge',
                               self.write('wrong.jsonl', lines[1] + '\n' + wrong + '\n'))
        for index, rest in (0, 2), (1, 0):  # else --allow-incomplete would accept any finding
            wrong = lines[index].replace(', "frame"', ', "complete_exit": %d, "frame"' % rest, 1)
            self.assertNotEqual(wrong, lines[index])
            self.check_refused(r'\(%d with --allow-incomplete\), which does not go' % rest, '--merge',
                               self.write('wrong.jsonl', wrong + '\n'), '--allow-incomplete')
        died = lines[2].replace('UNUSABLE', 'DIED')
        self.assertIn('1 DIED', self.merged(self.write('died.jsonl', died + '\n'), code=1)[0])

    def test_lines_that_were_cut(self):
        _, lines, _ = self.files()
        for text in (lines[0] + '\n' + lines[1][:300], lines[0] + '\n{"ba',
                     lines[1][:300] + lines[0] + '\n', '{"bag": "' + lines[0] + '\n'):
            _, err = self.merged(self.write('cut.jsonl', text), code=INCOMPLETE)
            self.assertRegex(err, r'line [12] was cut, and its bag has no whole line')
        healed = self.write('healed.jsonl', lines[0][:300] + lines[0] + '\n')
        self.assertEqual(self.merged(healed, code=0)[1], '')

    def test_a_line_that_was_cut_may_be_whole_in_another_file(self):
        bags, lines, _ = self.files()
        cut = self.write('cut.jsonl', lines[0][:300])
        whole = self.write('whole.jsonl', lines[0] + '\n')
        for files in (cut, whole), (whole, cut):
            self.assertEqual(self.merged(*files, code=0)[1], '')
        resumed = [item for file in (cut, whole) for item in ('--resume', file)]
        found = run(*self.arguments(bags[:1], *resumed))
        self.assertEqual(found, (0, '', 'bag_bounds: 1 of 1 bags have a line already\n'))

    def test_a_bag_that_was_whole_only_later(self):
        """At first it was empty, then a part of it was there. A bag that is another one counts."""
        whole = self.path('a.bag')
        bags = [whole]
        write_bag(whole, [('/other', String('0' * 100000), time_of(BEGIN))] + calm(3))
        later = self.write('3.jsonl', self.lines(bags, code=0)[0] + '\n')
        with open(whole, 'rb') as file:
            data = file.read()
        for size in 0, 90000:
            with open(whole, 'wb') as file:
                file.write(data[:size])
            earlier = self.write('1.jsonl', self.lines(bags, code=1)[0] + '\n')
            for order in (earlier, later), (later, earlier):
                self.assertIn('1 bag: 1 CLEAR', self.merged(*order, code=0)[0])
            both = pathlib.Path(earlier).read_text('utf-8') + pathlib.Path(later).read_text('utf-8')
            self.assertIn('1 CLEAR', self.merged(self.write('both.jsonl', both), code=0)[0])
        for size in 10, 200000:
            write_bag(whole, [('/other', String('0' * size), time_of(BEGIN))])
            other = self.write('2.jsonl', self.lines(bags, code=1)[0] + '\n')
            self.check_refused('a.bag in .* differ; leave the older file out', '--merge', other, later)

    def test_what_is_incomplete_may_be_accepted(self):
        bags = [self.bag(calm(3), 'a.bag'), self.bag([static_arms()], 'b.bag')]
        lines = self.lines(bags, code=INCOMPLETE)
        file = self.write('1.jsonl', '\n'.join(lines) + '\n')
        table, err = self.merged(file, code=INCOMPLETE)
        self.assertRegex(err, 'warning: not everything was answered: .* --allow-incomplete accepts')
        self.assertEqual(self.merged(file, '--allow-incomplete', code=0), (table, ''))
        self.assertEqual(self.lines(bags, '--allow-incomplete', '--resume', file, code=0), [])
        lines = self.lines(bags, '--allow-incomplete', code=0)
        file = self.write('2.jsonl', '\n'.join(lines) + '\n')
        self.assertEqual(self.merged(file, code=INCOMPLETE)[0], table)
        self.assertEqual(self.lines(bags, '--allow-incomplete', '--resume', file, code=0), [])


if __name__ == '__main__':
    main()
