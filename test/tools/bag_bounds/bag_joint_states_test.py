#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""bag_bounds --joint-states: positions of joints instead of transforms.

Run as: bag_joint_states_test.py PATH_OF_bag_bounds
"""
import math
import re

from bag_bounds_testing import (BEGIN, ENTERED, INCOMPLETE, PERIOD, UNDERCUT, BagBoundsTest, arms,
                                main, run, time_of, zone_text)
from page_testing import PACKAGE
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage
from urdf_tf import UrdfTf

DEMO = PACKAGE / 'launch/demo/demo.urdf'


class JointStatesTest(BagBoundsTest):
    """Positions of joints beside the transforms that robot_state_publisher would have sent."""

    def setUp(self):
        super().setUp()
        self.demo = UrdfTf(DEMO.read_text('utf-8'))
        self.urdf = str(DEMO)
        mimics = re.findall(r'<joint name="(\w+)"(?:(?!</joint>).)*<mimic', DEMO.read_text('utf-8'),
                            re.DOTALL)
        self.leaders = [name for name in self.demo.movable if name not in mimics]

    def values(self, index):
        return {name: 0.02 + 0.01 * i * math.sin(0.05 * index * (1 + i))
                for i, name in enumerate(self.demo.movable)}

    def state(self, index, names, stamp=None):
        time = time_of(BEGIN + PERIOD * index)
        message = JointState(name=['other_robot'] + names, position=[1.0] + [
            self.values(index)[name] for name in names])
        message.header.stamp = time if stamp is None else stamp
        return '/joint_states', message, time

    def both(self, states, *arguments):
        messages = [('/tf_static', TFMessage(self.demo.static()), time_of(BEGIN))]
        for index in range(60):
            stamp = time_of(BEGIN + PERIOD * index)
            messages.append(('/tf', TFMessage(self.demo.moving(stamp, self.values(index))), stamp))
        return (self.report(self.bag(messages, 'tf.bag'), *arguments),
                self.report(self.bag(states, 'states.bag'), '--joint-states', 'joint_states',
                            *arguments))

    def check_same(self, expected, found):
        for a, b in zip(expected['extremes'], found['extremes']):
            self.assertEqual((a['name'], a['coverage']), (b['name'], b['coverage']))
            for x, y in zip(a['min'] + a['max'], b['min'] + b['max']):
                self.assertAlmostEqual(x, y, delta=1e-9)
        self.assertEqual(found['incomplete'], {})

    def test_the_boxes_are_those_of_tf(self):
        self.check_same(*self.both([self.state(i, self.leaders) for i in range(60)]))

    def test_half_a_turn_and_more(self):
        """A joint passes all positions between two messages, unless its driver may have begun a
        turn anew."""
        joint = ('<joint name="a" type="%s"><parent link="base"/><child link="tip"/>'
                 '<axis xyz="0 0 1"/>%s</joint>')
        limit = '<limit lower="-9" upper="9" effort="1" velocity="9"/>'
        zones = self.write('zones.yaml', zone_text('door', [-.02, .9, -1], [.02, 1.1, 1]))
        for kind, begin, end, code in (
                ('revolute', 0, .9, ENTERED), ('revolute', 0, 1.2, ENTERED),
                ('revolute', 0, 2, ENTERED), ('revolute', 0, -1.2, 0), ('revolute', 2, -1, ENTERED),
                ('continuous', 0, 1.2, INCOMPLETE), ('continuous', 1, 3, ENTERED),
                ('continuous', 2, 3.2, ENTERED), ('continuous', .95, -.95, 0),
                ('continuous', 0, 1e9, INCOMPLETE), ('continuous', 1 / 3, -2 / 3, INCOMPLETE),
                *(('revolute', *ends, ENTERED) for first in (-.4, -1 / 3, -.25, 0, .1, .25, .3183)
                  for ends in ((first, first + 1), (first + 1, first)))):
            self.urdf = self.write('arm.urdf', '<robot name="r"><link name="base"/>'
                                   '<link name="tip"><visual><origin xyz="1 0 0"/><geometry><box size=".1 .1 .1"/>'
                                   '</geometry></visual></link>%s</robot>' %
                                   joint % (kind, limit if kind == 'revolute' else ''))
            messages = []
            for i in range(20):
                stamp = time_of(BEGIN + i / 10)
                state = JointState(name=['a'], position=[math.pi * (begin if i < 9 else end)])
                state.header.stamp = stamp
                messages.append(('/joint_states', state, stamp))
            with self.subTest(kind=kind, begin=begin, end=end):
                self.report(self.bag(messages), '--zones', zones, '--joint-states', '/joint_states',
                            code=code, err='half a turn or more' if code == INCOMPLETE else '')

    def test_a_turn_after_the_clock_jumped_back(self):
        """Where the joint was before the jump is no begin of a turn after it."""
        self.urdf = self.write('arm.urdf', '<robot name="r"><link name="base"/><link name="tip">'
                               '<visual><origin xyz="1 0 0"/><geometry><box size=".1 .1 .1"/>'
                               '</geometry></visual></link><joint name="a" type="revolute">'
                               '<parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>'
                               '<limit lower="-9" upper="9" effort="1" velocity="9"/></joint></robot>')
        zones = self.write('zones.yaml', zone_text('door', [-.02, .9, -1], [.02, 1.1, 1]))
        messages = []
        for i in [100, *range(20)]:
            stamp = time_of(BEGIN + i / 10)
            state = JointState(name=['a'], position=[math.pi * (0 if i < 9 else 1.2)])
            state.header.stamp = stamp
            messages.append(('/joint_states', state, stamp))
        self.report(self.bag(messages), '--zones', zones, '--joint-states', '/joint_states',
                    code=ENTERED, err='the clock jumped back')

    def test_a_mimic_joint_goes_the_way_of_its_leader(self):
        """Whatever its own type: no driver sends its position."""
        joint = ('<joint name="%s" type="%s"><parent link="base"/><child link="%s"/>'
                 '<axis xyz="0 0 1"/>%s%s</joint>')
        limit = '<limit lower="-9" upper="9" effort="1" velocity="9"/>'
        front = self.write('front.yaml', zone_text('door', [.9, -.02, -1], [1.1, .02, 1]))
        back = self.write('back.yaml', zone_text('door', [-1.1, -.02, -1], [-.9, .02, 1]))
        for leader, follower, factor, end, zones, code in (
                ('revolute', 'continuous', 3, 1, front, ENTERED),
                ('revolute', 'continuous', 2.5, 1, front, ENTERED),
                ('prismatic', 'continuous', 30, .1, front, ENTERED),
                ('continuous', 'continuous', 3, 1, front, ENTERED),
                ('revolute', 'revolute', 3, 1, front, ENTERED),
                ('revolute', 'continuous', 1, 1, back, 0),
                ('continuous', 'revolute', 1, 2.9, back, ENTERED),  # its driver began anew
                ('continuous', 'revolute', -1, 2.9, back, ENTERED),
                ('continuous', 'continuous', 1, 2.9, back, ENTERED),
                ('continuous', 'revolute', 1, 2.9, front, 0),
                ('continuous', 'revolute', 1, 2, front, INCOMPLETE),
                ('continuous', 'continuous', 1.5, 2.9, front, INCOMPLETE)):
            self.urdf = self.write('arm.urdf', '<robot name="r"><link name="base"/><link name="a"/>'
                                   '<link name="tip"><visual><origin xyz="1 0 0"/><geometry><box size=".1 .1 .1"/>'
                                   '</geometry></visual></link>%s%s</robot>' % (
                                       joint % ('a', leader, 'a', '' if leader == 'continuous'
                                                else limit, ''),
                                       joint % ('m', follower, 'tip', '' if follower == 'continuous'
                                                else limit,
                                                '<mimic joint="a" multiplier="%g"/>' % factor)))
            messages = []
            for i in range(20):
                stamp = time_of(BEGIN + i / 10)
                state = JointState(name=['a'], position=[-end if i < 9 else end])
                state.header.stamp = stamp
                messages.append(('/joint_states', state, stamp))
            with self.subTest(leader=leader, follower=follower, factor=factor, end=end):
                self.report(self.bag(messages), '--zones', zones, '--joint-states', '/joint_states',
                            code=code, err='half a turn or more' if code == INCOMPLETE else '')

    def test_joints_in_messages_of_their_own(self):
        """And without a stamp, where that of the recording serves."""
        states = [self.state(i, self.leaders[half::2], time_of(0) if half else None)
                  for i in range(60) for half in (0, 1)]
        self.check_same(*self.both(states))

    def test_a_mimic_joint_with_a_position_of_its_own(self):
        """As for robot_state_publisher, it counts more than that of its leader."""
        mimic = next(name for name in self.demo.movable if name not in self.leaders)
        states = [self.state(i, self.leaders) for i in range(9)]
        expected = self.report(self.bag(states), '--joint-states', '/joint_states')
        link = re.search(r'<joint name="%s".*?<child link="(\w+)"' % mimic,
                         DEMO.read_text('utf-8'), re.DOTALL).group(1)
        for _, message, _ in states:
            message.name.append(mimic)
            message.position.append(0.04)
        found = self.report(self.bag(states, 'own.bag'), '--joint-states', '/joint_states')
        for a, b in zip(expected['extremes'], found['extremes']):
            (self.assertNotEqual if a['name'] == link else self.assertEqual)(a['max'], b['max'])

    def test_a_chain_of_mimic_joints(self):
        """Each takes the value of the joint that it names, if a message has it."""
        slide = ('<link name="{0}"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual>'
                 '</link><joint name="j{0}" type="prismatic"><parent link="base"/>'
                 '<child link="{0}"/><axis xyz="1 0 0"/>{1}'
                 '<limit lower="-9" upper="9" effort="1" velocity="1"/></joint>')
        mimics = (('z', ''), ('m', '<mimic joint="jz" multiplier="2" offset="0.3"/>'),
                  ('n', '<mimic joint="jm" multiplier="3" offset="0.05"/>'))
        self.urdf = self.write('chain.urdf', '<robot name="r"><link name="base"/>%s</robot>' %
                               ''.join(slide.format(*mimic) for mimic in mimics))
        for told, places in (({'jz': .1}, (.1, .5, 1.55)), ({'jz': .1, 'jm': .7}, (.1, .7, 2.15)),
                             ({'jz': .1, 'jn': .7}, (.1, .5, .7))):
            message = JointState(name=list(told), position=list(told.values()))
            message.header.stamp = time_of(BEGIN)
            found = self.report(self.bag([('/joint_states', message, time_of(BEGIN))]),
                                '--joint-states', '/joint_states')
            with self.subTest(told=told):
                self.assertEqual([round(box['max'][0] - .05, 9) for box in found['extremes']],
                                 list(places))

    def test_a_message_without_positions_is_no_loss(self):
        """A driver may send the speeds of wheels on the same topic."""
        states = [self.state(i, self.leaders) for i in range(9)]
        _, wheels, time = self.state(9, self.leaders)
        wheels.position, wheels.velocity = [], [1.0] * len(wheels.name)
        found = self.report(self.bag(states + [('/joint_states', wheels, time)]),
                            '--joint-states', '/joint_states')
        self.assertEqual(found['losses'], [])

    def test_a_message_with_other_than_one_position_per_name_is_lost(self):
        """robot_state_publisher takes nothing of it."""
        states = [self.state(i, self.leaders) for i in range(9)]
        expected = self.report(self.bag(states), '--joint-states', '/joint_states')
        for change in (lambda message: message.position.pop(),
                       lambda message: message.position.append(1)):
            _, other, time = self.state(9, self.leaders)
            other.position = [1.0] * len(other.name)
            change(other)
            found = self.report(self.bag(states + [('/joint_states', other, time)], 'other.bag'),
                                '--joint-states', '/joint_states', code=INCOMPLETE,
                                err='losses while reading: 1')
            self.assertRegex(found['losses'][0], '^1 message of joints left out, .*one position for each name')
            self.assertEqual([box['max'] for box in found['extremes']],
                             [box['max'] for box in expected['extremes']])

    def test_motion_between_positions_is_covered(self):
        states = [self.state(i, self.leaders) for i in range(0, 60, 15)]
        found = self.report(self.bag(states), '--joint-states', '/joint_states', '--distances', '1',
                            code=UNDERCUT)
        self.assertTrue(all(pair['clearance'] <= pair['distance'] for pair in found['distances']))

    def test_a_joint_without_position(self):
        bag = self.bag([self.state(i, self.leaders[1:]) for i in range(9)])
        found = self.report(bag, '--joint-states', '/joint_states', code=INCOMPLETE,
                            err='incomplete names')
        self.assertIn('; no message has the position of ' + self.leaders[0],
                      found['incomplete']['shoulder'])

    def test_what_is_refused(self):
        bag = self.bag([self.state(0, self.leaders)])
        good = (bag, '--urdf', self.urdf, '--joint-states')
        self.check_refused('leave out --tf-topic', *good, 'a', '--tf-topic', '/b')
        code, _, err = run(*good, '/none')
        self.assertEqual(code, 1)
        self.assertIn('error: there is no message on /none; see rosbag info', err)
        code, _, err = run(self.bag(arms(2)), '--urdf', self.urdf, '--joint-states', '/tf')
        self.assertEqual(code, 1)
        self.assertIn('the messages on /tf are of type tf2_msgs/TFMessage, not sensor_msgs', err)


if __name__ == '__main__':
    main()
