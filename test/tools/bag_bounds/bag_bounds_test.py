#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What bag_bounds finds in a bag: extremes, coverage, boxes at one time, distances.

Run as: bag_bounds_test.py PATH_OF_bag_bounds
"""
import copy
import csv
import itertools
import math

from bag_bounds_testing import (BEGIN, COUNT, INCOMPLETE, PERIOD, UNDERCUT, BagBoundsTest, arms,
                                degrees_at, main, moving_arms, run, seconds, static_arms, time_of)
from bounds_testing import transform
from node_testing import ALL, SIZES, arm_bounds
from tf2_msgs.msg import TFMessage


class ExtremesTest(BagBoundsTest):
    def extremes(self, *arguments, **options):
        found = self.report(self.bag(arms(COUNT)), *arguments, **options)
        self.assertEqual([box['name'] for box in found['extremes']], ALL)
        return {box['name']: box for box in found['extremes']}

    def check(self, found, indices):
        """Each extreme is that of one of the boxes, which was there at the time that is printed."""
        for name, axis, side in itertools.product(ALL, range(3), ('min', 'max')):
            values = {seconds(i): arm_bounds(name, degrees_at(i))[axis + 3 * (side == 'max')]
                      for i in indices}
            expected = min(values.values()) if side == 'min' else max(values.values())
            self.assertAlmostEqual(found[name][side][axis], expected, delta=1e-12)
            time = found[name][side + '_time'][axis]
            self.assertAlmostEqual(values[round(time, 9)], expected, delta=1e-12)
            stamp = 0 if name in ('base', 'mast') else BEGIN + time
            self.assertAlmostEqual(found[name][side + '_stamp'][axis], stamp, delta=1e-6)

    def test_extremes_and_their_times(self):
        self.check(self.extremes(), range(COUNT))

    def test_start_and_end(self):
        """Boxes of the time before are there when the report begins."""
        self.check(self.extremes('--start', '0.5', '--end', '1.01'), range(25, 51))
        found = self.report(self.bag([static_arms(), moving_arms(0), moving_arms(100)]),
                            '--start', '1')
        self.assertEqual(found['from'], 1.0)
        self.assertAlmostEqual(found['extremes'][0]['min_time'][0], 1.0, delta=0.06)

    def test_the_start_is_that_of_rosbag_play(self):
        """It counts from the first message of any topic."""
        early = ('/other', static_arms()[1], static_arms(BEGIN - 1)[2])
        found = self.report(self.bag([early] + arms(3)))
        self.assertEqual(found['begin'], BEGIN - 1)
        self.assertEqual(found['extremes'][2]['min_time'][2], 1.0)

    def test_another_fixed_frame(self):
        found = self.report(self.bag(arms(3)), '--fixed-frame', 'mast')
        self.assertEqual(found['frame'], 'mast')
        mast = next(box for box in found['extremes'] if box['name'] == 'mast')
        self.assertAlmostEqual(mast['max'][1], SIZES['mast'][1] / 2, delta=1e-12)

    def test_a_gap_is_incomplete(self):
        """The box is lost two seconds after the last transform, and back with the next one."""
        bag = self.bag(arms(10) + [moving_arms(210)])
        found = self.report(bag, code=INCOMPLETE, err='answered: incomplete names: 3; --allow-inc')
        self.assertEqual(self.report(bag, '--allow-incomplete'), found)
        for name in ('left', 'left_tip', 'right'):
            self.assertRegex(found['incomplete'][name],
                             r'had no box 1 time, (1\.9\d\d|2\.000) s in all, first at 2\.2\d\d s: '
                             'stale')
        self.assertEqual(set(found['incomplete']), {'left', 'left_tip', 'right'})

    def test_a_link_without_transform_is_incomplete(self):
        bag = self.bag([static_arms()] + [moving_arms(i, links=('right',)) for i in range(5)])
        found = self.report(bag, code=INCOMPLETE, err='incomplete names: 2')
        self.assertEqual([box['name'] for box in found['extremes'] if 'min' not in box],
                         ['left', 'left_tip'])
        self.assertRegex(found['incomplete']['left'], 'never had a box: no transform')


def prefixed(messages, prefix='r1/'):
    """The same transforms between frames of other names."""
    messages = copy.deepcopy(messages)
    for edge in (t for _, message, _ in messages for t in message.transforms):
        edge.header.frame_id = prefix + edge.header.frame_id
        edge.child_frame_id = prefix + edge.child_frame_id
    return messages


class CoverageTest(BagBoundsTest):
    """No link is forgotten because it had no box."""

    def coverage(self, found):
        return {box['name']: box['coverage'] for box in found['extremes']}

    def check_remedy(self, bag, name, remedy, *arguments):
        """In each format; it makes the report complete."""
        for text in ('table', 'csv', 'json'):
            code, out, _ = run(bag, '--urdf', self.urdf, '--format', text)
            self.assertEqual(code, INCOMPLETE)
            self.assertRegex(out.replace('""', '"').replace('\\"', '"'),
                             '%s"?[:,].*never had a box: no transform .*%s' % (name, remedy))
        found = self.report(bag, *arguments)
        self.assertEqual((found['incomplete'], set(self.coverage(found).values())), ({}, {1}))
        return found['extremes']

    def test_a_prefix(self):
        bag = self.bag(prefixed(arms(COUNT)))
        self.check_remedy(bag, 'left', 'tf has "r1/left"; add --tf-prefix r1', '--tf-prefix', 'r1')
        code, out, _ = run(bag, '--urdf', self.urdf, '--distances', '0.1')
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('(no two bodies were compared)', out)
        self.assertNotIn('no pair was ever', out)
        found = self.report(self.bag(arms(3)), '--tf-prefix', 'r1', code=INCOMPLETE,
                            err='incomplete names: 4')
        self.assertIn('tf has "left"; leave out --tf-prefix', found['incomplete']['left'])

    def test_the_second_part_of_a_recording(self):
        """Its static transforms are in the first part."""
        first = self.bag(arms(COUNT)[:100], 'first.bag')
        second = self.bag(arms(COUNT)[100:], 'second.bag')
        extremes = self.check_remedy(
            second, 'mast', 'nothing leads up from "mast"; .* add --static-from FIRST.bag',
            '--static-from', first)
        whole = self.bag([static_arms(BEGIN + seconds(99))] + arms(COUNT)[100:], 'whole.bag')
        for box, expected in zip(extremes, self.report(whole)['extremes']):
            self.assertEqual((box['min'], box['max']), (expected['min'], expected['max']))
        self.check_refused('second.bag has no message on /tf_static', first, '--urdf', self.urdf,
                           '--static-from', second)

    def test_remapped_topics(self):
        messages = [('/r1' + topic, message, time) for topic, message, time in arms(COUNT)]
        bag = self.bag(messages)
        code, _, err = run(bag, '--urdf', self.urdf)
        self.assertEqual(code, 1)
        self.assertRegex(err, 'error: there is no message on /tf or /tf_static; the bags have '
                         'transforms on /r1/tf, too; add --tf-topic /r1/tf\n')
        found = self.report(bag, '--tf-topic', 'r1/tf')
        self.assertEqual(found, self.report(self.bag(arms(COUNT), 'plain.bag')))
        other = TFMessage([transform('base', 'x', time_of(BEGIN))])
        both = self.bag(messages + [('/tf', other, time_of(BEGIN))], 'both.bag')
        found = self.report(both, code=INCOMPLETE, err='incomplete names: 4')
        self.assertIn('add --tf-topic /r1/tf', found['incomplete']['left'])

    def test_boxes_that_came_late(self):
        """The robot's place in the world is known after a third of the time."""
        late = prefixed(arms(300), 'a/')
        link = transform('base', 'a/base', time_of(0))
        late.insert(100, ('/tf_static', TFMessage([link]), time_of(BEGIN + seconds(100))))
        bag = self.bag(late)
        arguments = ('--tf-prefix', 'a', '--fixed-frame', 'base')
        found = self.report(bag, *arguments, code=INCOMPLETE, err='incomplete names')
        self.assertAlmostEqual(self.coverage(found)['left'], 2 / 3, delta=0.02)
        self.assertRegex(found['incomplete']['left'],
                         r'had a box in 0\.6\d* of its time, less than 0\.99\d* of --min-coverage: no')
        self.report(bag, *arguments, '--min-coverage', '0.6')
        self.report(bag, *arguments, '--min-coverage', '0.7', code=INCOMPLETE, err='incomplete')

    def test_a_static_transform_that_came_late(self):
        """The mast was there before."""
        messages = arms(COUNT)[1:]
        messages.insert(100, static_arms(BEGIN + seconds(100)))
        bag = self.bag(messages)
        found = self.report(bag, code=INCOMPLETE, err='incomplete names')
        self.assertAlmostEqual(self.coverage(found)['mast'], 1 / 3, delta=0.02)
        self.assertIn('add --static-from ' + bag, found['incomplete']['mast'])
        found = self.report(bag, '--static-from', bag)
        self.assertEqual(self.coverage(found)['mast'], 1)

    def test_a_first_box_that_comes_later_than_tf_remembers(self):
        """Whatever the coverage: nobody looked at what moved beside it before."""
        for late, code in (8, 0), (12, INCOMPLETE):
            with self.subTest(seconds=late):
                messages = arms(round(14 / PERIOD))[1:]
                place = round(late / PERIOD)
                messages.insert(place, static_arms(BEGIN + seconds(place)))
                found = self.report(self.bag(messages), '--min-coverage', '0.01', code=code,
                                    err='incomplete names: 1' if code else '')
                self.assertEqual(list(found['incomplete']), ['mast'] if code else [])
                for reason in found['incomplete'].values():
                    self.assertRegex(reason, '^had its first box 1[12][.].* s after its transforms '
                                     'began, .*: how it moved before is not known: ')

    def test_links_whose_transforms_begin_late(self):
        """Nothing is forgotten of them, also where their frames are known as parents before."""
        messages = [(topic, message, time_of(BEGIN - 12)) for topic, message, _ in [static_arms()]]
        messages += arms(100)[1:]
        tip = TFMessage([transform('left_tip', 'bare', time_of(0))])
        found = self.report(self.bag([('/tf_static', tip, time_of(BEGIN - 12))] + messages),
                            '--min-coverage', '0.01')
        self.assertEqual(found['incomplete'], {})

    def test_a_first_box_after_a_jump_that_comes_later_than_tf_remembers(self):
        """The arm of the tip is known at the jump, and then only so late."""
        arm, tip = ('left',), ('right', 'left_tip')
        before = [moving_arms(i, links=links) for i in range(200) for links in (arm, tip)]
        for late, code in (8, 0), (12, INCOMPLETE):
            with self.subTest(seconds=late):
                after = [moving_arms(i, links=links) for i in range(0, round(14 / PERIOD), 5)
                         for links in (arm, tip)
                         if (i > 0 if links == tip else i == 0 or i * PERIOD >= late)]
                messages = [static_arms()] + before + after
                found = self.report(self.bag(messages), '--min-coverage', '0.01', '--timeout', '0',
                                    code=code, err='incomplete names: 1' if code else 'the clock jumped')
                self.assertEqual(list(found['incomplete']), ['left_tip'] if code else [])

    def test_a_static_transform_on_a_frame_that_starts_later(self):
        """Such as that of an arm that boots while its base drives."""
        links = ''.join('<link name="%s"><visual><geometry><box size="1 1 1"/></geometry></visual></link>'
                        % name for name in ('base', 'arm', 'tip'))
        joints = ''.join('<joint name="j_%s" type="%s"><parent link="%s"/><child link="%s"/></joint>'
                         % (child, kind, parent, child) for parent, child, kind in
                         (('base', 'arm', 'continuous'), ('arm', 'tip', 'fixed')))
        self.urdf = self.write('boot.urdf', '<robot name="r">%s%s</robot>' % (links, joints))

        def message(topic, i, parent, child):
            stamp = time_of(BEGIN + seconds(i))
            return topic, TFMessage([transform(parent, child, stamp)]), stamp
        messages = [message('/tf', i, 'map', 'base') for i in range(200)]
        messages += [message('/tf_static', 100, 'arm', 'tip')]
        messages += [message('/tf', i, 'base', 'arm') for i in range(100, 200)]
        found = self.report(self.bag(sorted(messages, key=lambda one: one[2])))
        self.assertEqual(self.coverage(found), {'base': 1, 'arm': 1, 'tip': 1})

    def test_a_short_gap_is_covered_but_a_lost_link_is_not(self):
        """Two seconds until a box is stale, then one without, of a hundred."""
        gap = [moving_arms(i, links=('left', 'left_tip')) for i in range(5000) if not 100 < i < 225]
        right = [moving_arms(i, links=('right',)) for i in range(5000)]
        messages = [static_arms()] + sorted(gap + right, key=lambda message: message[2])
        found = self.report(self.bag(messages))
        self.assertEqual(found['incomplete'], {})
        self.assertTrue(0.99 < self.coverage(found)['left'] < 1)
        self.report(self.bag(messages), '--min-coverage', '1', code=INCOMPLETE, err='names: 2')
        lost = [(topic, message, time) for topic, message, time in messages
                if time < time_of(BEGIN + 90) or message.transforms[0].child_frame_id == 'right']
        found = self.report(self.bag(lost), code=INCOMPLETE, err='names: 2')
        self.assertRegex(found['incomplete']['left'], 'had no box 2 times')


