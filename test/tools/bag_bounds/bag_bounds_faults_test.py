#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What bag_bounds says of bags, robots and arguments that it cannot use, or not entirely.

Run as: bag_bounds_faults_test.py PATH_OF_bag_bounds
"""
import csv
import io
import os
import pathlib
import shutil
import struct

import genpy
import rosbag
from bag_bounds_testing import (BEGIN, COUNT, ENTERED, INCOMPLETE, PARTLY_READ, PERIOD, BagBoundsTest,
                                arms, main, moving_arms, raw, run, seconds, static_arms, time_of,
                                zone_text)
from bounds_testing import robot, transform
from node_testing import ARMS
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

YEARS = 1e9  # s
MESHES = pathlib.Path(__file__).resolve().parents[3] / 'launch/demo/meshes'


def without_index(source, target):
    """As a recorder leaves it that was killed: the index is missing, and nothing says where."""
    with open(source, 'rb') as file:
        data = bytearray(file.read())
    place = data.index(b'index_pos=') + len(b'index_pos=')
    index = struct.unpack_from('<Q', data, place)[0]
    data[place:place + 8] = bytes(8)
    with open(target, 'wb') as file:
        file.write(data[:index])


def raw_messages(path):
    """Topic, bytes and record time of each message."""
    with rosbag.Bag(path) as bag:
        return [(topic, data[1], time) for topic, data, time in bag.read_messages(raw=True)]


class ArgumentsTest(BagBoundsTest):
    def test_refused_arguments(self):
        bag = self.bag(arms(3))
        good = (bag, '--urdf', self.urdf)
        link = os.path.join(os.path.dirname(bag), 'link.bag')
        os.symlink(bag, link)
        for reason, *arguments in (
                ('no bag is given', '--urdf', self.urdf),
                ('no robot is given; add --urdf', bag),
                ('--urdf is empty', bag, '--urdf', ''),
                ('there is no option --hepl', '--hepl'),
                ('option --zones needs a value', '--zones'),
                ('--help=3: this option takes no value', '--help=3'),
                ('--geometry is "all", but must be one of: both, collision, visual', *good,
                 '--geometry', 'all'),
                ('.bag: is given twice; give each bag once', *good, bag),
                ('link.bag: is given twice; give each bag once', *good, link),
                ('--zones is given twice', *good, '--zones', 'a', '--zones', 'b'),
                ('--static-from is given twice', *good, *('--static-from', bag) * 2),
                ('--format is given twice', *good, '--format', 'csv', '--format', 'csv'),
                ('--format is "xml"', *good, '--format', 'xml'),
                ('--start is "-1", but must be a number of seconds >= 0', *good, '--start', '-1'),
                ('--end is "nan"', *good, '--end', 'nan'),
                ('--end is before --start', *good, '--start', '2', '--end', '1'),
                ('--distances is "near"', *good, '--distances', 'near'),
                ('--padding is "2e6", but must be a number of metres from 0 to 1e6', *good,
                 '--padding', '2e6'),
                ('--timeout is "-1"', *good, '--timeout', '-1'),
                ('--ignore-pairs is "left", but must be pairs', *good, '--ignore-pairs', 'left'),
                ('--objects is /tf, which has transforms; name', *good, '--objects', 'tf'),
                ('--objects is /tf_static, which', *good, '--objects', '/tf_static'),
                ('--objects is /my/tf, which', *good, '--tf-topic', 'my/tf', '--objects', 'my/tf'),
                ('--objects is /js, which has positions of joints', *good, '--joint-states', 'js',
                 '--objects', 'o', '--objects', 'js'),
                ('--tf-topic is empty', *good, '--tf-topic', ''),
                ('--min-coverage is "2", but must be', *good, '--min-coverage', '2'),
                ('--jobs is "0", but must be a whole number from 1', *good, '--jobs', '0'),
                ('--static-from .*none.bag|none.bag', *good, '--static-from', self.path('none.bag')),
                ('cannot read .*none.urdf: No such file', bag, '--urdf', self.path('none.urdf')),
                ('cannot read .*none.yaml: No such file', *good, '--zones', self.path('none.yaml')),
                ('--out is .*arms.bag, which is read', *good, '--out', bag),
                ('--series is .*arms.bag, which is read', *good, '--series', bag),
                ('--series is the file of --out', *good, '--out', 'a', '--series', 'a'),
                ('--series is the file of --out', *good, '--out', self.path('new'), '--series',
                 os.path.relpath(self.path('./new'))),
                ('--urdf and --zones cannot both come from standard input', bag, '--urdf', '-',
                 '--zones', '-'),
                ('none/a.csv: cannot be written', *good, '--series', self.path('none/a.csv')),
                ('none/out.bag: cannot be written', *good, '--out', self.path('none/out.bag'))):
            with self.subTest(reason):
                self.check_refused(reason, *arguments)
        self.assertEqual(self.report(bag)['messages'], 4)  # nothing was overwritten

    def test_inputs_are_not_overwritten(self):
        bag = self.bag(arms(3))
        zones = self.write('zones.yaml', zone_text('all', [-9] * 3, [9] * 3))
        for file in (bag, self.urdf, zones):
            with open(file, 'rb') as opened:
                before = opened.read()
            os.symlink(file, self.path('link'))
            os.link(file, self.path('hard'))
            for out in (file, os.path.relpath(file), self.path('link'), self.path('hard')):
                with self.subTest(file=file, out=out):
                    self.check_refused('--out is %s, which is read' % file, bag, '--urdf', self.urdf,
                                       '--zones', zones, '--out', out)
                with open(file, 'rb') as opened:
                    self.assertEqual(opened.read(), before)
            os.remove(self.path('link'))
            os.remove(self.path('hard'))

    def test_meshes_are_not_overwritten(self):
        shutil.copy(MESHES / 'wrist.stl', self.path('part.stl'))
        urdf = self.write('meshes.urdf', ARMS.replace(
            '<link name="bare"/>', '<link name="bare"><visual><geometry><mesh filename="part.stl"/>'
            '</geometry></visual></link>'))
        size = os.path.getsize(self.path('part.stl'))
        for option in '--out', '--series':
            self.check_refused(option + ' is .*part.stl, which is read', self.bag(arms(3)), '--urdf',
                               urdf, option, self.path('part.stl'))
            self.assertEqual(os.path.getsize(self.path('part.stl')), size)

    def test_standard_input_is_not_overwritten(self):
        with open(self.urdf, encoding='utf-8') as file:
            code, _, err = run(self.bag(arms(3)), '--urdf', '-', '--out', self.urdf, stdin=file)
        self.assertEqual(code, 1)
        self.assertIn('which is read', err)
        self.assertGreater(os.path.getsize(self.urdf), 0)

    def test_refused_robots(self):
        bag = self.bag(arms(3))
        text = self.write('a.urdf', 'text')
        self.check_refused('a.urdf: the robot description is not a usable URDF', bag, '--urdf', text)
        bare = self.write('bare.urdf', robot(['<link name="base"/>'], []))
        self.check_refused('no link of the robot has geometry of the kind collision', bag, '--urdf',
                           bare, '--geometry', 'collision')

    def test_names_that_differ_in_bytes_that_are_not_utf8(self):
        with open(self.urdf, 'wb') as file:
            file.write(ARMS.encode().replace(b'"left"', b'"a\xfe"').replace(b'"right"', b'"a\xff"'))
        self.check_refused('two links of the robot are called "a\ufffd"', self.bag(arms(3)),
                           '--urdf', self.urdf)

    def test_another_robot(self):
        other = self.write('other.urdf', robot(
            ['<link name="a"/>', '<link name="b"><visual><geometry><box size="1 1 1"/></geometry>'
             '</visual></link>'], [('a', 'b')]))
        code, _, err = run(self.bag(arms(3)), '--urdf', other)
        self.assertEqual(code, 1)
        self.assertRegex(err, 'error: no link ever had a box: no transform from "b" to "a"')

    def test_a_mesh_that_is_lost(self):
        broken = self.write('broken.urdf', ARMS.replace(
            '<link name="bare"/>', '<link name="bare"><visual><geometry><mesh filename="none.stl"/>'
            '</geometry></visual></link>'))
        arguments = (self.bag(arms(3)), '--urdf', broken, '--format', 'json')
        code, out, err = run(*arguments)
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('none.stl', err)
        self.assertIn('none.stl', out)
        for options, expected in ((['--strict'], INCOMPLETE), (['--allow-incomplete'], 0),
                                  (['--allow-incomplete', '--strict'], 2)):
            self.assertEqual(run(*arguments, *options)[0], expected)

    def test_output_that_cannot_be_written(self):
        bag = self.bag(arms(COUNT))
        code, _, err = run(bag, '--urdf', self.urdf, '--out', '/dev/full')
        self.assertEqual(code, 1)
        self.assertIn('/dev/full', err)


class BagsTest(BagBoundsTest):
    def test_refused_bags(self):
        urdf = ('--urdf', self.urdf)
        self.check_refused('none.bag', self.path('none.bag'), *urdf)
        self.check_refused('text.bag', self.write('text.bag', 'no bag\n' * 100), *urdf)
        self.check_refused('v1.bag', self.write('v1.bag', '#ROSBAG V1.2\n' + 'x' * 100), *urdf)
        self.check_refused('there is no message to read', self.bag([], name='empty.bag'), *urdf)
        bag = self.bag(arms(1))
        self.check_refused('arms.bag', bag, bag, *urdf)

    def test_no_transforms(self):
        bag = self.bag([('/chatter', String('tf'), time_of(BEGIN))])
        code, _, err = run(bag, '--urdf', self.urdf)
        self.assertEqual(code, 1)
        self.assertIn('error: there is no message on /tf or /tf_static', err)

    def test_transforms_behind_the_end(self):
        other = ('/chatter', String('tf'), time_of(BEGIN - 5))
        code, _, err = run(self.bag([other] + arms(3)), '--urdf', self.urdf, '--end', '2')
        self.assertEqual(code, 1)
        self.assertIn('error: there are no transforms before --end; let it be later', err)

    def test_other_topics_go_on_where_tf_ends(self):
        """Silence at the end of a bag is no box."""
        other = [('/chatter', String('x'), time_of(BEGIN + second)) for second in range(10)]
        bag = self.bag(arms(100) + other)
        for arguments, to in ([], 9), (['--end', '7'], 7), (['--end', '3'], 3):
            with self.subTest(arguments=arguments):
                is_silent = to > 5
                found = self.report(bag, *arguments, code=INCOMPLETE if is_silent else 0,
                                    err='incomplete names' if is_silent else '')
                self.assertEqual('left' in found['incomplete'], is_silent)
                self.assertEqual(found['to'], to)

    def test_the_end_of_a_bag_whatever_the_order_of_its_topics(self):
        other = [('/chatter', String('x'), time_of(BEGIN + second)) for second in range(10)]
        for messages in other + arms(50), arms(50) + other:
            found = self.report(self.bag(messages), code=INCOMPLETE, err='incomplete names: 3')
            self.assertEqual(found['to'], 9)
        second_pass = [moving_arms(i) for i in range(30)]
        found = self.report(self.bag(arms(50) + other[9:] + second_pass), err='the clock jumped back')
        self.assertEqual(found['to'], seconds(29))

    def test_a_robot_that_stands_before_the_start(self):
        other = [('/chatter', String('x'), time_of(BEGIN + second)) for second in range(10)]
        zones = self.write('zones.yaml', zone_text('all', [-9] * 3, [9] * 3))
        bag = self.bag([static_arms()] + other)
        found = self.report(bag, '--zones', zones, '--start', '5', code=ENTERED, err='')
        self.assertEqual((found['from'], found['to']), (5, 9))
        self.assertEqual({stay['name'] for stay in found['zones'][0]['stays']}, {'base', 'mast'})

    def test_two_outputs_are_two_files(self):
        bag = self.bag(arms(3))
        for series in 'both', './both', self.path('both'), 'elsewhere/../both':
            done = run(bag, '--urdf', self.urdf, '--out', 'both', '--series', series,
                       cwd=self.folder)
            with self.subTest(series=series):
                self.assertEqual(done[0], 1)
                self.assertIn('--series is the file of --out', done[2])

    def test_nothing_between_start_and_end(self):
        code, out, err = run(self.bag(arms(10)), '--urdf', self.urdf, '--start', '100')
        self.assertEqual(code, 1)
        self.assertIn('from 100.000 to 100.000\n', out)
        self.assertRegex(err, 'nothing was recorded between --start and --end; .* end 0.180 s')

    def test_compressed_bags_are_read_alike(self):
        expected = self.report(self.bag(arms(COUNT)))
        for compression in (rosbag.Compression.BZ2, rosbag.Compression.LZ4):
            bag = self.bag(arms(COUNT), name='small.bag', compression=compression)
            for jobs in '1', '2', '7':
                self.assertEqual(self.report(bag, '--jobs', jobs), expected)

    def test_several_bags_are_read_as_one(self):
        messages = arms(COUNT)
        bags = [self.bag(messages[i::3], name='%d.bag' % i) for i in range(3)]
        self.assertEqual(self.report(bags), self.report(self.bag(messages)))

    def test_a_bag_that_was_never_closed(self):
        without_index(self.bag(arms(COUNT)), self.path('open.bag'))
        found = self.report(self.path('open.bag'), code=PARTLY_READ, err='warning: .*open.bag')
        self.assertEqual(found['messages'], COUNT + 1)
        self.assertEqual(len(found['losses']), 1)
        code, out, _ = run(self.path('open.bag'), '--urdf', self.urdf, '--format', 'csv')
        self.assertEqual(code, PARTLY_READ)
        self.assertEqual([row for row in csv.reader(io.StringIO(out)) if row[0] == 'partial'],
                         [['partial', found['losses'][0], '', '', '', '']])

    def test_a_cut_bag(self):
        """Its boxes are the first ones of the whole bag, which bag_beside_node compares with the
        node."""
        bag = self.bag(arms(1000))
        self.report(bag, '--out', self.path('whole_boxes.bag'))
        os.truncate(bag, os.path.getsize(bag) // 2)
        found = self.report(bag, '--out', self.path('boxes.bag'), code=PARTLY_READ,
                            err='warning: .*arms.bag')
        self.assertTrue(300 < found['messages'] < 1000, found['messages'])
        self.assertGreater(len(found['losses']), 0)
        boxes, whole = (raw_messages(self.path(name)) for name in ('boxes.bag', 'whole_boxes.bag'))
        self.assertGreaterEqual(len(boxes), found['messages'])
        self.assertEqual(boxes, whole[:len(boxes)])
        rest = self.report(self.bag(arms(1000)[:found['messages']]))
        self.assertEqual(found['extremes'], rest['extremes'])

    def test_an_entry_counts_more_than_a_loss(self):
        bag = self.bag(arms(1000))
        os.truncate(bag, os.path.getsize(bag) // 2)
        zones = self.write('zones.yaml', zone_text('all', [-9] * 3, [9] * 3))
        self.report(bag, '--zones', zones, code=ENTERED, err='warning: .*arms.bag')

    def test_a_message_that_is_too_short(self):
        path = self.path('short.bag')
        with rosbag.Bag(path, 'w') as bag:
            for index, (topic, message, time) in enumerate(arms(10)):
                kind, data, md5, python = raw(message)
                short = data[:-1] if index == 5 else data
                bag.write(topic, (kind, short, md5, python), time, raw=True)
        found = self.report(path, code=PARTLY_READ, err='1 message is too short')
        self.assertEqual(found['extremes'][2]['max_time'][2], 0.0)

    def far_left(self, index, value):
        topic, message, time = moving_arms(index)
        message.transforms[0].transform.translation.x = value
        return topic, message, time

    def test_numbers_that_are_none(self):
        """tf refuses them, so no box changes."""
        bad = [self.far_left(20, float('nan')), self.far_left(21, float('inf'))]
        found = self.report(self.bag(arms(20) + bad + [moving_arms(22)]), code=INCOMPLETE,
                            err='is refused')
        expected = self.report(self.bag(arms(23)))
        self.assertEqual(found['extremes'][0], expected['extremes'][0])
        self.assertLess(found['extremes'][2]['max'][0], 1)

    def test_transforms_that_are_left_out(self):
        """Nobody looked at their poses. One that only comes again says nothing new."""
        count = 600  # 12 s
        end = BEGIN + PERIOD * count
        stranger = '/tf', TFMessage([transform('base', 'cup', time_of(end), (float('nan'), 0, 0))])
        above = [('/tf', TFMessage([transform('map', 'base', time_of(end), (x, 0, 0))]), time_of(end))
                 for x in (1, 2)]
        for left_out, reason in (
                ([self.far_left(count, float('nan'))], '1 transform left out, which tf2 refuses'),
                ([moving_arms(0.5, end)], '3 transforms left out, more than 10 s older'),
                ([moving_arms(300, end, angle_index=350)], '3 transforms left out, because another'),
                ([moving_arms(0), moving_arms(500, BEGIN + PERIOD)],
                 '3 transforms left out, of the time before a jump'),
                ([moving_arms(500, BEGIN), moving_arms(1)],
                 '3 transforms left out, of the time before a jump'),
                ([moving_arms(i, end) for i in range(250, 350)], None),
                ([(*stranger, time_of(end))], None), (above, None)):  # which no box needs
            with self.subTest(reason=reason):
                bag = self.bag(arms(count) + left_out)
                found = self.report(bag, code=INCOMPLETE if reason else 0, err=reason or '.*')
                self.assertEqual(len(found['losses']), 1 if reason else 0)

    def test_huge_numbers(self):
        """A box that is finite counts; a pose that overflows gives none. The ways are not decided."""
        far, farther = arms(20) + [self.far_left(20, 1e300)], [self.far_left(20, 1.7e308)]
        found = self.report(self.bag(far))
        self.assertAlmostEqual(found['extremes'][2]['max'][0] / 1e300, 1)
        for messages in far, arms(20) + farther + [moving_arms(21)]:
            found = self.report(self.bag(messages), '--distances', '0.01', code=INCOMPLETE,
                                err='not decided')
            self.assertRegex(found['open'][0], 'motions of pairs that are not decided: [1-9]')

    def test_distances_that_nobody_compared(self):
        one = self.write('one.urdf', '<robot name="one"><link name="base"><visual><geometry>'
                         '<box size="1 1 1"/></geometry></visual></link></robot>')
        arguments = (self.bag(arms(3)), '--urdf', one)
        self.assertEqual(run(*arguments)[0], 0)
        code, _, err = run(*arguments, '--distances', '0.1')
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('no two bodies were compared', err)

    def test_links_too_far_away_for_distances(self):
        """Side by side, so that their boxes do not tell that they are far apart."""
        links = ['base', 'a', 'b']
        urdf = self.write('three.urdf', '<robot name="three">%s%s</robot>' % (
            ''.join('<link name="%s"><visual><geometry><box size="1 1 1"/></geometry></visual></link>'
                    % link for link in links),
            ''.join('<joint name="to %s" type="floating"><parent link="base"/><child link="%s"/>'
                    '</joint>' % (link, link) for link in links[1:])))
        message = TFMessage([transform('base', link, time_of(BEGIN), (1e61, 0, 0)) for link in links[1:]])
        bag = self.bag([('/tf_static', message, time_of(BEGIN))])
        code, _, err = run(bag, '--urdf', urdf, '--distances', '0.1')
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('names of which not all distances are known', err)

    def test_a_warning_of_the_urdf_leaves_the_report_open(self):
        """What a macro that was not expanded, or a second robot, stands for is not looked at."""
        macro = ARMS.replace('<link', '<xacro:hand/><link', 1).replace(
            '<robot', '<robot xmlns:xacro="http://ros.org/wiki/xacro"')
        for text in macro, ARMS + '<robot name="other"><link name="tool"/></robot>':
            self.urdf = self.write('arms.urdf', text)
            self.report(self.bag(arms(3)), code=INCOMPLETE, err='warnings of the URDF: 1')
            self.report(self.bag(arms(3)), '--allow-incomplete', err='robot description')

    def test_a_recorder_whose_clock_was_set(self):
        """Years without a message take no time; back by years is a clock that jumped."""
        messages = arms(5) + [moving_arms(5, BEGIN + YEARS), moving_arms(6)]
        found = self.report(self.bag(messages), code=INCOMPLETE, err='the clock jumped back')
        self.assertEqual(found['messages'], 8)
        self.assertRegex(found['incomplete']['left'], 'had no box 2 times, 999999')

    def test_a_bag_that_is_not_in_the_order_of_time(self):
        """One topic was written after the other. A clock that goes back does so on each topic."""
        messages = [moving_arms(i) for i in range(100)]
        for late in [static_arms()], [static_arms(), static_arms(BEGIN + seconds(1))]:
            found = self.report(self.bag(messages + late), code=PARTLY_READ, err='rosbag filter')
            loss = found['losses'][0]
            self.assertRegex(loss, 'record time goes back 1 time, to 0.000 s')
        self.report(self.bag([static_arms()] + messages + [static_arms()] + messages),
                    err='the clock jumped back')
        again = messages[50:]  # after the jump, a topic comes first that had no message before
        new = [static_arms(BEGIN + seconds(50))]
        found = self.report(self.bag(messages + new + again), err='the clock jumped back',
                            code=INCOMPLETE)
        self.assertEqual(found['losses'], [])
        late = list(messages)  # one is recorded late, which tells nothing of the other topic
        late[80] = late[80][:2] + (time_of(BEGIN + seconds(90)),)
        found = self.report(self.bag([static_arms(BEGIN + seconds(i)) for i in range(100)] + late),
                            code=PARTLY_READ, err='rosbag filter')
        self.assertRegex(found['losses'][0], 'record time goes back 1 time, to 0.000 s')
        small = [moving_arms(99, BEGIN + seconds(99 - i)) for i in (3, 6)]  # they add up to a jump
        found = self.report(self.bag([static_arms()] + messages + small), err='the clock jumped back')
        self.assertEqual(found['losses'], [])

    def test_links_that_have_geometry_of_the_other_kind_only(self):
        """Nothing is said of them, and that is said."""
        self.urdf = self.write('bare.urdf', ARMS.replace(
            '<link name="bare"/>', '<link name="bare"><collision><geometry><sphere radius="1"/>'
            '</geometry></collision></link>'))
        bag, note = self.bag(arms(5)), 'left out are links with collision geometry only: "bare"'
        said = 'bag_bounds: note: %s; --geometry both takes them, too\n' % note
        self.assertEqual(self.report(bag, err='^%s$' % said)['left_out'], note)
        found = self.report(bag, '--geometry', 'both', code=INCOMPLETE, err='incomplete names: 1')
        self.assertEqual(found['left_out'], '')

    def test_a_publisher_that_is_late(self):
        """The motion beside its message was not looked at, so this is no jump of the clock."""
        slow = [moving_arms(i, links=('right',)) for i in (0, 40, 80)]
        for place in 50, 40:  # where the one of 40 stands
            messages = [static_arms()] + [moving_arms(i, links=('left',)) for i in range(100)]
            for message, index in zip(slow, (1, place, 81)):
                messages.insert(index, message)
            found = self.report(self.bag(messages), code=INCOMPLETE, err='incomplete names')
            self.assertEqual(len(found['losses']), int(place == 50), found['losses'])
        self.assertEqual(found['open'], ['incomplete names: %d' % len(found['incomplete'])])

    def test_a_clock_that_goes_back_beyond_the_report(self):
        """What it records then is not in the report, which says so."""
        back = arms(100) + [moving_arms(i) for i in range(40)]
        self.report(self.bag(back), '--start', '1', code=PARTLY_READ,
                    err='40 messages have a time before --start; leave out --start')
        self.report(self.bag(back), '--start', '0.5', '--end', '0.7', code=PARTLY_READ,
                    err='after --end the clock went back, to messages that were not read')
        self.report(self.bag(back), '--start', '0', code=0, err='the clock jumped back')
        ahead = arms(20) + [moving_arms(20, BEGIN + YEARS)]
        for rest, code in ([moving_arms(i) for i in range(21, 60)], PARTLY_READ), ([], 0):
            with self.subTest(rest=len(rest)):
                self.report(self.bag(ahead + rest), '--end', '1', code=code,
                            err='clock went back' if rest else '')

    def test_a_clock_that_goes_back_in_another_chunk(self):
        """The index tells, or, where there is none, the messages."""
        path = self.path('chunks.bag')
        for rest, code in (range(10), PARTLY_READ), (range(300, 310), 0):
            with rosbag.Bag(path, 'w', chunk_threshold=1000) as bag:
                for message in arms(300) + [moving_arms(i) for i in rest]:
                    bag.write(*message)
            without_index(path, self.path('open.bag'))
            for bag in path, self.path('open.bag'):
                with self.subTest(rest=rest, bag=bag):
                    self.report(bag, '--end', '1', code=code, err='clock went back' if code else '')

    def test_a_clock_that_goes_back_on_topics_that_are_not_read(self):
        """With an index or without one, in chunks of their own or in the same ones."""
        others = [('/other', String('x'), message[2]) for message in arms(300)]
        for size in 1000, 100000:
            path = self.path('others.bag')
            with rosbag.Bag(path, 'w', chunk_threshold=size) as bag:
                for message in arms(300) + others:
                    bag.write(*message)
            without_index(path, self.path('open.bag'))
            for bag in path, self.path('open.bag'):
                with self.subTest(size=size, bag=bag):
                    self.report(bag, '--end', '1')

    def test_record_times_of_zero(self):
        """As rosbag record has them before the first /clock."""
        zero = [(topic, message, genpy.Time(0, 1)) for topic, message, _ in arms(2)]
        found = self.report(self.bag(zero + [moving_arms(i) for i in range(2, 10)]), code=INCOMPLETE,
                            err='^bag_bounds: warning: not everything was answered: incomplete names')
        self.assertEqual(found['messages'], 11)

    def test_the_boxes_do_not_depend_on_the_file_name(self):
        shutil.copy(self.bag(arms(3)), self.path('a name with blanks.bag'))
        self.assertEqual(self.report(self.path('a name with blanks.bag'))['to'], seconds(2))

    def test_only_static_transforms(self):
        found = self.report(self.bag([static_arms()]), code=INCOMPLETE, err='incomplete names')
        self.assertEqual([box['name'] for box in found['extremes'] if 'min' in box],
                         ['base', 'mast'])


if __name__ == '__main__':
    main()
