#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Who was in which zone of a bag, and how near the nearest link came.

Run as: zones_test.py PATH_OF_bag_bounds
"""
import itertools

from bag_bounds_testing import (BEGIN, COUNT, ENTERED, INCOMPLETE, PERIOD, BagBoundsTest, arms,
                                degrees_at, main, moving_arms, seconds, static_arms, time_of,
                                zone_text)
from node_testing import ALL, SIZES, arm_bounds, joint_pose
from visualization_msgs.msg import MarkerArray

GOOD = 'min: [0, 0, 0], max: [1, 1, 1]'
REFUSED = [('', 'zones.yaml has no zones'),
           ('just text', 'has no zones'),
           ('a: {min: [0', 'zones.yaml is no YAML'),
           ('a: {%s}\na: {%s}' % (GOOD, GOOD), 'zone "a": there are two'),
           ('a: {%s}\n---\nb: {%s}' % (GOOD, GOOD), 'has 2 documents of YAML'),
           ('a: {%s, min: [5, 5, 5]}' % GOOD, 'zone "a": "min" is there twice'),
           ('- {%s}' % GOOD, 'entry 1 of the list has no name'),
           ('a: 3', 'zone "a": it has no fields'),
           ('a: {min: [0, 0, 0]}', 'zone "a": max must be three numbers'),
           ('a: {min: [0, 0], max: [1, 1, 1]}', 'zone "a": min must be three numbers'),
           ('a: {min: [0, 0, .nan], max: [1, 1, 1]}', 'zone "a": min .* is ".nan"'),
           ('a: {min: [0, 0, 1e999], max: [1, 1, 1]}', 'zone "a": min .* is "1e999"'),
           ('a: {min: [0, 2, 0], max: [1, 1, 1]}', 'zone "a": min is above max in y'),
           ('a: {frame: "", %s}' % GOOD, 'zone "a": frame is no name'),
           ('a: {farme: x, %s}' % GOOD, 'zone "a": there is no field "farme"')]


def gap(box, low, high):
    """What signedDistance says of two boxes."""
    gaps = [max(low[k] - box[k + 3], box[k] - high[k]) for k in range(3)]
    return max(gaps) if max(gaps) <= 0 else sum(max(g, 0) ** 2 for g in gaps) ** 0.5


def moving_transform(parent, child, index, x=0):
    """A message whose transform turns the child by half a turn."""
    topic, message, time = moving_arms(index, links=('left',))
    transform = message.transforms[0]
    transform.header.frame_id, transform.child_frame_id = parent, child
    transform.transform.translation.x = x
    transform.transform.rotation.z, transform.transform.rotation.w = 0, 1
    return topic, message, time


class ZonesTest(BagBoundsTest):
    def zones(self, text, messages, code=ENTERED, **options):
        arguments = ('--zones', self.write('zones.yaml', text))
        found = self.report(self.bag(messages), *arguments, code=code, **options)
        return {zone['name']: zone for zone in found['zones']}

    def check_stays(self, zone, name, gaps):
        """The stays of a link are the runs of messages whose gap is not positive."""
        runs = []
        for is_inside, run in itertools.groupby(range(len(gaps)), lambda i: gaps[i] <= 0):
            indices = list(run)
            if is_inside:
                end = min(indices[-1] + 1, len(gaps) - 1)
                runs.append((seconds(indices[0]), seconds(end)))
        found = [(stay['entered']['time'], stay['end']['time'])
                 for stay in zone['stays'] if stay['name'] == name]
        self.assertEqual(found, runs)
        self.assertGreater(len(runs), 0)

    def test_entries_and_exits(self):
        low, high = [0.6, 0.45, -1], [1, 1, 1]
        zone = self.zones(zone_text('door', low, high), arms(COUNT))['door']
        for name in ('left', 'left_tip'):
            self.check_stays(zone, name, [gap(arm_bounds(name, degrees_at(i)), low, high)
                                          for i in range(COUNT)])
        self.assertEqual(zone['entries'], len(zone['stays']))
        self.assertEqual({stay['how'] for stay in zone['stays']}, {'left'})

    def test_the_nearest_distance(self):
        low, high = [0, 2, 0], [1, 3, 1]
        zone = self.zones(zone_text('far', low, high), arms(COUNT), code=0)['far']
        self.assertEqual((zone['entries'], zone['stays']), (0, []))
        distances = {(name, seconds(i)): gap(arm_bounds(name, degrees_at(i)), low, high)
                     for name in ALL for i in range(COUNT)}
        nearest = zone['nearest']
        self.assertAlmostEqual(nearest['distance'], min(distances.values()), delta=1e-12)
        key = (nearest['name'], round(nearest['time'], 9))
        self.assertAlmostEqual(distances[key], nearest['distance'], delta=1e-12)

    def test_a_zone_that_moves_with_a_frame(self):
        """The boxes have the axes of that frame, so they are not boxes of boxes."""
        low, high = [-0.5, -0.7, -0.5], [0.5, -0.6, 0.5]

        def right_in_left_tip(index):
            degrees = degrees_at(index)
            tip = joint_pose('left', degrees) * joint_pose('left_tip', degrees)
            pose = tip.inverse() * joint_pose('right', degrees)
            return pose.box_bounds(SIZES['right'])
        found = self.zones(zone_text('hand', low, high, 'left_tip'), arms(COUNT))['hand']
        self.check_stays(found, 'right',
                         [gap(right_in_left_tip(i), low, high) for i in range(COUNT)])
        self.assertEqual(found['frame'], 'left_tip')

    def test_the_zone_moves_while_the_robot_stands(self):
        """In its fixed frame, base, nothing of the robot changes."""
        world = [moving_transform('world', 'base', i, x) for i, x in enumerate((5, 0, 5))]
        text = zone_text('cell', [-1, -1, -1], [0.1, 1, 1], 'world')
        zone = self.zones(text, [static_arms()] + world)['cell']
        stays = [(stay['name'], stay['entered']['time'], stay['end']['time'])
                 for stay in zone['stays']]
        self.assertEqual(stays, [(name, PERIOD, 2 * PERIOD) for name in ('base', 'mast')])

    def test_a_box_that_is_lost_ends_the_stay(self):
        text = zone_text('all', [-9] * 3, [9] * 3)
        zone = self.zones(text, arms(10) + [moving_arms(300)])['all']
        stays = [stay for stay in zone['stays'] if stay['name'] == 'left']
        self.assertEqual([stay['how'] for stay in stays], ['lost', 'report_ended'])
        self.assertAlmostEqual(stays[0]['end']['time'], seconds(9) + 2, delta=0.11)
        self.assertEqual(stays[1]['entered']['time'], seconds(300))

    def test_a_clock_that_jumps_back_ends_the_stay(self):
        text = zone_text('all', [-9] * 3, [9] * 3)
        zone = self.zones(text, arms(20) + [moving_arms(i) for i in range(20)],
                          err='warning: the clock jumped back')['all']
        self.assertEqual([stay['how'] for stay in zone['stays'] if stay['name'] == 'left'],
                         ['lost', 'report_ended'])
        self.assertEqual([stay['how'] for stay in zone['stays'] if stay['name'] == 'base'],
                         ['report_ended'])

    def test_a_jump_ends_the_stay_in_a_zone_that_moves(self):
        """In the fixed frame nothing changes: the transforms of base and mast are static."""
        cart = [moving_transform('base', 'cart', i) for i in range(20)]
        text = zone_text('cell', [-1, -1, -1], [0.1, 1, 1], 'cart')
        zone = self.zones(text, [static_arms()] + cart * 2, err='the clock jumped back')['cell']
        for name in ('base', 'mast'):
            self.assertEqual([stay['how'] for stay in zone['stays'] if stay['name'] == name],
                             ['lost', 'report_ended'])

    def test_stays_have_a_limit(self):
        """An arm at the edge of a zone: further entries are counted."""
        swing = [moving_arms(index, angle_index=50 + index % 2) for index in range(2401)]
        edge = sum(arm_bounds('left', degrees_at(i))[4] for i in (50, 51)) / 2
        text = zone_text('edge', [-9, edge, -0.05], [0.5, 9, 0.05])
        zone = self.zones(text, [static_arms()] + swing)['edge']
        self.assertEqual(len(zone['stays']), 1000)
        self.assertIn(zone['entries'], (1200, 1201))

    def test_refused_zones(self):
        bag = self.bag(arms(1))
        for text, reason in REFUSED:
            with self.subTest(text):
                zones = self.write('zones.yaml', text)
                self.check_refused(reason, bag, '--urdf', self.urdf, '--zones', zones)

    def test_a_frame_that_tf_does_not_connect(self):
        """Otherwise a misspelt frame would look like a zone that nobody enters."""
        zones = self.write('zones.yaml', zone_text('cell', [0, 0, 0], [1, 1, 1], 'wrold'))
        self.report(self.bag(arms(5)), '--zones', zones, code=1,
                    err='error: zone "cell" was never compared .* "wrold"')

    def test_a_frame_that_tf_connects_for_a_part_of_the_time(self):
        """Who was in the zone at other times is not known: silence is no answer. After the last
        transform the frame is known for the timeout of 1 s."""
        path = self.write('zones.yaml', zone_text('cell', [4, 4, 4], [5, 5, 5], 'cart'))
        end = PERIOD * (COUNT - 1)
        for sent, share in ((range(COUNT), 1), (range(50), (50 * PERIOD + 1) / end),
                            (range(1), 1 / end), (range(COUNT - 10, COUNT), 10 * PERIOD / end)):
            cart = [moving_transform('base', 'cart', i) for i in sent]
            bag = self.bag(sorted(arms(COUNT) + cart, key=lambda message: message[2]))
            is_whole = share == 1
            found = self.report(bag, '--zones', path, '--timeout', '1',
                                code=0 if is_whole else INCOMPLETE,
                                err='' if is_whole else 'incomplete names: 1')
            self.assertAlmostEqual(found['zones'][0]['coverage'], share, delta=0.05)
            self.assertEqual(list(found['incomplete']), [] if is_whole else ['zone cell'])
            is_lost = sent[-1] < COUNT - 1  # at the end: whatever the share
            found = self.report(bag, '--zones', path, '--timeout', '1', '--min-coverage', '0.01',
                                code=INCOMPLETE if is_lost else 0,
                                err='incomplete names: 1' if is_lost else '')
            self.assertEqual(list(found['incomplete']), ['zone cell'] if is_lost else [])
            self.assertEqual('not at the end' in str(found['incomplete']), is_lost)

    def test_a_frame_that_is_connected_later_than_tf_remembers(self):
        """Nobody looked at who was in the zone before."""
        path = self.write('zones.yaml', zone_text('cell', [4, 4, 4], [5, 5, 5], 'cart'))
        count = round(14 / PERIOD)
        for late, code in (8, 0), (12, INCOMPLETE):
            with self.subTest(seconds=late):
                link = moving_transform('base', 'track', 0)[1]
                messages = [('/tf_static', link, time_of(BEGIN + late)), *arms(count),
                            *(moving_transform('track', 'cart', i) for i in range(0, count, 5))]
                bag = self.bag(sorted(messages, key=lambda message: message[2]))
                found = self.report(bag, '--zones', path, '--min-coverage', '0.01', code=code,
                                    err='incomplete names: 1' if code else '')
                self.assertEqual(list(found['incomplete']), ['zone cell'] if code else [])
                self.assertEqual('tf had forgotten' in str(found['incomplete']), code != 0)
        late = [moving_transform('base', 'cart', i) for i in range(round(12 / PERIOD), count)]
        bag = self.bag(sorted(arms(count) + late, key=lambda message: message[2]))
        self.report(bag, '--zones', path, '--min-coverage', '0.01')  # it begins then

    def test_a_frame_that_ends_while_all_else_stands(self):
        """No transform tells that its timeout of 1 s is over."""
        path = self.write('zones.yaml', zone_text('cell', [4, 4, 4], [5, 5, 5], 'cart'))
        cart = [moving_transform('base', 'cart', i) for i in range(50)]
        last = '/objects', MarkerArray(), time_of(BEGIN + 3)
        found = self.report(self.bag([static_arms(), *cart, last]), '--objects', '/objects',
                            '--zones', path, '--timeout', '1', code=INCOMPLETE,
                            err='incomplete names')
        self.assertAlmostEqual(found['zones'][0]['coverage'], (50 * PERIOD + 1) / 3, delta=0.05)
        self.assertIn('zone cell', found['incomplete'])

    def test_a_list_of_zones(self):
        corners = 'min: [8, 8, 8], max: [9, 9, 9]'
        text = '- {name: a, %s}\n- {name: b, %s}' % (corners, corners)
        self.assertEqual(list(self.zones(text, arms(2), code=0)), ['a', 'b'])


if __name__ == '__main__':
    main()