def center(box):
    return [(box[k] + box[k + 3]) / 2 for k in range(3)]


class MomentsTest(BagBoundsTest):
    """Boxes at one time, and how fast they move."""

    def test_speeds_of_centers(self):
        bag = self.bag(arms(COUNT))
        series = self.path('series.csv')
        found = {box['name']: box for box in self.report(bag, '--series', series)['extremes']}
        centers = [center(arm_bounds('left_tip', degrees_at(i))) for i in range(COUNT)]
        speeds = [math.dist(a, b) / PERIOD for a, b in zip(centers, centers[1:])]
        speed = found['left_tip']['max_speed']
        self.assertAlmostEqual(speed['value'], max(speeds), delta=1e-6)
        self.assertAlmostEqual(speeds[round(speed['time'] / PERIOD) - 1], max(speeds), delta=1e-6)
        self.assertNotIn('max_speed', found['mast'])
        with open(series, encoding='utf-8') as file:
            rows = [row for row in csv.DictReader(file) if row['name'] == 'left_tip']
        self.assertEqual(rows[0]['speed'], '')
        for row, expected in zip(rows[1:], speeds):
            self.assertAlmostEqual(float(row['speed']), expected, delta=1e-6)
        self.assertRegex(run(bag, '--urdf', self.urdf)[1], r'max speed \[m/s\] +at\n')

    def test_a_gap_is_no_speed(self):
        """The box is lost meanwhile, or a new one after a jump of the clock."""
        bag = self.bag([static_arms()] + [moving_arms(i, angle_index=a)
                                          for i, a in ((0, 0), (200, 100), (201, 100))])
        found = self.report(bag, '--allow-incomplete')
        tip = next(box for box in found['extremes'] if box['name'] == 'left_tip')
        self.assertEqual(tip['max_speed']['value'], 0)

    def test_all_boxes_at_a_time_between_two_messages(self):
        bag = self.bag(arms(COUNT))
        found = self.report(bag, '--at', '0.51')['boxes']
        self.assertEqual([box['name'] for box in found], ALL)
        degrees = (degrees_at(25) + degrees_at(26)) / 2
        for box in found:
            for value, expected in zip(box['min'] + box['max'], arm_bounds(box['name'], degrees)):
                self.assertAlmostEqual(value, expected, delta=1e-9)
            self.assertAlmostEqual(box['stamp'], 0 if box['name'] in ('base', 'mast')
                                   else BEGIN + 0.51, delta=1e-9)
        self.assertRegex(run(bag, '--urdf', self.urdf, '--at', '0.51')[1], 'box at 0.51.* +min x')
        rows = run(bag, '--urdf', self.urdf, '--at', '0.51', '--format', 'csv')[1]
        self.assertRegex(rows, r'(?m)^at_max_x,left,,[\d.]+,0\.51\d*,1000\.51\d*$')

    def test_a_time_that_is_no_sum_of_powers_of_two(self):
        """A message at 1.001 s belongs to a report that ends there."""
        messages = [static_arms()] + [moving_arms(t / PERIOD) for t in (1, 1.001)]
        found = self.report(self.bag(messages), '--end', '1.001', '--at', '1.001')
        self.assertEqual((found['messages'], found['to']), (3, 1.001))
        self.assertEqual(found['boxes'][2]['time'], 1.001)

    def test_boxes_that_are_not_known_then_are_incomplete(self):
        bag = self.bag([static_arms()] + [moving_arms(i, links=('right',)) for i in range(5)] +
                       [moving_arms(i) for i in range(5, 9)])
        found = self.report(bag, '--at', '0.03', code=INCOMPLETE, err='incomplete names: 2')
        self.assertEqual([box['name'] for box in found['boxes'] if 'min' in box],
                         ['base', 'mast', 'right'])
        self.assertIn('no box at', found['incomplete']['left'])
        found = self.report(bag, '--at', '60', code=INCOMPLETE, err='incomplete names: 1')
        self.assertIn('the report ends before', found['incomplete']['--at'])

    def test_a_name_is_incomplete_for_two_reasons(self):
        right = [moving_arms(i, links=('right',)) for i in range(250, 600)]
        found = self.report(self.bag(arms(250) + right), '--at', '8', code=INCOMPLETE,
                            err='incomplete names: 2')
        self.assertRegex(found['incomplete']['left'], 'had no box 1 time, .*; no box at ')

    def test_a_time_in_a_long_pause(self):
        """What does not move has a box there."""
        hour = 3600
        bag = self.bag(arms(3) + [moving_arms(hour / PERIOD)])
        for at in (1800, 1811.7, 1823.4, 1835.1):
            found = self.report(bag, '--at', str(at), code=INCOMPLETE, err='incomplete names: 3')
            self.assertEqual([box['name'] for box in found['boxes'] if 'min' in box],
                             ['base', 'mast'])
            self.assertIn('no box at', found['incomplete']['left'])


