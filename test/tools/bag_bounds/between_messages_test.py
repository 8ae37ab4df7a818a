#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What happens between two messages of a bag: as in a bag with all poses between them.

Run as: between_messages_test.py PATH_OF_bag_bounds
"""
import json
import math
import random

import rosbag
from bag_bounds_testing import (BEGIN, ENTERED, INCOMPLETE, UNDERCUT, BagBoundsTest, main, run,
                                static_arms, time_of, zone_text)
from bounds_testing import Pose, transform, turn
from node_testing import DYNAMIC, arm_transform
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker

HAND = '''<robot name="arm"><link name="base"/><link name="hand"><visual><origin xyz="1 0 0"/>
<geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
<joint name="turn" type="continuous"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
</joint></robot>'''
LINKS = tuple(DYNAMIC)
DENSE = 0.002  # s
ACCURACY = 1e-3  # m, of what is proven


def message(stamp, degrees):
    """Of some links; recorded at its stamp."""
    transforms = [arm_transform(link, time_of(BEGIN + stamp), angle)
                  for link, angle in degrees.items()]
    return '/tf', TFMessage(transforms), time_of(BEGIN + stamp)


def swing(hertz, speed=2.0, seconds=1.2, jump=None, begin=BEGIN, gap=3):
    """Messages of a hand that turns with a constant speed [rad/s] around the base. After `jump`,
    their stamps are later by `gap`."""
    messages = []
    for i in range(round(seconds * hertz) + 1):
        angle = speed * (i / hertz - 0.5)
        stamp = time_of(begin + i / hertz + (gap if jump is not None and i / hertz > jump else 0))
        pose = Pose((0, 0, 0), turn((0, 0, 1), math.degrees(angle)))
        edge = transform('base', 'hand', stamp, pose.xyz, pose.xyzw)
        messages.append(('/tf', TFMessage([edge]), stamp or time_of(1e-9)))
    return messages


def marker(x, y, size, frame='base', stamp=None):
    """A cube that stands. With a stamp, it waits for tf of that time."""
    cube = Marker(ns='post', type=Marker.CUBE)
    cube.header.frame_id = frame
    cube.header.stamp = time_of(0 if stamp is None else BEGIN + stamp)
    cube.pose.position.x, cube.pose.position.y = x, y
    cube.pose.orientation.w = 1
    cube.scale.x = cube.scale.y = cube.scale.z = size
    return '/objects', cube, time_of(BEGIN)


def gone_post(deleted):
    return '/objects', Marker(ns='post', action=Marker.DELETE), time_of(BEGIN + deleted)


class RandomArms:
    """Each link has messages of its own at a low rate; between them angles change evenly."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.seconds = 2.0
        self.samples = {}
        for link in LINKS:
            stamps = [0.0]
            while stamps[-1] < self.seconds:
                stamps.append(round(stamps[-1] + self.random.uniform(0.1, 0.4), 3))
            angle = self.random.uniform(-60, 60)
            self.samples[link] = []
            for stamp in stamps:
                self.samples[link].append((stamp, angle))
                angle += self.random.uniform(-40, 40)

    def angle(self, link, stamp):
        for (begin, first), (end, last) in zip(self.samples[link], self.samples[link][1:]):
            if begin <= stamp <= end:
                return first + (last - first) * (stamp - begin) / (end - begin)
        return self.samples[link][-1][1]

    def sparse(self):
        messages = [message(stamp, {link: angle})
                    for link in LINKS for stamp, angle in self.samples[link]]
        return [static_arms()] + sorted(messages, key=lambda m: m[2])

    def dense(self):
        """As long as all links are known."""
        end = min(samples[-1][0] for samples in self.samples.values())
        stamps = {i * DENSE for i in range(int(end / DENSE) + 1)}
        stamps |= {stamp for samples in self.samples.values() for stamp, _ in samples
                   if stamp <= end}
        return [static_arms()] + [message(stamp, {link: self.angle(link, stamp) for link in LINKS})
                                  for stamp in sorted(stamps)]


