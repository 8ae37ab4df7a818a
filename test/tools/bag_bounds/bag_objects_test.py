#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded markers as objects of bag_bounds.

Run as: bag_objects_test.py PATH_OF_bag_bounds
"""
import csv
import pathlib

import genpy
import rosbag
import rospy
from bag_bounds_testing import (BEGIN, ENTERED, INCOMPLETE, PARTLY_READ, PERIOD, UNDERCUT,
                                BagBoundsTest, arms, degrees_at, main, moving_arms, raw, run, seconds,
                                static_arms, time_of, zone_text)
from bounds_testing import Pose, difference, union
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from node_testing import joint_pose
from object_testing import deletion, marker
from std_msgs.msg import Header, String
from visualization_msgs.msg import Marker, MarkerArray

MESHES = pathlib.Path(__file__).resolve().parents[3] / 'launch/demo/meshes'


def recorded(index, *markers, topic='/objects'):
    return topic, MarkerArray(list(markers)), time_of(BEGIN + PERIOD * index)


class ObjectsTest(BagBoundsTest):
    def objects(self, messages, *arguments, **options):
        bag = self.bag(sorted(messages, key=lambda message: message[2]))
        return self.report(bag, '--objects', '/objects', *arguments, **options)

    def objects_in_order(self, messages, *arguments, **options):
        return self.report(self.bag(messages), '--objects', '/objects', *arguments, **options)

    def box(self, found, name):
        box = next(box for box in found['extremes'] if box['name'] == name)
        return box['min'] + box['max']

    def test_an_object_on_a_link(self):
        cube = marker('part/1', frame='left_tip', scale=(0.1, 0.2, 0.3))
        found = self.objects(arms(20) + [recorded(0, cube)])
        bounds = union([(joint_pose('left', degrees_at(i)) * joint_pose('left_tip', degrees_at(i)))
                        .box_bounds((0.1, 0.2, 0.3)) for i in range(20)])
        self.assertLess(difference(self.box(found, 'part/1'), bounds), 1e-9)

    def test_transforms_of_a_frame_that_places_an_object_once(self):
        """As those of frames that links have: from the marker on, none is left out without a word,
        and none comes late."""
        def cart(index, recorded=None):
            topic, message, time = moving_arms(index, recorded, links=('left',))
            message.transforms[0].child_frame_id = 'cart'
            return topic, message, time

        zones = self.write('zones.yaml', zone_text('far', [8] * 3, [9] * 3))
        cube = marker('part/1', frame='cart', stamp=time_of(BEGIN + PERIOD * 10))
        messages = arms(40) + [cart(i) for i in range(0, 40, 2)] + [recorded(20, cube)]
        broken = cart(31)
        broken[1].transforms[0].transform.rotation.w = 9
        for more, err in ((None, ''), (cart(11, BEGIN + PERIOD * 30), 'late transforms'),
                          (broken, 'losses while reading')):
            with self.subTest(err=err):
                self.objects(messages + ([more] if more else []), '--zones', zones,
                             code=INCOMPLETE if more else 0, err=err)

    def test_single_markers(self):
        cube = '/object', marker('part/1'), time_of(BEGIN)
        found = self.objects(arms(3) + [cube], '--objects', '/object', code=INCOMPLETE,
                             err='no message on /objects')
        self.assertLess(difference(self.box(found, 'part/1'), [-.5] * 3 + [.5] * 3), 1e-9)

    def test_objects_of_two_topics(self):
        """They do not replace or delete each other. Of two that have one name, one is a loss."""
        near, far = (marker('part/1', scale=(.1, .1, .1), pose=Pose((x, 5, 0))) for x in (5, 9))
        all_of = Marker(action=Marker.DELETEALL)
        zones = self.write('zones.yaml', zone_text('cell', [4, 4, -1], [6, 6, 1]))
        text = marker('part/1')
        text.type = Marker.TEXT_VIEW_FACING
        for other, losses in (far, 1), (deletion('part/1'), 0), (all_of, 0), (text, 0):
            for topics in ('/objects', '/more'), ('/more', '/objects'):
                messages = arms(10) + [recorded(2, near, topic=topics[0]),
                                       recorded(4, other, topic=topics[1])]
                with self.subTest(action=other.action, type=other.type, topics=topics):
                    found = self.objects(messages, '--objects', '/more', '--zones', zones,
                                         code=ENTERED, err='left out' if losses else '')
                    self.assertEqual(len(found['losses']), losses)
                    self.assertEqual(found['zones'][0]['stays'][0]['how'], 'report_ended')
                    self.objects(messages, '--objects', '/more', code=INCOMPLETE if losses else 0,
                                 err='"part/1" on %s: an object of %s has that name' % topics[::-1]
                                 if losses else '')
        found = self.objects(arms(20) + [
            recorded(2, near), recorded(3, marker('part/2'), topic='/more'),
            recorded(5, all_of), recorded(7, far, topic='/more')], '--objects', '/more',
            '--at', '0.25')
        self.assertEqual([box['name'] for box in found['boxes']][-2:], ['part/1', 'part/2'])

    def test_boxes_of_one_node_on_two_topics(self):
        def boxes(topic, index, name, x):
            message = AxisAlignedBoxArray(Header(frame_id='base'), [AxisAlignedBox(
                name, rospy.Time(), Point(x, 5, 0), Point(x + 1, 6, 1))] if name else [], [])
            return topic, message, time_of(BEGIN + PERIOD * index)
        zones = self.write('zones.yaml', zone_text('cell', [4, 4, -1], [6, 6, 1]))
        for name, losses in ('arm', 1), ('hand', 0), ('', 0):
            messages = arms(10) + [boxes('/objects', 2, 'arm', 5), boxes('/more', 4, name, 20)]
            with self.subTest(name=name):
                found = self.objects(messages, '--objects', '/more', '--zones', zones, code=ENTERED,
                                     err='"//arm" on /more: an object of /objects has that name'
                                     if losses else '')
                self.assertEqual(len(found['losses']), losses)
                self.assertEqual([stay['how'] for stay in found['zones'][0]['stays']],
                                 ['report_ended'])

    def test_a_topic_of_which_all_is_ignored(self):
        drawing = marker('link_bounds/base/1')
        for others, code in ([], INCOMPLETE), ([recorded(3, marker('part/1'))], 0):
            self.objects(arms(5) + [recorded(2, drawing)] + others, code=code,
                         err='/objects has only what a node of link_bounds draws' if code else '')

    def test_boxes_of_another_node(self):
        """Such as its ~stopping. Names begin with that of the node, which this bag does not have."""
        def boxes(index, names):
            message = AxisAlignedBoxArray(Header(frame_id='base'), [AxisAlignedBox(
                name, rospy.Time(), Point(1, 2, 3 + index), Point(2, 3, 4 + index))
                for name in names], [])
            return '/objects', message, time_of(BEGIN + PERIOD * index)
        found = self.objects(arms(5) + [boxes(1, ['arm']), boxes(2, ['arm', 'hand'])])
        self.assertLess(difference(self.box(found, '//arm'), [1, 2, 4, 2, 3, 6]), 1e-9)
        self.assertLess(difference(self.box(found, '//hand'), [1, 2, 5, 2, 3, 6]), 1e-9)

    def test_a_box_of_another_node_that_comes_again_is_the_same_object(self):
        """A tracker that sends what it sees: without a common name they are of another robot."""
        def boxes(index, names):
            message = AxisAlignedBoxArray(Header(frame_id='base'), [AxisAlignedBox(
                name, rospy.Time(), Point(index, y, 0), Point(index + 1, y + 1, 1))
                for name, y in (('p', 7), ('q', 5)) if name in names], [])
            return '/objects', message, time_of(BEGIN + PERIOD * index)
        found = self.objects(arms(10) + [boxes(index, names) for index, names in enumerate(
            ['p', 'p', 'q', 'q', 'pq', 'pq', 'q', 'p', 'qp'])], '--distances', '20', code=ENTERED)
        objects = [entry for entry in found['extremes'] if entry['name'] in ('//p', '//q')]
        self.assertEqual([entry['name'] for entry in objects], ['//p', '//q'])
        self.assertLess(difference(self.box(found, '//p'), [0, 7, 0, 9, 8, 1]), 1e-9)
        self.assertLess(difference(self.box(found, '//q'), [2, 5, 0, 9, 6, 1]), 1e-9)
        pairs = [frozenset((pair['first'], pair['second'])) for pair in found['distances']]
        self.assertEqual(len(pairs), len(set(pairs)), pairs)
        self.assertIn({'//p', '//q'}, pairs)

    def test_an_object_in_a_zone(self):
        """It appears, goes, and comes again with another pose."""
        near, far = (marker('part/1', scale=(.1, .1, .1), pose=Pose((x, 5, 0))) for x in (5, 9))
        zones = self.write('zones.yaml', zone_text('cell', [4, 4, -1], [6, 6, 1]) +
                           zone_text('moving', [4, 4, -1], [6, 6, 1], 'mast'))
        found = self.objects(arms(10) + [recorded(2, near), recorded(4, deletion('part/1')),
                                         recorded(6, near), recorded(8, far)],
                             '--zones', zones, code=ENTERED)
        stays = [(stay['entered']['time'], stay['end']['time'], stay['how'])
                 for stay in found['zones'][0]['stays']]
        self.assertEqual(stays, [(.04, .08, 'lost'), (.12, .16, 'left')])
        self.assertEqual(found['zones'][1]['entries'], 0)

    def test_a_placed_object_in_a_zone_that_moves(self):
        """It stays where it was placed while the frame of the zone turns."""
        cube = marker('part/1', scale=(.01, .01, .01), pose=Pose((1, 0, 0)), frame='base',
                      stamp=genpy.Time(BEGIN))
        pose = joint_pose('left', degrees_at(5)).inverse() * Pose((1, 0, 0))
        low, high = [c - 1e-3 for c in pose.xyz], [c + 1e-3 for c in pose.xyz]
        zones = self.write('zones.yaml', zone_text('hand', low, high, 'left'))
        stays = self.objects(arms(20) + [recorded(0, cube)], '--zones', zones,
                             code=ENTERED)['zones'][0]['stays']
        self.assertEqual([stay['name'] for stay in stays], ['part/1'])
        self.assertTrue(stays[0]['entered']['time'] <= 5 * PERIOD <= stays[0]['end']['time'])

    def test_objects_are_those_of_the_time_of_at(self):
        """Not those after the next message, which may move or delete them."""
        near, far = (marker('part/1', pose=Pose((x, 0, 0))) for x in (10, 20))
        changes = [recorded(1, near), recorded(20.5, far), recorded(40.5, deletion('part/1'))]
        messages = [static_arms()] + [moving_arms(i) for i in range(0, 60, 5)] + changes
        for at, x in ((.405, [10]), (.43, [20]), (.805, [20]), (.83, [])):
            with self.subTest(at=at):
                boxes = self.objects(messages, '--at', str(at))['boxes']
                found = [box['min'][0] + .5 for box in boxes if box['name'] == 'part/1']
                self.assertEqual([round(value, 6) for value in found], x)

    def test_objects_are_those_after_all_messages_of_the_time_of_at(self):
        near, far = (marker('part/1', pose=Pose((x, 0, 0))) for x in (10, 20))
        for last, x in (recorded(20, far), [19.5]), (recorded(20, deletion('part/1')), []):
            for end in 60, 21:
                messages = [static_arms()] + [moving_arms(i) for i in range(0, end, 5)]
                with self.subTest(x=x, end=end):
                    boxes = self.objects(messages + [recorded(20, near), last],
                                         '--at', '0.4')['boxes']
                    found = [box['min'][0] for box in boxes if box['name'] == 'part/1']
                    self.assertEqual([round(value, 6) for value in found], x)

    def test_an_object_without_a_box_at_the_time_of_at_is_told(self):
        lost = marker('part/1', scale=(-1, 1, 1))
        found = self.objects(arms(20) + [recorded(2, lost)], '--at', '0.2', code=INCOMPLETE,
                             err='incomplete names: 1')
        self.assertIn({'name': 'part/1'}, found['boxes'])
        self.assertRegex(found['incomplete']['part/1'], 'no box at 1000[.]2: scale is negative')

    def test_the_box_of_an_earlier_marker_stands_while_the_new_one_waits(self):
        """For the transform of another frame, at a stamp that tf reaches later."""
        old = marker('part/1', frame='left_tip', scale=(.1, .2, .3))
        new = marker('part/1', frame='right', stamp=time_of(BEGIN + 12 * PERIOD))
        found = self.objects(arms(20) + [recorded(2, old), recorded(6, new)], '--at', '0.16',
                             '--allow-incomplete')
        pose = joint_pose('left', degrees_at(6)) * joint_pose('left_tip', degrees_at(6))
        box = next(box for box in found['boxes'] if box['name'] == 'part/1')
        self.assertLess(difference(box['min'] + box['max'], pose.box_bounds((.1, .2, .3))), 1e-9)

    def test_an_object_that_waits_for_tf_is_where_tf_places_it(self):
        """At a time between its message and the transform of its stamp."""
        cube = marker('part/1', frame='left', stamp=time_of(BEGIN + 6 * PERIOD), scale=(.1, .2, .3))
        messages = [static_arms()] + [
            moving_arms(i, BEGIN + PERIOD * (i + 4)) for i in range(20)]
        found = self.objects(messages + [recorded(6, cube)], '--at', str(seconds(8)))
        box = next(box for box in found['boxes'] if box['name'] == 'part/1')
        expected = joint_pose('left', degrees_at(6)).box_bounds((.1, .2, .3))
        self.assertLess(difference(box['min'] + box['max'], expected), 1e-9)
        never = marker('part/2', frame='nowhere', stamp=time_of(BEGIN + 6 * PERIOD))
        found = self.objects(messages + [recorded(6, never)], '--at', str(seconds(8)),
                             code=INCOMPLETE, err='incomplete names: 1')
        self.assertIn('no box at', found['incomplete']['part/2'])

    def test_a_jump_of_the_clock_ends_the_search_for_boxes(self):
        """Else links of the second pass stand beside objects of the first one."""
        def late(begin, end):
            return [moving_arms(i, BEGIN + PERIOD * (i + 4)) for i in range(begin, end)]
        found = self.objects_in_order(
            [static_arms()] + late(0, 100) + [recorded(104, marker('part/1'))] + late(101, 110) +
            late(20, 120), '--at', str(seconds(110.5)), code=INCOMPLETE, err='.*')
        self.assertEqual([box['name'] for box in found['boxes'] if box.get('min')],
                         ['base', 'mast', 'part/1'])

    def test_an_object_that_is_gone_has_a_row_and_no_speed(self):
        near, far = (marker('part/1', stamp=time_of(BEGIN + i * PERIOD), pose=Pose((x, 0, 0)))
                     for i, x in ((2, 0), (6, 10)))
        path = self.path('series.csv')
        found = self.objects(arms(20) + [recorded(2, near), recorded(4, deletion('part/1')),
                                         recorded(6, far)], '--series', path)
        with open(path, encoding='utf-8') as file:
            rows = [row for row in csv.DictReader(file) if row['name'] == 'part/1']
        self.assertEqual([(float(row['time']), row['min_x'][:4], row['speed']) for row in rows],
                         [(seconds(2), '-0.5', ''), (seconds(4), '', ''), (seconds(6), '9.49', '')])
        extremes = next(box for box in found['extremes'] if box['name'] == 'part/1')
        self.assertNotIn('max_speed', extremes)

    def test_markers_that_tf_places_soon(self):
        """Each in the message that moves their link. They were there since their stamps."""
        def placed(index):
            return recorded(index, marker('part/1', frame='left_tip', scale=(.1, .1, .1),
                                          stamp=time_of(BEGIN + PERIOD * index)))
        last = recorded(20.5, marker('part/1', frame='left_tip', scale=(.1, .1, .1),
                                     stamp=time_of(BEGIN + 1)))
        for markers in [placed(5.5)], [placed(i + .5) for i in range(5, 20, 3)]:
            with self.subTest(markers=len(markers)):
                found = self.objects(arms(40) + markers)
                self.assertEqual((found['extremes'][-1]['coverage'], found['incomplete']), (1, {}))
                found = self.objects(arms(40) + markers + [last], code=INCOMPLETE,
                                     err='incomplete names: 1')
                self.assertRegex(found['incomplete']['part/1'], 'is not there yet')
        self.objects(arms(40) + [last], code=INCOMPLETE, err='incomplete names: 1')
        gone = recorded(30, deletion('part/1'))
        self.objects(arms(40) + [placed(5.5), last, gone], code=INCOMPLETE,
                     err='incomplete names: 1')

    def test_a_marker_that_is_never_placed_leaves_its_name_open(self):
        """Also where another one of its name is placed before it or after it."""
        waits = recorded(5.2, marker('part/1', frame='nowhere', stamp=time_of(BEGIN + .1)))
        old, new = (recorded(index, marker('part/1', pose=Pose((9, 0, 0)), frame='base',
                                           stamp=time_of(BEGIN + PERIOD * index)))
                    for index in (4.5, 7.5))
        follows = recorded(7.2, marker('part/1', pose=Pose((9, 0, 0))))
        waits_too = recorded(6.5, marker('part/1', frame='left_tip', stamp=time_of(BEGIN + .14)))
        gone = recorded(6.7, deletion('part/1'))
        for case, others in enumerate(([new], [gone, new], [old, new], [follows, new], [waits_too],
                                       [old, waits_too, gone], [old, gone], [gone])):
            with self.subTest(case=case):
                found = self.objects(arms(40) + [waits] + others, code=INCOMPLETE,
                                     err='incomplete names: 1')
                self.assertRegex(found['incomplete']['part/1'], 'nowhere')

    def test_a_mesh_that_tf_places_soon(self):
        mesh = marker('part/1', Marker.MESH_RESOURCE, frame='left_tip',
                      stamp=time_of(BEGIN + PERIOD * 5.5),
                      mesh_resource=(MESHES / 'wrist.stl').as_uri())
        found = self.objects(arms(40) + [recorded(5.5, mesh)])
        self.assertEqual((found['extremes'][-1]['coverage'], found['incomplete']), (1, {}))

    def test_an_object_that_waits_for_its_frame(self):
        """It is there from its marker on, and has a box from the first transform on."""
        link = [moving_arms(i, links=('right',)) for i in range(10, 20)]
        others = [moving_arms(i, links=('left', 'left_tip')) for i in range(20)]
        for index, coverage, code in ((2, 10 / 18, INCOMPLETE), (12, 1, 0)):
            cube = marker('part/1', frame='right', scale=(.1, .1, .1))
            found = self.objects([static_arms()] + others + link + [recorded(index, cube)],
                                 code=code, err='incomplete names: 1' if code else '')
            with self.subTest(index=index):
                share = next(box['coverage'] for box in found['extremes']
                             if box['name'] == 'part/1')
                self.assertAlmostEqual(share, coverage, delta=.06)
                self.assertEqual(list(found['incomplete']), ['part/1'] if code else [])

    def test_an_object_that_is_deleted_has_no_gap(self):
        """A marker that comes later, or goes, is rightly not there."""
        cube = marker('part/1', scale=(.1, .1, .1))
        found = self.objects(arms(20) + [recorded(5, cube), recorded(10, deletion('part/1'))])
        self.assertEqual((found['extremes'][-1]['coverage'], found['incomplete']), (1, {}))

    def test_a_mesh_is_there_at_once(self):
        mesh = marker('part/1', Marker.MESH_RESOURCE, pose=Pose((0, 0, 2)),
                      mesh_resource=(MESHES / 'wrist.stl').as_uri())
        found = self.objects(arms(5) + [recorded(2, mesh)])
        self.assertEqual(found['incomplete'], {})
        self.assertEqual(found['extremes'][-1]['min_time'], [2 * PERIOD] * 3)

    def test_a_mesh_that_cannot_be_read(self):
        mesh = marker('part/1', Marker.MESH_RESOURCE, mesh_resource='file:///none.stl')
        found = self.objects(arms(5) + [recorded(2, mesh)], code=INCOMPLETE, err='none.stl')
        self.assertIn('none.stl', found['incomplete']['part/1'])

    def test_the_distance_of_a_mesh_is_that_of_its_triangles(self):
        """They are loaded before the first distance is computed. The hull of the strip touches."""
        mesh = marker('part/1', Marker.MESH_RESOURCE, pose=Pose((0, 0, 1)),
                      mesh_resource=(MESHES / 'wrist.stl').as_uri())
        strip = marker('part/2', Marker.LINE_STRIP, scale=(.01, 0, 0), pose=Pose((0, 0, 1)),
                       points=[(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
        found = self.objects(arms(5) + [recorded(2, mesh, strip)], '--distances', '2',
                             code=UNDERCUT)
        pair = next(p for p in found['distances'] if p['first'] == 'part/1')
        self.assertEqual((pair['second'], pair['level'], pair['time']), ('part/2', 'MESH', .04))
        self.assertLess(pair['distance_max'] - pair['distance'], 2e-4)

    def test_a_contact_is_a_finding_for_any_limit(self):
        found = self.objects(arms(5) + [recorded(0, marker('part/1'))], '--distances', '0',
                             code=UNDERCUT)
        self.assertEqual(found['distances'][0]['distance'], 0)
        self.objects(arms(5) + [recorded(0, marker('part/1', pose=Pose((0, 0, 5))))],
                     '--distances', '0')

    def test_another_type(self):
        bag = self.bag(arms(3) + [('/objects', String(), time_of(BEGIN + 1))])
        self.check_refused('the messages on /objects are of type std_msgs/String, not '
                           'visualization_msgs/Marker', bag, '--urdf', self.urdf, '--objects',
                           '/objects')

    def test_a_topic_without_messages(self):
        code, _, err = run(self.bag(arms(3)), '--urdf', self.urdf, '--objects', 'none')
        self.assertEqual(code, INCOMPLETE)
        self.assertIn('warning: no message on /none was read', err)
        self.assertIn('not everything was answered: topics without any message: 1', err)

    def test_markers_that_announce_too_much(self):
        """A damaged count must not take the memory that it announces."""
        path = self.path('damaged.bag')
        kind, data, md5, python = raw(MarkerArray([marker('part/1', points=[(0, 0, 0)] * 2)]))
        points = data.index(b'\x02\x00\x00\x00' + bytes(48))
        damaged = [b'\xff\xff\xff\xff' + data[4:],
                   data[:points] + b'\xff\xff\xff\x7f' + data[points + 4:]]
        with rosbag.Bag(path, 'w') as bag:
            for message in arms(3):
                bag.write(*message)
            for bytes_ in damaged:
                bag.write('/objects', (kind, bytes_, md5, python), time_of(BEGIN + 1), raw=True)
        found = self.report(path, '--objects', '/objects', code=PARTLY_READ,
                            err='2 messages are too short')
        self.assertEqual(len(found['losses']), 1)


if __name__ == '__main__':
    main()