class DistancesTest(BagBoundsTest):
    def test_the_nearest_pair_and_its_time(self):
        bag = self.bag(arms(COUNT))
        pairs = self.report(bag, '--distances', '0.3', code=UNDERCUT)['distances']
        pair = next(p for p in pairs if (p['first'], p['second']) == ('left', 'right'))
        gaps = {i: arm_bounds('left', degrees_at(i))[1] - arm_bounds('right', degrees_at(i))[4]
                for i in range(COUNT)}
        self.assertAlmostEqual(pair['distance'], min(gaps.values()), delta=1e-4)
        self.assertLessEqual(pair['distance'], min(gaps.values()) + 1e-12)
        self.assertAlmostEqual(gaps[round(pair['time'] / PERIOD)], min(gaps.values()), delta=1e-4)

    def test_parameters_of_the_node(self):
        bag = self.bag(arms(10) + [moving_arms(210)])
        self.assertEqual(self.report(bag, '--timeout', '0')['incomplete'], {})
        bag = self.bag(arms(COUNT))
        padded, plain = (self.report(bag, *arguments)['extremes'][0]
                         for arguments in (('--padding', '0.25'), ()))
        self.assertAlmostEqual(padded['max'][0] - plain['max'][0], 0.25, delta=1e-12)
        for ignored, is_there in (('left r*t', False), ('left base', True)):
            pairs = self.report(bag, '--distances', '0.3', '--ignore-pairs', ignored,
                                code=UNDERCUT)['distances']
            names = [(pair['first'], pair['second']) for pair in pairs]
            self.assertEqual(('left', 'right') in names, is_there)

    def test_far_pairs(self):
        bag = self.bag(arms(COUNT))
        self.assertEqual(self.report(bag, '--distances', '0.05')['distances'], [])
        code, out, _ = run(bag, '--urdf', self.urdf, '--distances', '0.05')
        self.assertEqual(code, 0)
        self.assertIn('(no pair was ever within 0.050000 m)', out)


if __name__ == '__main__':
    main()