class PostTest(BagBoundsTest):
    """At 2 rad/s and 5 Hz a hand at 1 m passes the post at 0.5 s, between two messages."""

    POST = zone_text('post', [0.95, -0.03, -1], [1, 0.03, 1])

    def setUp(self):
        super().setUp()
        self.urdf = self.write('arm.urdf', HAND)

    def zone(self, messages, *arguments, text=POST, **options):
        path = self.write('zones.yaml', text)
        return self.report(self.bag(messages), '--zones', path, *arguments, **options)['zones'][0]

    def test_a_post_is_found(self):
        zone = self.zone(swing(5), code=ENTERED)
        self.assertEqual((zone['entries'], zone['clearance'], zone['undecided']), (1, 0, 0))
        self.assertLess(zone['nearest']['distance'], 0)
        self.assertAlmostEqual(zone['nearest']['time'], 0.5, delta=0.1)
        stay, = zone['stays']
        truth, = self.zone(swing(5000), code=ENTERED)['stays']
        self.assertEqual((stay['name'], stay['how']), ('hand', 'left'))
        for end in ('entered', 'end'):
            self.assertLess(stay[end]['after'], stay[end]['stamp'])
            self.assertLess(stay[end]['stamp'] - stay[end]['after'], 2e-3)
            self.assertLessEqual(stay[end]['after'], truth[end]['stamp'])
            self.assertGreaterEqual(stay[end]['stamp'], truth[end]['stamp'] - 2e-4)

    def test_a_post_that_the_hand_passes_is_proven_free(self):
        """1 mm beside its way: closer than the box around its places at both messages."""
        zone = self.zone(swing(5), text=zone_text('post', [1.0515, -0.03, -1], [1.2, 0.03, 1]),
                         code=0)
        self.assertEqual((zone['entries'], zone['undecided']), (0, 0))
        self.assertTrue(0 < zone['clearance'] <= 1.5e-3, zone['clearance'])

    def test_a_zone_that_moves_with_the_hand(self):
        """The marker passes it; in the hand's frame it is the marker that moves."""
        zone = self.zone([marker(1, 0, 0.05)] + swing(5), '--objects', '/objects',
                         text=zone_text('grip', [0.95, -0.03, -1], [1.05, 0.03, 1], 'hand'),
                         code=ENTERED)
        self.assertIn('post/0', {stay['name'] for stay in zone['stays']})

    def test_a_gap_is_a_motion(self):
        """Also where it is longer than timeout, whether or not the box was lost meanwhile. What is
        longer than tf remembers is undecided."""
        late = {gap: swing(5, jump=0.45, gap=gap) for gap in (1.9, 2.1, 3, 9, 60)}
        in_time = {gap: [(topic, transforms, time_of(BEGIN + i / 5)) for i, (topic, transforms, _)
                         in enumerate(messages)] for gap, messages in late.items()}
        cart = [('/tf', TFMessage([transform('base', 'cart', stamp)]), stamp)
                for stamp in (time_of(BEGIN + i / 5) for i in range(7))]
        post = marker(1, 0, .05, 'cart')
        for messages in late, in_time:
            for gap, steps in messages.items():
                code, err = (ENTERED, '') if gap < 10 else (INCOMPLETE, 'are not decided')
                with self.subTest(gap=gap, recorded='late' if messages is late else 'in time'):
                    found = self.zone(steps, code=code, err=err)
                    self.assertEqual((found['entries'], found['undecided'], found['clearance']),
                                     (gap < 10, gap > 10, 0))
                    self.report(self.bag([marker(1, 0, .05)] + steps), '--distances', '.01',
                                '--objects', '/objects', code=UNDERCUT if gap < 10 else code,
                                err=err)
        self.zone(swing(5), '--timeout', '.09', code=ENTERED)
        steps = sorted(cart + swing(5), key=lambda m: m[2])
        self.report(self.bag([post] + steps), '--distances', '.01', '--objects', '/objects',
                    '--timeout', '.09', code=UNDERCUT)

    def test_what_the_first_message_of_a_frame_has(self):
        """Several transforms, of which the newest one makes the first box."""
        edges = [edge for _, message, _ in swing(5) for edge in message.transforms]
        first = [('/tf', TFMessage(edges[:5]), time_of(BEGIN + .8))]
        still = [('/tf', TFMessage(edges[i:i + 1]), time_of(BEGIN + i / 5)) for i in (5, 6)]
        self.zone(first + still, code=ENTERED)
        for deleted in .45, .79, 3:
            messages = [marker(1, 0, .05)] + first + still + [gone_post(deleted)]
            bag = self.bag(sorted(messages, key=lambda m: m[2]))
            with self.subTest(deleted=deleted):
                self.report(bag, '--distances', '.01', '--objects', '/objects',
                            code=INCOMPLETE if deleted == .45 else UNDERCUT,
                            err='no two bodies were compared' if deleted == .45 else '')

    def test_an_object_that_is_deleted_while_its_frame_moves(self):
        """It stands there from its last message on, and moved before that."""
        self.plates('hand')
        hand = self.plate_messages(*[(i / 10, {'hand': -1 if i < 5 else 1}) for i in range(9)])
        for speed in 0, 1e-3, 1:
            cart = [('/tf', TFMessage([transform('base', 'cart', time_of(BEGIN + i / 50),
                                                 (speed * i / 50, 0, 0))]),
                     time_of(BEGIN + i / 50)) for i in range(40)]
            for deleted, code in (.445, 0), (.475, UNDERCUT), (.495, UNDERCUT):
                post = marker(-.02 - .46 * speed, 0, .02, 'cart')
                messages = sorted([post] + hand + cart + [gone_post(deleted)], key=lambda m: m[2])
                with self.subTest(speed=speed, deleted=deleted):
                    self.report(self.bag(messages), '--distances', '.001', '--objects', '/objects',
                                code=code)

    def test_a_motion_that_goes_on_at_the_start(self):
        """It counts for a report that begins within it, and not for one that ends there."""
        bag = self.bag([marker(1, 0, 0.05)] + swing(5))
        zones = self.write('zones.yaml', self.POST)
        for arguments in (('--zones', zones), ('--distances', '0.01', '--objects', '/objects')):
            for start, code in ((0.45, ENTERED), (0.57, ENTERED), (0.61, 0)):
                with self.subTest(arguments=arguments, start=start):
                    self.report(bag, *arguments, '--start', str(start), code=code)
            self.report(bag, *arguments, '--end', '0.57', code=0)

    def test_what_is_there_at_the_start(self):
        """Also where the report ends before the next message or tick."""
        place = zone_text('place', [0.9, -0.3, -1], [1, -0.1, 1])  # where the hand is at 0.4 s
        bag = self.bag(swing(5))
        found = self.report(bag, '--zones', self.write('zones.yaml', place), '--start', '0.57',
                            '--end', '0.58', code=ENTERED)
        self.assertEqual((found['from'], found['to']), (0.57, 0.57))
        stay, = found['zones'][0]['stays']
        self.assertEqual((stay['entered']['time'], stay['entered']['stamp']), (0.57, BEGIN + 0.4))

    def test_a_recorder_that_stalls(self):
        """For longer than `timeout`, so that the hand had no box. tf knows its whole way."""
        stall = time_of(BEGIN + 3)
        messages = [(topic, message, max(stamp, stall) if stamp > time_of(BEGIN + .45) else stamp)
                    for topic, message, stamp in swing(5)]
        self.zone(messages, code=ENTERED, text=self.POST)
        found = self.report(self.bag([marker(1, 0, 0.05)] + messages), '--distances', '0.01',
                            '--objects', '/objects', code=UNDERCUT)
        self.assertEqual(found['distances'][0]['clearance'], 0)

    def test_a_report_that_starts_while_the_recorder_stalls(self):
        """After `timeout`, when no link has a box. The motion becomes known in the report."""
        self.plates('slow', 'fast')
        steps = [(0, {'slow': 0, 'fast': -1}), (.1, {'slow': 0, 'fast': -1}),
                 (.3, {'slow': 0, 'fast': 1}, 4), (.5, {'slow': 0, 'fast': 1}, 4.1)]
        steps += [(4 + i / 2, {'slow': 0, 'fast': 1}) for i in range(1, 4)]
        bag = self.bag(self.plate_messages(*steps))
        for name, low, high in ('', -.3, -.2), ('slow', -.3, -.2), ('fast', .2, .3):
            zones = self.write('zones.yaml', zone_text('gate', [low, -1, -1], [high, 1, 1], name))
            for arguments in ('--zones', zones), ('--distances', '.01'):
                for start, code in (1, ENTERED), (3.5, ENTERED), (4.05, 0):
                    with self.subTest(arguments=arguments, start=start, frame=name):
                        self.report(bag, *arguments, '--start', str(start), '--min-coverage', '0',
                                    code=code)

    def test_who_is_inside_while_the_recorder_stalls(self):
        """Entered once more, but was not known outside before."""
        stall = time_of(BEGIN + 3)
        messages = [(topic, message, max(stamp, stall) if stamp > time_of(BEGIN + .45) else stamp)
                    for topic, message, stamp in swing(5, speed=0)]
        stays = self.zone(messages, text=self.POST, code=ENTERED)['stays']
        self.assertEqual([stay['how'] for stay in stays], ['lost', 'report_ended'])
        self.assertEqual([stay['entered'].get('after') for stay in stays], [None, None])

    def test_a_distance_is_undercut(self):
        for size, code in ((0.05, UNDERCUT), (0.002, UNDERCUT)):
            bag = self.bag([marker(1, 0, size)] + swing(5))
            pair, = self.report(bag, '--distances', '0.01', '--objects', '/objects',
                                code=code)['distances']
            self.assertEqual((pair['distance'], pair['clearance']), (0, 0))
            self.assertAlmostEqual(pair['time'], 0.5, delta=0.1)
        bag = self.bag([marker(1.1, 0, 0.05)] + swing(5))
        pair, = self.report(bag, '--distances', '0.03', '--objects', '/objects',
                            code=UNDERCUT)['distances']
        corner = 1.075 - math.hypot(1.05, 0.05)
        self.assertAlmostEqual(pair['distance'], corner, delta=1e-3)
        self.assertTrue(corner - 2e-3 <= pair['clearance'] <= corner)
        found = self.report(bag, '--distances', '0.02', '--objects', '/objects', code=0)
        self.assertEqual(found['distances'], [])

    def test_a_transform_that_is_too_far_away_for_squares_leaves_the_motion_open(self):
        for far in 1e100, 1e155, 1e300:
            messages = [('/tf', TFMessage([transform('base', 'hand', time_of(BEGIN + i), (x, 0, 0),
                                                     (0, 0, 0, 1))]), time_of(BEGIN + i))
                        for i, x in enumerate((-9, -9, far))]
            bag = self.bag([marker(0, 0, 0.1)] + messages)
            found = self.report(bag, '--distances', '0.01', '--objects', '/objects',
                                code=INCOMPLETE, err='not decided')
            self.assertEqual(found['open'], ['motions of pairs that are not decided: 1'])

    def test_a_dip_below_the_limit_is_found(self):
        """A corner 1 mm off its axis turns by 60 degrees before a plate. It is nearest in the
        middle, by 0.134 mm."""
        joint = ('<joint name="{1}_joint" type="continuous"><parent link="{0}"/><child link="{1}"/>'
                 '<axis xyz="0 0 1"/></joint>')
        text = ('<robot name="r"><link name="base"><visual><origin xyz="{:.5f} 0 0"/><geometry>'
                '<box size="1 1 1"/></geometry></visual></link><link name="mast"/><link name="nut">'
                '<visual><geometry><box size="0.00141421 0.00141421 1e-6"/></geometry></visual>'
                '</link>' + joint.format('base', 'mast') + joint.format('mast', 'nut') + '</robot>')
        turns = []
        for stamp, degrees in (BEGIN, 15), (BEGIN + .1, 75):
            edges = [transform(*names, time_of(stamp), (0, 0, 0), turn((0, 0, 1), angle))
                     for names, angle in ((('base', 'mast'), 0), (('mast', 'nut'), degrees))]
            turns.append(('/tf', TFMessage(edges), time_of(stamp)))
        bag = self.bag(turns)
        for limit, gap, code in ((1, .9, UNDERCUT), (50, 49.9, UNDERCUT), (1, 1.2, 0)):  # mm
            self.urdf = self.write('nut.urdf', text.format(.501 + gap / 1000))
            with self.subTest(limit=limit, gap=gap):
                self.report(bag, '--distances', str(limit / 1000), code=code)

    def test_a_long_timeout_is_no_short_one(self):
        """Beyond what fits into nanoseconds."""
        self.zone(swing(5), '--timeout', '1e10', code=ENTERED)

    def plates(self, *names):
        """Two plates that move along x."""
        plate = '<geometry><box size="0.01 1 1"/></geometry>'
        text = ('<link name="{0}"><visual>%s</visual></link>'
                '<joint name="j_{0}" type="prismatic"><parent link="base"/><child link="{0}"/>'
                '<axis xyz="1 0 0"/><limit lower="-9" upper="9" effort="1" velocity="9"/></joint>'
                % plate)
        self.urdf = self.write('plates.urdf', '<robot name="r"><link name="base"/>%s</robot>' %
                               ''.join(text.format(name) for name in names))

    @staticmethod
    def plate_messages(*steps):
        """Of stamps, and where which plate is then. A third number is a record time."""
        messages = []
        for stamp, places, *recorded in steps:
            recorded = time_of(BEGIN + (recorded or [stamp])[0])
            stamp = time_of(BEGIN + stamp)
            edges = [transform('base', child, stamp, (x, 0, 0)) for child, x in places.items()]
            messages.append(('/tf', TFMessage(edges), recorded or time_of(1e-9)))
        return messages

    def check_plates(self, *steps, others=(), arguments=(), code=UNDERCUT, err=''):
        messages = list(others) + self.plate_messages(*steps)
        pairs = self.report(self.bag(messages), '--distances', '0.01', *arguments,
                            code=code, err=err)['distances']
        found = [(pair['distance'], pair['clearance']) for pair in pairs]
        self.assertEqual(found, [(0, 0)] if code == UNDERCUT else [])
        return pairs

    def test_a_way_before_the_stamp_of_a_slower_body_counts(self):
        """One plate passes through the other between the messages of that one, and may go on with
        the second of these."""
        for names in ('slow', 'fast'), ('fast', 'slow'):
            self.plates(*names)
            for last in {'slow': 0}, {'slow': 0, 'fast': 1.5}:
                with self.subTest(names=names, last=last):
                    self.check_plates((0, {'slow': 0, 'fast': -1}), (.5, {'fast': 1}), (1, last))

    def test_a_way_beside_a_body_that_has_no_later_transform(self):
        """One plate passes through the place in which the other one was left."""
        begin = [(0, {'slow': 0, 'fast': -1}), (.1, {'fast': -1}), (.3, {'fast': 1})]
        later = [(i / 2, {'fast': 1}) for i in range(1, 12)]
        back = [(6, {'slow': 0, 'fast': 1}), (6.5, {'slow': 0, 'fast': 1})]
        for names in ('slow', 'fast'), ('fast', 'slow'):
            self.plates(*names)
            for name, steps, arguments in (
                    ('end', begin, ()),
                    ('--end', begin + [(1, {'slow': 0})], ('--end', '0.5')),
                    ('comes late', begin + later + back, ('--min-coverage', '0')),
                    ('never stale', begin + later, ('--timeout', '0')),
                    ('clock', begin + [(-9, {'slow': 0, 'fast': 1})], ())):
                with self.subTest(names=names, name=name):
                    pair, = self.check_plates(*steps, arguments=arguments,
                                              err='jumped back' if name == 'clock' else '')
                    self.assertAlmostEqual(pair['time'], .2, delta=.02)

    def test_a_long_pause_beside_a_body_that_is_never_stale(self):
        """tf forgets, so what moves beside it is looked at before."""
        self.plates('slow', 'fast')
        away = [(i / 2, {'fast': -1}) for i in range(1, 60)]
        for arguments in ('--timeout', '0'), ('--timeout', '30', '--end', '15'):
            for passes, code in (False, 0), (True, UNDERCUT):
                steps = [(0, {'slow': 0, 'fast': -1})] + away + [(30, {'fast': 1})]
                if passes:
                    steps.insert(20, (9.7, {'fast': 1}))
                if not passes:
                    steps.pop()
                with self.subTest(arguments=arguments, passes=passes):
                    self.check_plates(*steps, arguments=arguments, code=code)

    def test_a_resting_body_beside_links_of_different_stamps(self):
        """The slow one passes through it before the newest stamp of the fast one."""
        self.plates('slow', 'fast')
        post = marker(0, 0, .02)
        for passes, code in (.3, UNDERCUT), (-.3, 0):
            steps = [(.5, {'fast': 5}, 0), (0, {'slow': -.5}, .1), (.4, {'slow': passes}, .6)]
            with self.subTest(passes=passes):
                self.check_plates(*steps, others=[post], arguments=('--objects', '/objects'),
                                  code=code)

    def test_a_long_pause_beside_bodies_of_different_stamps(self):
        """One of them passes through the one that pauses, before the newest stamp of the other."""
        self.plates('pauses', 'behind', 'ahead')
        steps = [(0, {'pauses': 0, 'behind': -1, 'ahead': 5})]
        steps += [(i / 2, {'behind': -1, 'ahead': 5}) for i in range(1, 10)]
        steps += [(5.1, {'ahead': 5}), (5.2, {'ahead': 5}), (5, {'behind': 1}, 5.3)]
        steps += [(6, {'pauses': 0, 'behind': 1, 'ahead': 5})]
        self.check_plates(*steps, arguments=('--timeout', '0'))

    def test_a_long_motion_between_two_messages(self):
        """It is no rest, although the bodies beside it send meanwhile."""
        self.plates('slow', 'fast')
        for gap in 4, 6, 9:
            for last, code in (1, UNDERCUT), (-1, 0):
                steps = [(0, {'slow': -1}), (2, {'slow': -1}), (2 + gap, {'slow': last})]
                steps += [(2 + gap + i / 2, {'slow': last}) for i in range(1, 8)]
                for place, others in (0, []), (9, [marker(0, 0, .02)]):
                    fast = [(i / 10, {'fast': place}) for i in range(10 * gap + 50)]
                    messages = sorted(others + self.plate_messages(*steps, *fast),
                                      key=lambda message: message[2])
                    with self.subTest(gap=gap, last=last, place=place):
                        found = self.report(self.bag(messages), '--distances', '.01', '--objects',
                                            '/objects', '--timeout', '10', '--allow-incomplete',
                                            code=code, err='' if others else 'no message on')
                        self.assertEqual(len(found['distances']), code == UNDERCUT)

    def test_an_object_that_was_deleted_while_a_body_paused(self):
        """The slow one passed through it before, as its next transform shows."""
        self.plates('slow', 'fast')
        gone = Marker(ns='post', action=Marker.DELETE)
        for last, timeout, deleted, code in ((8, 0, 2, UNDERCUT), (8, 9, 2, UNDERCUT), (8, 0, .5, 0),
                                             (14, 0, 2, INCOMPLETE)):
            steps = [(0, {'slow': -1, 'fast': 50})]
            steps += [(i / 2, {'fast': 50}) for i in range(1, 2 * last)]
            messages = self.plate_messages(*steps, (last, {'slow': last - 1, 'fast': 50}))
            messages += [marker(0, 0, .02), ('/objects', gone, time_of(BEGIN + deleted))]
            messages.sort(key=lambda message: message[2])
            with self.subTest(last=last, timeout=timeout, deleted=deleted):
                self.report(self.bag(messages), '--distances', '.01', '--objects', '/objects',
                            '--timeout', str(timeout), '--ignore-pairs', 'slow fast', code=code,
                            err='' if code != INCOMPLETE else 'not decided, the first of slow and post')

    def check_gone(self, messages, *arguments, code=UNDERCUT, err=''):
        """With a post at 0."""
        messages = [marker(0, 0, .02)] + sorted(messages, key=lambda message: message[2])
        self.report(self.bag(messages), '--distances', '.01', '--objects', '/objects',
                    '--min-coverage', '0', *arguments, code=code, err=err)

    def test_an_object_that_was_deleted_while_tf_stalled(self):
        """All of it, for longer than it remembers; or that of one plate, for longer than the
        timeout."""
        self.plates('slow', 'fast')
        for fast_ends, timeout, deleted, burst in (1, 10, 13, 18.6), (7, 2, 4, 7.05):
            fast = [(i / 10, {'fast': 50}) for i in range(10 * fast_ends + 1)]
            fast.append((burst, {'fast': 50}, burst + .1))
            for meets, code in (deleted - 1, UNDERCUT), (deleted + 1, 0):
                slow = [(i / 10, {'slow': -1 if i / 10 < meets else 1},
                         i / 10 if i <= 10 else burst + i / 1e4) for i in range(round(10 * burst))]
                other = marker(30, 30, .02)[1]
                other.id = 1
                messages = self.plate_messages(*fast, *slow)
                messages += [gone_post(deleted),
                             ('/objects', other, time_of(BEGIN + burst - .05))]
                is_forgotten = burst - fast_ends > 10  # where the plate was meanwhile
                with self.subTest(timeout=timeout, meets=meets):
                    self.check_gone(messages, '--timeout', str(timeout), '--ignore-pairs',
                                    'slow fast', code=code or is_forgotten and INCOMPLETE,
                                    err='are not decided' if is_forgotten else '')

    def test_an_object_that_was_deleted_before_one_that_is_ignored(self):
        """What tf has forgotten is undecided, whichever object was deleted last."""
        self.plates('slow', 'fast')
        steps = [(0, {'slow': -1, 'fast': 50})] + [(i / 2, {'fast': 50}) for i in range(1, 60)]
        steps += [(30, {'slow': 1, 'fast': 50})]
        other = marker(30, 30, .02)[1]
        other.ns = 'other'
        gone = Marker(ns='other', action=Marker.DELETE)
        messages = self.plate_messages(*steps)
        messages += [gone_post(4), ('/objects', other, time_of(BEGIN)),
                     ('/objects', gone, time_of(BEGIN + 6))]
        for ignored, code in ([], INCOMPLETE), (['slow post/0'], 0):
            ignored = ['slow fast', 'slow other/0'] + ignored
            arguments = [word for pair in ignored for word in ('--ignore-pairs', pair)]
            with self.subTest(ignored=ignored):
                self.check_gone(messages, '--timeout', '0', *arguments, code=code,
                                err='first of slow and post/0' if code else '')

    def test_an_object_that_was_deleted_after_a_start_in_a_pause(self):
        """The report begins 5.5 s after the last transform: the clocks agree nevertheless."""
        self.plates('slow', 'fast')
        steps = [(i / 10, {'slow': -1, 'fast': 50}) for i in range(46)]
        steps += [(13, {'slow': 1, 'fast': 50}), (13.1, {'slow': 1, 'fast': 50})]
        for deleted, code in (12, UNDERCUT), (8, 0):
            with self.subTest(deleted=deleted):
                self.check_gone(self.plate_messages(*steps) + [gone_post(deleted)], '--timeout',
                                '0', '--start', '10', code=code)

    def test_an_object_that_is_deleted_where_the_clocks_differ(self):
        """Stamps are those of a simulation, or ahead of the recorder."""
        self.plates('slow', 'fast')
        gone = Marker(ns='post', action=Marker.DELETE)
        for ahead in -999, -900, .5, 3600:
            for deleted, code in (.15, 0), (.25, UNDERCUT):
                steps = [(i / 10 + ahead, {'slow': 5, 'fast': -1}, i / 10)
                         for i in range(2)]
                steps += [(.3 + i / 10 + ahead, {'slow': 5, 'fast': 1}, .3 + i / 10)
                          for i in range(70)]
                messages = self.plate_messages(*steps)
                messages += [marker(0, 0, .02), ('/objects', gone, time_of(BEGIN + deleted))]
                messages.sort(key=lambda message: message[2])
                with self.subTest(ahead=ahead, deleted=deleted):
                    self.report(self.bag(messages), '--distances', '.01', '--objects', '/objects',
                                code=code)

    def test_a_body_that_swings_away_and_back_while_its_own_transform_pauses(self):
        """Its place is the same before and after, but what carries it meets the other one."""
        self.plates('tool', 'fast')
        for place, last, code in (1, 8, UNDERCUT), (2, 8, 0), (1, 14, INCOMPLETE):
            steps = [(i / 2, {'cart': 1 if i == 4 else 0, 'fast': place}) for i in range(2 * last)]
            messages = self.plate_messages(*steps)
            for stamp in 0, last:
                edge = transform('cart', 'tool', time_of(BEGIN + stamp), (0, 0, 0))
                messages.append(('/tf', TFMessage([edge]), time_of(BEGIN + stamp)))
            messages += self.plate_messages((last, {'cart': 0, 'fast': place}))
            messages.sort(key=lambda message: message[2])
            with self.subTest(place=place, last=last):
                self.report(self.bag(messages), '--distances', '.01', '--timeout', '0', code=code,
                            err='not decided' if code == INCOMPLETE else '')

    def test_two_bodies_that_pause(self):
        """One of them passes through the other, as its next transform shows."""
        self.plates('rests', 'pauses', 'fast')
        for rests in [], [(9, {'rests': 0})], [(8, {'rests': 0})]:
            for last, code in (1, UNDERCUT), (-.5, 0):
                fast = [(i / 2, {'fast': 50}) for i in range(20)]
                steps = [(0, {'rests': 0, 'pauses': -1}), (8, {'pauses': last})]
                messages = sorted(self.plate_messages(*steps, *rests, *fast), key=lambda m: m[2])
                with self.subTest(rests=rests, last=last):
                    self.report(self.bag(messages), '--distances', '.01', '--timeout', '0',
                                code=code)

    def test_a_body_that_pauses_and_then_is_late(self):
        """The fast one passes through its new place, at a time that was looked at beside its old
        place."""
        self.plates('slow', 'fast')
        for passes, code in (9, UNDERCUT), (8, 0):
            fast = [(i / 2, {'fast': passes - 7 if i == 8 else -1}) for i in range(18)]
            slow = [(0, {'slow': 50}), (3, {'slow': 1.5}, 6), (8, {'slow': 1.5})]
            messages = sorted(self.plate_messages(*slow, *fast), key=lambda m: m[2])
            with self.subTest(passes=passes):
                self.report(self.bag(messages), '--distances', '.01', '--timeout', '0', code=code)

    def test_a_motion_of_which_tf_has_forgotten_the_other_body(self):
        """The slow one moves by 1 m. While tf forgets, the other one, which stood 4 cm beside its
        place, is far away."""
        self.plates('slow', 'fast')
        for recorded, last, code in (11, 46, INCOMPLETE), (9.9, 46, UNDERCUT), (9.9, 20, 0):
            slow = self.plate_messages((0, {'slow': 0}), (9.8, {'slow': 1}, recorded))
            fast = self.plate_messages(*[(i / 100, {'fast': .05})
                                         for i in range(round(100 * recorded) + 1)])
            for _, message, _ in fast[last + 1:]:
                message.transforms[0].transform.translation.y = 100
            messages = sorted(slow + fast, key=lambda m: m[2])
            with self.subTest(recorded=recorded, last=last):
                self.report(self.bag(messages), '--distances', '.01', '--timeout', '0', code=code,
                            err='not decided, .*tf knows frame "fast" only from'
                            if code == INCOMPLETE else '')

    def test_a_marker_that_is_placed_anew_after_a_jump_of_the_clock(self):
        """It is sent again unchanged. The plate passes through its new place before tf says where
        that is."""
        self.plates('slow', 'fast')
        gate = self.write('gate.yaml', zone_text('gate', [-.1, -1, -1], [.1, 1, 1], 'fast'))
        first = [(i / 10, {'slow': -20, 'fast': -1}) for i in range(50)]
        again = [(0, {'slow': 5, 'fast': -1}), (.1, {'slow': 5, 'fast': -1}), (.18, {'fast': -.2}),
                 (.22, {'fast': .2}), (.3, {'slow': 5, 'fast': 1})]
        for stamp, code in (.12, UNDERCUT), (.25, 0):
            topic, post, _ = marker(-5, 0, .02, 'slow', stamp)
            messages = []
            for steps in first, again:
                sent = (topic, post, time_of(BEGIN + .15))
                messages += sorted([sent] + self.plate_messages(*steps), key=lambda m: m[2])
            with self.subTest(stamp=stamp):
                bag = self.bag(messages)
                self.report(bag, '--distances', '.01', '--objects', '/objects', code=code,
                            err='jumped back')
                stays = self.report(bag, '--zones', gate, '--objects', '/objects', code=ENTERED,
                                    err='jumped back')['zones'][0]['stays']
                self.assertEqual('post/0' in {stay['name'] for stay in stays}, code != 0)

    def test_a_marker_that_waits_for_tf_is_there_since_its_stamp(self):
        """The plate passes through its place before tf says where that is."""
        self.plates('slow', 'fast')
        steps = [(0, {'slow': 5, 'fast': -1}), (.1, {'slow': 5, 'fast': -1}), (.18, {'fast': -.2}),
                 (.22, {'fast': .2}), (.3, {'slow': 5, 'fast': 1})]
        steps += [(i, {'slow': 5, 'fast': 1}) for i in range(1, 60)]
        gate = self.write('gate.yaml', zone_text('gate', [-.1, -1, -1], [.1, 1, 1], 'fast'))
        for stamp, code in (.12, UNDERCUT), (.25, 0):
            post = marker(-5, 0, .02, 'slow', stamp)
            with self.subTest(stamp=stamp):
                self.check_plates(*steps, others=[post], arguments=('--objects', '/objects'),
                                  code=code)
                zone = self.report(self.bag([post] + self.plate_messages(*steps)), '--zones', gate,
                                   '--objects', '/objects', code=ENTERED)['zones'][0]
                self.assertEqual('post/0' in {stay['name'] for stay in zone['stays']}, code != 0)

    def test_a_marker_with_a_stamp_that_tf_has_forgotten(self):
        """It is looked at for as long as tf remembers: up to 10 s."""
        self.plates('fast')
        gate = self.write('gate.yaml', zone_text('gate', [.9, -1, -1], [1.1, 1, 1], 'fast'))
        objects = ('--objects', '/objects')
        for place, code in (0, UNDERCUT), (-4, 0):
            steps = [(i / 10, {'fast': -1 if i < 60 else 1 - 2 * (i % 2)}) for i in range(151)]
            topic, post, _ = marker(place, 0, .02, 'base', -20)
            messages = self.plate_messages(*steps) + [(topic, post, time_of(BEGIN + 15.05))]
            messages += self.plate_messages((15.1, {'fast': 1}))
            with self.subTest(place=place):
                self.report(self.bag(messages), '--distances', '.01', *objects, code=code)
        steps = [(i / 10, {'fast': -1 if 80 < i < 90 else 3}) for i in range(151)]
        messages = self.plate_messages(*steps) + [(topic, post, time_of(BEGIN + 15.05))]
        post.pose.position.x = 0
        zone = self.report(self.bag(messages), '--zones', gate, *objects, code=ENTERED)['zones'][0]
        self.assertIn('post/0', {stay['name'] for stay in zone['stays']})

    def test_a_marker_that_comes_again_stands_between_its_stamps(self):
        """Each one waits for the transform that also moves the plate through its place."""
        self.plates('slow', 'fast')
        gate = self.write('gate.yaml', zone_text('gate', [-.1, -1, -1], [.1, 1, 1], 'fast'))
        messages = self.plate_messages(*[(i / 10, {'slow': 5, 'fast': -1 if i < 10 else 1})
                                         for i in range(20)])
        for delay in .02, .05, .08:
            for noise, place, count in (0, 0, 1), (1e-3, 0, 1), (0, 2, 0):
                stamps = [i / 10 + delay for i in range(1, 18)]
                posts = [marker(place - 5 + noise * (i % 3), 0, .02, 'slow', stamp)
                         for i, stamp in enumerate(stamps)]
                posts = [post[:2] + (time_of(BEGIN + stamp),) for post, stamp in zip(posts, stamps)]
                bag = self.bag(sorted(messages + posts, key=lambda message: message[2]))
                with self.subTest(delay=delay, noise=noise, place=place):
                    self.report(bag, '--distances', '.01', '--objects', '/objects',
                                code=UNDERCUT if count else 0)
                    stays = self.report(bag, '--zones', gate, '--objects', '/objects',
                                        code=ENTERED)['zones'][0]['stays']
                    self.assertEqual([stay['how'] for stay in stays if stay['name'] == 'post/0'],
                                     ['left'] * count)
                    for stay in stays[1:]:
                        self.assertAlmostEqual(stay['entered']['stamp'], BEGIN + .9445, delta=.002)
                        self.assertAlmostEqual(stay['entered']['time'], .9445, delta=.002)

    def test_a_marker_stands_until_the_stamp_of_a_new_one_that_is_ahead_of_the_zone(self):
        """The zone passes its place at 0.945 s. What comes after the new one does not matter."""
        self.plates('fast')
        gate = self.write('gate.yaml', zone_text('gate', [-.1, -1, -1], [.1, 1, 1], 'fast'))
        messages = self.plate_messages(*[(i / 10, {'fast': -1 if i < 10 else 1}) for i in range(20)])
        gone = Marker(ns='post', action=Marker.DELETE)
        for stamp, count in (.95, 1), (.94, 0), (1.35, 1):
            for others, deleted in ((), ()), ((stamp + .01, stamp + .02), ()), ((), (stamp + .01,)):
                posts = [(0, .1)] + [(5 + i, other) for i, other in enumerate((stamp,) + others)]
                posts = [marker(x, 0, .02, 'base', at)[:2] + (time_of(BEGIN + at),) for x, at in posts]
                posts += [('/objects', gone, time_of(BEGIN + at)) for at in deleted]
                bag = self.bag(sorted(messages + posts, key=lambda message: message[2]))
                with self.subTest(stamp=stamp, others=others, deleted=deleted):
                    stays = self.report(bag, '--zones', gate, '--objects', '/objects',
                                        code=ENTERED)['zones'][0]['stays']
                    self.assertEqual(len([s for s in stays if s['name'] == 'post/0']), count, stays)

    def test_a_marker_that_was_in_a_zone_before_tf_placed_it(self):
        """The zone moves away before."""
        self.plates('slow', 'fast')
        steps = [(0, {'slow': 5, 'fast': -1}), (.1, {'slow': 5, 'fast': -1}), (.2, {'fast': -1}),
                 (.22, {'fast': 1}), (.3, {'slow': 5, 'fast': 1})]
        gate = zone_text('gate', [.9, -1, -1], [1.1, 1, 1], 'fast')
        messages = self.plate_messages(*steps)
        for stamp, count in (.12, 1), (.25, 0):
            messages[2:] = [marker(-5, 0, .02, 'slow', stamp)] + self.plate_messages(*steps[2:])
            with self.subTest(stamp=stamp):
                zone = self.zone(messages, '--objects', '/objects', text=gate,
                                 code=ENTERED if count else 0)
                self.assertEqual([(stay['name'], stay['how']) for stay in zone['stays']],
                                 [('post/0', 'left')] * count)
                self.assertEqual(zone['clearance'] == 0, count > 0)
                if count:
                    self.assertEqual(zone['stays'][0]['entered']['stamp'], BEGIN + stamp)

    def test_a_start_while_one_publisher_is_late(self):
        """The plate passes through the other one before --start; that becomes known after it."""
        self.plates('fast', 'still')
        late = [(i * .3, {'fast': -1 if i < 10 else 1}, i * .3 + .25) for i in range(20)]
        stalled = [(0, {'fast': -1}), (.1, {'fast': -1}), (.3, {'fast': 1}, 4)]
        stalled += [(4 + i / 2, {'fast': 1}) for i in range(1, 4)]
        for steps, starts in (late, (0, 3.1, 3.2, 3.26)), (stalled, (0, 2, 3.5, 4.05)):
            still = [(i / 50, {'still': 0}) for i in range(300)]
            messages = sorted(self.plate_messages(*steps, *still), key=lambda m: m[2])
            for place, codes in (0, (UNDERCUT,) * 3 + (0,)), (3, (0,) * 4):
                for _, transforms, _ in messages:
                    for edge in transforms.transforms:
                        if edge.child_frame_id == 'still':
                            edge.transform.translation.x = place
                for start, code in zip(starts, codes):
                    with self.subTest(start=start, place=place):
                        self.report(self.bag(messages), '--distances', '.01', '--start', str(start),
                                    '--min-coverage', '0', '--timeout', '1', code=code)

    def test_an_object_that_was_met_before_the_start(self):
        """It is placed before the start, or after it by an earlier stamp."""
        self.plates('slow', 'fast')
        steps = [(i / 10, {'slow': 5, 'fast': -1 if i < 10 else 1}) for i in range(60)]
        for recorded in .25, 1.05, 3.05, 4.05:
            topic, post, _ = marker(0, 0, .02, 'base', .2)
            messages = self.plate_messages(*steps) + [(topic, post, time_of(BEGIN + recorded))]
            bag = self.bag(sorted(messages, key=lambda m: m[2]))
            for start, code in (0, UNDERCUT), (3.02, 0):
                with self.subTest(recorded=recorded, start=start):
                    self.report(bag, '--distances', '.01', '--objects', '/objects', '--start',
                                str(start), code=code)

    def test_a_zone_that_moves_past_a_static_link_before_the_start(self):
        self.plates('still')
        static = TFMessage([transform('base', 'still', time_of(0))])
        messages = [('/tf_static', static, time_of(BEGIN))]
        messages += self.plate_messages(*[(i / 10, {'cart': -1 if i < 20 else 1})
                                          for i in range(80)])
        topic, post, _ = marker(0, 50, .02)
        messages.insert(4, (topic, post, time_of(BEGIN + .2)))
        for start, code in ('0', ENTERED), ('1.9', ENTERED), ('5', 0):
            with self.subTest(start=start):
                self.zone(messages, '--start', start, '--timeout', '10', '--objects', '/objects',
                          code=code,
                          text=zone_text('gate', [-.3, -1, -1], [.3, 1, 1], 'cart'))

    def test_record_times_that_step_back_across_the_start(self):
        """What such a message moves is looked at in the report, which has begun."""
        self.plates('fast')
        for name in '', 'cart':
            steps = [(i / 10, {'fast': -1, 'cart': 0}) for i in range(11)]
            steps += [(1.05, {'fast': 1, 'cart': 0}, .98), (1.1, {'fast': 1, 'cart': 0})]
            with self.subTest(frame=name):
                self.zone(self.plate_messages(*steps), '--start', '1', code=ENTERED,
                          err='leave out --start',
                          text=zone_text('gate', [-.3, -1, -1], [.3, 1, 1], name))

    def test_a_motion_across_the_start_after_a_jump_of_the_clock(self):
        """What was before the start is remembered again."""
        self.plates('slow', 'fast')
        steps = [(i / 2, {'slow': 0, 'fast': -1}) for i in range(17)]
        steps += [(i + .9, {'slow': 0, 'fast': -1}) for i in range(2, 5)]
        for last, code in (1, UNDERCUT), (-.9, INCOMPLETE):
            messages = self.plate_messages(*steps, (5.9, {'slow': 0, 'fast': last}))
            for name in '', 'slow':
                text = zone_text('gate', [-.3, -1, -1], [-.2, 1, 1], name)
                with self.subTest(last=last, frame=name):
                    self.zone(messages, '--start', '5', code=code, err='jumped back', text=text)
            with self.subTest(last=last):
                self.report(self.bag(messages), '--distances', '.01', '--start', '5', code=code,
                            err='jumped back')

    def test_a_link_without_a_place_in_the_fixed_frame_that_moves_at_the_start(self):
        self.plates('fast')
        steps = [(0, {'fast': -1}), (.1, {'fast': -1}), (.3, {'fast': 1}, 4), (4.5, {'fast': 1})]
        static = TFMessage([transform('map', 'cart', time_of(0))])
        messages = [('/tf_static', static, time_of(BEGIN))] + self.plate_messages(*steps)
        self.zone(messages, '--start', '2', '--fixed-frame', 'map', '--timeout', '1', code=ENTERED,
                  err='no link ever had a box',
                  text=zone_text('gate', [-.3, -1, -1], [.3, 1, 1], 'base'))

    def test_a_marker_on_a_link_that_moves_at_the_start(self):
        """It moves as that does, also where that becomes known after a stall."""
        self.plates('slow', 'fast')
        post = marker(0, 5, .02, 'fast')
        even = [(0, {'slow': 0, 'fast': -1}), (.1, {'slow': 0, 'fast': -1}),
                (.6, {'slow': 0, 'fast': 1})]
        stalled = even[:2] + [(.6, {'slow': 0, 'fast': 1}, 4)]
        for steps, starts in (even, ((.3, ENTERED), (.7, 0))), (stalled, ((3, ENTERED), (4.1, 0))):
            later = .6 if steps is even else 4
            steps = steps + [(later + i / 2, {'slow': 0, 'fast': 1}) for i in range(1, 4)]
            bag = self.bag([post] + self.plate_messages(*steps))
            for name in '', 'slow':
                text = zone_text('gate', [-.3, 4.9, -1], [.3, 5.1, 1], name)
                zones = self.write('zones.yaml', text)
                for start, code in starts:
                    with self.subTest(start=start, frame=name):
                        self.report(bag, '--zones', zones, '--objects', '/objects', '--start',
                                    str(start), '--min-coverage', '0', code=code)

    def test_a_link_that_leaves_a_zone_while_tf_stalls_at_the_start(self):
        self.plates('fast')
        steps = [(0, {'fast': 0}), (.1, {'fast': 0}), (.3, {'fast': 1}, 4)]
        steps += [(4 + i / 2, {'fast': 1}) for i in range(1, 4)]
        for start, code in ('0', ENTERED), ('2', ENTERED), ('4.2', 0):
            with self.subTest(start=start):
                zone = self.zone(self.plate_messages(*steps), '--start', start, '--timeout', '1',
                                 '--min-coverage', '0', code=code,
                                 text=zone_text('gate', [-.3, -1, -1], [.3, 1, 1]))
                self.assertEqual(zone['entries'], code == ENTERED)

    def test_a_marker_that_comes_again_where_stamps_are_ahead_of_the_recorder(self):
        self.plates('slow', 'fast')
        for ahead in 0, .5:
            steps = [(i / 10, {'slow': 5, 'fast': -1 if i < 10 else 1}, i / 10 - ahead)
                     for i in range(20)]
            posts = [marker(-5, 0, .02, 'slow', i / 10 + .08)[:2] +
                     (time_of(BEGIN + i / 10 + .08 - ahead),) for i in range(1, 18)]
            bag = self.bag(sorted(self.plate_messages(*steps) + posts, key=lambda m: m[2]))
            with self.subTest(ahead=ahead):
                self.report(bag, '--distances', '.01', '--objects', '/objects', code=UNDERCUT)

    def test_an_object_is_there_until_it_is_deleted(self):
        """Or replaced, while the plate passes through its place, and after that."""
        self.plates('slow', 'fast')
        steps = [(0, {'slow': 5, 'fast': -1}), (.1, {'slow': 5, 'fast': -1}),
                 (.3, {'slow': 5, 'fast': 1}), (.5, {'slow': 5, 'fast': 1})]
        gone = Marker(ns='post', action=Marker.DELETE)
        for change in gone, marker(9, 0, .02)[1]:
            for time, code in (.25, UNDERCUT), (.15, 0):
                messages = self.plate_messages(*steps)
                messages[2:2] = [('/objects', change, time_of(BEGIN + time))]
                with self.subTest(time=time, action=change.action):
                    self.report(self.bag([marker(0, 0, .02)] + messages), '--distances', '.01',
                                '--objects', '/objects', code=code)

    def test_boxes_of_a_bag_in_a_loop(self):
        """Who reads them searches for a time."""
        out = self.path('boxes.bag')
        self.report(self.bag(swing(10, seconds=4) * 3), '--out', out, err='jumped back')
        with rosbag.Bag(out) as bag:
            times = [time.to_sec() for *_, time in bag.read_messages()]
            part = list(bag.read_messages(start_time=time_of(BEGIN + 1.95),
                                          end_time=time_of(BEGIN + 2.05)))
        self.assertEqual(times, sorted(times))
        self.assertEqual(len(part), 3)

    def test_no_motion_goes_across_a_jump_of_the_clock(self):
        """Although its stamps go on as before: tf has forgotten where it began."""
        messages = [(topic, message, time_of(time.to_sec() - 0.5 * (time.to_sec() > BEGIN + 0.5)))
                    for topic, message, time in swing(5)]
        zone = self.zone(messages, text=zone_text('post', [1.0515, -0.03, -1], [1.2, 0.03, 1]),
                         code=0, err='jumped back')
        self.assertEqual((zone['entries'], zone['undecided']), (0, 0))

    def test_a_zone_in_a_frame_that_has_no_later_transform(self):
        """The plate passes through its last place, or stops there."""
        self.plates('slow', 'fast')
        gate = zone_text('gate', [.2, -1, -1], [.4, 1, 1], 'slow')
        for last, x in ((.3, 1), (.3, .3), (5.5, 1), (-9, 1)):
            steps = [(0, {'slow': 0, 'fast': -1}), (.1, {'fast': -1}), (.3, {'fast': x})]
            steps += [(i / 2, {'fast': x}) for i in range(1, 12) if i / 2 < last]
            if last != .3:
                steps += [(last + i, {'slow': 0, 'fast': 1}) for i in (0, .5)]
            with self.subTest(last=last, x=x):
                zone = self.zone(self.plate_messages(*steps), '--min-coverage', '0', text=gate,
                                 code=ENTERED, err='jumped back' if last < 0 else '')
                # The way there is looked at once more when the last place is known to be none.
                entries = 2 if last == 5.5 else 1
                self.assertEqual((zone['entries'], zone['clearance']), (entries, 0))
                entered = BEGIN + .1 + .2 * 1.195 / (x + 1)
                self.assertAlmostEqual(zone['stays'][0]['entered']['stamp'], entered, delta=2e-3)

    def test_an_object_with_the_name_of_a_link(self):
        """It is beside the way that leads through the link."""
        self.plates('fast', 'post/0')
        steps = [(i / 10, {'fast': i / 2 - 2.75, 'post/0': 0}) for i in range(12)]
        for others in [], [marker(-.25, 1.3, .02)]:
            self.check_plates(*steps, others=others, arguments=('--objects', '/objects'),
                              err='(?s)links have names that markers may have.*"post/0".*' +
                              ('' if others else 'no message on /objects'))

    def test_a_clock_that_begins_at_zero(self):
        """That of a simulation. A stamp of 0 is no static transform."""
        self.plates('slow', 'fast')
        self.check_plates(*[(i / 10 - BEGIN, {'slow': 0, 'fast': -1 if i == 0 else 1})
                            for i in range(5)])
        self.urdf = self.write('arm.urdf', HAND)
        self.zone(swing(1, begin=0), '--out', self.path('boxes.bag'), code=ENTERED)
        hand, = [box for box in self.report(self.path('arms.bag'))['extremes'] if 'min' in box]
        self.assertEqual(set(hand['min_stamp'] + hand['max_stamp']), {0, 1})
        with rosbag.Bag(self.path('boxes.bag')) as bag:
            stamps = [(message.header.stamp.to_sec(), message.boxes[0].stamp.to_sec())
                      for _, message, _ in bag.read_messages() if message.boxes]
        self.assertEqual(stamps, [(0, 0), (1, 1)])

    def test_a_plate_that_moves_away_in_time(self):
        """In the place in which it was left, the other one would meet it."""
        self.plates('slow', 'fast')
        self.check_plates((0, {'slow': 0, 'fast': -1}), (.2, {'fast': -1}), (.4, {'fast': 1}),
                          (1, {'slow': 5, 'fast': 1}), code=0)

    def test_a_motion_before_the_other_body_is_known(self):
        """It is none beside it. So one that is known again has no way before."""
        self.plates('slow', 'fast')
        self.check_plates((0, {'fast': -1}), (.05, {'slow': 0}), (.1, {'fast': -1}),
                          (.2, {'slow': 0, 'fast': -1}), code=0)

    def test_a_parent_that_changes_is_undecided(self):
        """tf knows no way between two parents."""
        other = [transform('base', 'cart', time_of(0)), transform('base', 'table', time_of(0))]
        messages = swing(5)
        for i, (_, message, _) in enumerate(messages):
            message.transforms[0].header.frame_id = 'cart' if i < 3 else 'table'
        bag = self.bag([('/tf_static', TFMessage(other), time_of(BEGIN))] + messages)
        zones = self.write('zones.yaml', self.POST)
        zone = self.report(bag, '--zones', zones, code=INCOMPLETE,
                           err='1 motions .* not decided, the first of hand: .*changes its parent'
                           )['zones'][0]
        self.assertEqual((zone['undecided'], zone['clearance']), (1, 0))

    def test_a_late_transform_is_told(self):
        """It changes a motion that was looked at before it came."""
        messages = swing(5)
        late = messages[2][:2] + (messages[4][2],)
        messages = messages[:2] + [messages[3], late] + messages[4:]
        free = zone_text('far', [5, 5, 5], [6, 6, 6])
        self.zone(messages, text=free, code=INCOMPLETE,
                  err='late transforms, which change motions that were looked at: 1')
        self.zone(messages, '--allow-incomplete', text=free)
        self.zone(messages, '--start', '0.9', text=free)  # it came before

    def test_a_static_transform_that_replaces_another_one_is_told(self):
        """What passed by where it stood is not looked at. The same one again says nothing new."""
        messages = swing(5)
        free = zone_text('far', [5, 5, 5], [6, 6, 6])
        cup = [('/tf_static', TFMessage([transform('hand', 'cup', time_of(0), (x, 0, 0))]),
                messages[2][2]) for x in (0, 0, 1)]
        base = [('/tf_static', TFMessage([transform('world', 'base', time_of(0), (x, 0, 0))]),
                 messages[2][2]) for x in (0, 0, 1)]
        world = ('--fixed-frame', 'world')
        self.zone(messages[:3] + cup + messages[3:], text=free)  # no box needs it
        self.zone(messages[:3] + base[:2] + messages[3:], *world, '--min-coverage', '0', text=free)
        self.zone(messages[:3] + base + messages[3:], *world, '--min-coverage', '0', text=free,
                  code=INCOMPLETE, err='static transforms that replaced others, .*: 1;')

    def test_a_late_transform_that_no_box_needs(self):
        messages = swing(5)
        for i in (3, 2):
            cup = transform('hand', 'cup', messages[i][2], (0, 0, 0))
            messages.append(('/tf', TFMessage([cup]), messages[-1][2]))
        self.zone(messages, text=zone_text('far', [5, 5, 5], [6, 6, 6]))

    def test_every_format_has_the_clearance(self):
        bag = self.bag([marker(1.1, 0, 0.05)] + swing(5))
        zones = self.write('zones.yaml', self.POST)
        arguments = (bag, '--urdf', self.urdf, '--zones', zones, '--distances', '0.03', '--objects',
                     '/objects')
        self.assertRegex(run(*arguments)[1], '(?s)at  clearance  entries.*at  clearance  level')
        table = run(*arguments, '--format', 'csv')[1]
        self.assertRegex(table, '(?m)^zone_clearance,,post,0,,$')
        self.assertRegex(table, '(?m)^clearance,hand,post/0,0.02')


class DenseSamplesTest(BagBoundsTest):
    """Nothing that is proven of a slow bag is contradicted by a bag of all poses between."""

    SEEDS = range(6)

    def check_zone(self, slow, fast):
        if fast['entries'] > 0:
            self.assertTrue(slow['entries'] > 0 or slow['undecided'] > 0)
        self.assertLessEqual(slow['clearance'], max(fast['nearest']['distance'], 0) + 1e-9)
        if slow['undecided'] == 0:
            self.assertGreaterEqual(slow['clearance'], max(slow['nearest']['distance'], 0)
                                    - ACCURACY - 1e-9)
        return slow['entries'] > 0

    def check_pairs(self, slow, fast):
        slow = {(p['first'], p['second']): p for p in slow['distances']}
        for pair in fast['distances']:
            found = slow[pair['first'], pair['second']]
            self.assertLessEqual(found['clearance'], pair['distance_max'] + 1e-9)
            self.assertGreaterEqual(found['clearance'], found['distance'] - ACCURACY - 1e-9)

    def test_random_arms(self):
        entered = 0
        for seed in self.SEEDS:
            arms = RandomArms(seed)
            bags = [self.bag(arms.sparse(), 'slow.bag'), self.bag(arms.dense(), 'fast.bag')]
            zones = ''
            for i in range(8):
                low = [arms.random.uniform(-0.2, 1.2), arms.random.uniform(-1.2, 1.2), -0.5]
                high = [low[0] + arms.random.uniform(0, 0.1), low[1] + 0.02, 0.5]
                frame = ('', 'left_tip', 'right')[i % 3]
                zones += zone_text('z%d' % i, low, high, frame)
            path = self.write('zones.yaml', zones)
            found = []
            for bag in bags:
                code, out, err = run(bag, '--urdf', self.urdf, '--format', 'json', '--zones', path,
                                     '--distances', '0.3')
                self.assertIn(code, (0, ENTERED, INCOMPLETE), err)
                found.append(json.loads(out))
            with self.subTest(seed=seed):
                for slow, fast in zip(found[0]['zones'], found[1]['zones']):
                    entered += self.check_zone(slow, fast)
                self.check_pairs(*found)
        self.assertGreater(entered, 5)


if __name__ == '__main__':
    main()
