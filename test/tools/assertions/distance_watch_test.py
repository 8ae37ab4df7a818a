#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The checks and reports of assert_distance, without a ROS master: distance_watch_test.py
ASSERT_DISTANCE"""
import math
import sys
import unittest

from assertion_testing import load_script
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from link_bounds.msg import BoxOverlap, Distance, DistanceArray
from std_msgs.msg import Header

INF, NAN = math.inf, math.nan
LIMIT = 0.1  # m
NODE = '/link_bounds_publisher'
ARM_AND_TABLE = {'first': 'arm', 'second': 'table', 'at_least': 0.05}

assert_distance = load_script(sys.argv.pop())
ParameterError = sys.modules['topic_assertion'].ParameterError


def pair(first, second, distance, distance_max=None, level=Distance.MESH):
    return Distance(first=first, second=second, distance=distance, level=level,
                    distance_max=distance if distance_max is None else distance_max)


def distances(complete, *pairs, incomplete=(), not_compared=(), limit=LIMIT):
    """`complete` are names with spaces between them, and so is each pair of not_compared."""
    message = DistanceArray(
        header=Header(frame_id='world'), distances=list(pairs), limit=limit, accuracy=1e-4,
        incomplete=list(incomplete), complete=complete.split(),
        not_compared=[BoxOverlap(*names.split(), 0.01) for names in not_compared])
    message._connection_header = {'callerid': NODE}
    return message


def status(behind=0.0):
    message = DiagnosticArray(status=[DiagnosticStatus(
        name='link_bounds_publisher: boxes',
        values=[KeyValue('distances behind boxes [s]', str(behind))])])
    message._connection_header = {'callerid': NODE}
    return message


class Parameters(unittest.TestCase):
    def test_become_an_assertion(self):
        self.assertEqual(assert_distance.assertion_from(dict(ARM_AND_TABLE, at_most=1)),
                         ('/link_bounds_publisher/distances', 'arm', 'table', .05, 1, 10.0, 0.0,
                          1.0))

    def test_are_checked_alone_and_together(self):
        for parameters, text in (
                ({'first': 'arm'}, '~at_least or ~at_most is required'),
                ({'at_least': -1}, 'must be a finite number >= 0'),
                ({'at_least': INF}, 'must be a finite number >= 0'),
                ({'at_least': NAN}, 'must be a finite number >= 0'),
                ({'at_least': True}, 'must be a number'),
                ({'at_most': NAN}, 'must be a number >= 0'),
                ({'at_most': -.1}, 'must be a number >= 0'),
                ({'at_most': .1, 'first': 3}, 'must be a string'),
                ({'at_most': .1, 'topic': ''}, 'must not be empty'),
                ({'at_most': .1, 'at_least': .2}, '~at_least must not be greater than ~at_most'),
                ({'at_most': .1, 'first': 'a', 'second': 'a'}, 'must differ'),
                ({'at_most': .1, 'hold': 10}, '~hold must be less than ~deadline'),
                ({'at_most': .1, 'max_age': 0}, 'must be a number > 0'),
                ({'at_mots': .1}, '~at_mots is unknown')):
            with self.subTest(parameters):
                with self.assertRaisesRegex(ParameterError, text):
                    assert_distance.assertion_from(parameters)

    def test_at_most_zero_is_a_check(self):
        self.assertEqual(assert_distance.assertion_from({'at_most': 0}).asked(), 'at most 0 m')


FAR = distances('arm cup', pair('arm', 'cup', .09))
NEAR = distances('arm cup', pair('arm', 'cup', .01))


class WatchTest(unittest.TestCase):
    def watch(self, **parameters):
        return assert_distance.DistanceWatch(assert_distance.assertion_from(parameters))

    def check(self, is_passed, watch, *messages):
        """After these messages at 1 s."""
        for message in messages:
            watch.see(message, 1.0)
        self.assertEqual(watch.is_passed(1.0), is_passed, watch.failure(1.0))
        return watch

    def check_failure(self, watch, *texts):
        for text in texts:
            self.assertIn(text, watch.failure(9.0))


class AtLeast(WatchTest):
    def test_each_pair_of_the_names_must_be_so_far_apart(self):
        for distance, is_kept in ((.05, True), (.049, False), (0, False)):
            for names in (('arm', 'table'), ('table', 'arm')):
                self.check(is_kept, self.watch(**ARM_AND_TABLE),
                           distances('arm lamp table', pair('arm', 'lamp', .01),
                                     pair(*names, distance, .09)))

    def test_the_proven_distance_counts(self):
        """Also of hulls, while triangles are loading: none is nearer than its hull."""
        watch = self.check(False, self.watch(**ARM_AND_TABLE),
                           distances('arm table', pair('arm', 'table', .04, .06, Distance.HULL)))
        self.check_failure(watch, 'the distance of "arm" and "table", of '
                           '/link_bounds_publisher/distances, was not at least 0.05 m within 10 s',
                           'last distance: "arm" and "table" are 0.04 to 0.06 m apart (HULL) in '
                           'frame "world"')
        self.check(True, watch, distances('arm table', pair('arm', 'table', .055)))
        self.check(True, self.watch(**ARM_AND_TABLE),
                   distances('arm table', pair('arm', 'table', .05, .06, Distance.HULL)))

    def test_an_empty_name_is_any(self):
        near = distances('arm lamp cup', pair('arm', 'lamp', .09), pair('cup', 'lamp', .01))
        self.check(True, self.watch(first='arm', at_least=.05), near)
        self.check(True, self.watch(second='arm', at_least=.05), near)
        self.check(False, self.watch(second='lamp', at_least=.05), near)
        watch = self.check(False, self.watch(at_least=.05), near)
        self.check_failure(watch, 'of any and any', '"cup" and "lamp" are 0.01 to 0.01 m apart',
                           'the nearest of 2 such pairs')

    def test_what_is_no_distance_keeps_nothing(self):
        for distance, distance_max in ((NAN, 1), (1, NAN), (INF, INF), (1, .5), (-1, 1)):
            wrong = distances('a b', pair('a', 'b', distance, distance_max))
            self.check(False, self.watch(at_least=1e-9), wrong)
            self.check(False, self.watch(at_most=9), wrong)


class Limit(WatchTest):
    def test_beyond_that_of_the_message_it_can_never_be_known(self):
        for limit in (.0499, 0, NAN):
            watch = self.check(False, self.watch(**ARM_AND_TABLE),
                               distances('arm table', pair('arm', 'table', .06), limit=limit))
            self.assertIn('~at_least is 0.05 m, but /link_bounds_publisher/distances has the '
                          f'limit {limit:.9g} m and says nothing of pairs that are farther apart; raise '
                          'distance_limit', watch.fault)
        watch = self.check(True, self.watch(**ARM_AND_TABLE), distances('arm table', limit=.05))
        self.assertEqual(watch.fault, '')

    def test_that_is_lowered_later_counts(self):
        watch = self.watch(**ARM_AND_TABLE, hold=2)
        watch.see(distances('arm table'), 0.0)
        watch.see(distances('arm table', limit=.01), 1.0)
        self.assertFalse(watch.is_passed(2.0))
        self.assertIn('0.01 m', watch.fault)

    def test_at_most_needs_none(self):
        self.check(True, self.watch(at_most=.1), distances('a b', pair('a', 'b', .05), limit=0))


class Silence(WatchTest):
    """The pair is not listed."""

    def test_of_two_names_that_were_compared_means_farther_apart(self):
        self.check(True, self.watch(**ARM_AND_TABLE), distances('arm table'))

    def test_of_a_pair_that_was_not_compared_means_nothing(self):
        for left_out in ('arm table', 'table arm'):
            watch = self.check(False, self.watch(**ARM_AND_TABLE),
                               distances('arm lamp table', not_compared=[left_out]))
            self.check_failure(watch, 'nothing was checked: no pair of "arm" and "table" was ',
                               'ignore_pairs are never compared', 'Complete: arm, lamp, table',
                               'the last message has no such pair')
        self.check(True, watch, distances('arm lamp table', not_compared=['arm lamp']))

    def test_of_a_name_that_is_not_complete_means_nothing(self):
        for complete, missing in (('arm lamp', 'table'), ('lamp table', 'arm'), ('', 'arm')):
            watch = self.check(False, self.watch(**ARM_AND_TABLE), distances(complete))
            self.check_failure(watch, 'nothing was checked', f'"{missing}" is not in complete')
        self.check(False, self.watch(first='arm', at_least=.05), distances('lamp table'))

    def test_of_a_listed_pair_there_is_none(self):
        """Its number is proven, though other pairs of its names do not fit into not_compared."""
        self.check(True, self.watch(**ARM_AND_TABLE), distances('', pair('arm', 'table', .06)))

    def test_is_not_near_enough(self):
        watch = self.check(False, self.watch(first='arm', at_most=.05), distances('arm table'))
        self.check_failure(watch, 'was not at most 0.05 m', 'the last message has no such pair')


class Evidence(WatchTest):
    """Where any pair is asked for, a verdict rests on at least one that was compared."""

    def check_nothing(self, message, **parameters):
        watch = self.check(False, self.watch(at_least=.05, **parameters), message)
        self.check_failure(watch, 'nothing was checked: no pair of', 'compared: no pair. ')

    def test_without_names_nothing_is_checked(self):
        """As without geometry, of one rigid body, or with ignore_pairs ["* *"]."""
        for names in ({}, {'first': 'arm'}, {'second': 'arm'}):
            self.check_nothing(distances(''), **names)
            self.check_nothing(distances('', not_compared=['arm cup']), **names)
        self.check_nothing(distances('arm'))

    def test_where_all_are_left_out_nothing_is_checked(self):
        for names in ({}, {'first': 'arm'}):
            self.check_nothing(distances('arm cup', not_compared=['arm cup']), **names)
        self.check_nothing(distances(
            'arm cup lamp', not_compared=['arm cup', 'arm lamp', 'cup lamp']))

    def test_pairs_that_are_left_out_are_no_part_of_any(self):
        self.check(True, self.watch(at_least=.05),
                   distances('arm cup lamp', not_compared=['arm cup']))

    def test_is_told_of_other_names(self):
        watch = self.check(False, self.watch(first='cup', at_least=.05),
                           distances('arm lamp', pair('arm', 'lamp', .09)))
        self.check_failure(watch, 'no pair of "cup" and any', 'compared: "arm" and "lamp". ')

    def test_is_told_of_a_success(self):
        message = distances('arm cup lamp table', pair('arm', 'cup', .09),
                            pair('arm', 'lamp', .095), not_compared=['lamp cup'])
        for parameters, text in (({}, '5 pairs, the nearest "arm" and "cup"'),
                                 ({'first': 'lamp'}, '2 pairs, the nearest "arm" and "lamp"'),
                                 ({'first': 'table'}, '3 pairs, farther apart than 0.1 m'),
                                 ({'first': 'cup', 'second': 'table'},
                                  '1 pair, farther apart than 0.1 m'),
                                 ({'first': 'lamp', 'second': 'arm'}, '"arm" and "lamp"')):
            watch = self.check(True, self.watch(at_least=.05, **parameters), message)
            self.assertEqual(watch.evidence(), '; compared: ' + text)


class AtMost(WatchTest):
    def test_one_pair_is_enough_and_its_upper_bound_counts(self):
        for cup, is_kept in ((pair('arm', 'cup', .01, .02), True),
                             (pair('arm', 'cup', .01, .021), False)):
            self.check(is_kept, self.watch(first='arm', at_most=.02),
                       distances('arm cup lamp', cup, pair('arm', 'lamp', .09)))

    def test_needs_no_other_evidence(self):
        self.check(True, self.watch(at_most=.1), FAR)
        self.check(False, self.watch(at_most=.1), distances('arm cup'))

    def test_together_with_at_least_it_is_a_range(self):
        for distance, is_kept in ((.02, False), (.03, True), (.05, True), (.06, False)):
            self.check(is_kept, self.watch(at_least=.03, at_most=.05),
                       distances('arm cup', pair('arm', 'cup', distance)))


class Incomplete(WatchTest):
    def test_a_name_in_incomplete_is_not_known(self):
        for parameters in (ARM_AND_TABLE, {'first': 'arm', 'at_least': .05}, {'at_most': .2}):
            watch = self.check(False, self.watch(**parameters),
                               distances('lamp table', pair('arm', 'table', .09),
                                         incomplete=['arm']))
            self.check_failure(watch, '"arm" is named in incomplete')

    def test_any_other_may_be_of_the_pair(self):
        near = distances('arm table', pair('arm', 'table', .09), incomplete=['lamp'])
        self.check(True, self.watch(**ARM_AND_TABLE), near)
        for parameters in ({'first': 'arm', 'at_least': .05}, {'at_least': .05}):
            self.check_failure(self.check(False, self.watch(**parameters), near),
                               '"lamp" is named in incomplete')


class Time(WatchTest):
    def test_a_hold_begins_anew_after_a_break(self):
        watch = self.watch(first='arm', at_least=.05, hold=2)
        for message, now in ((FAR, 0.0), (FAR, 1.0), (NEAR, 1.5), (FAR, 1.6)):
            watch.see(message, now)
            self.assertFalse(watch.is_passed(now))
        self.check_failure(watch, 'for 2 s without a break, at most for')
        self.assertFalse(watch.is_passed(3.5))
        self.assertTrue(watch.is_passed(3.6))

    def test_nothing_holds_without_a_publisher(self):
        watch = self.watch(at_least=.05, hold=2)
        watch.see(FAR, 0.0)
        watch.lose_publisher(1.0)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, 'nobody publishes this topic any more')

    def test_silence_is_a_break(self):
        watch = self.watch(at_least=.05, hold=4)
        watch.see(FAR, 0.0)
        watch.look(2.0)
        self.assertTrue(watch.is_passed(4.0))
        watch.look(2.1)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, 'for 2.1 s no message came, and no status of ' + NODE)

    def test_a_node_whose_distances_stay_behind_is_silent(self):
        """Though it lives: its boxes go on."""
        watch = self.watch(at_least=.05, hold=4)
        watch.see(FAR, 0.0)
        watch.life.see_status(status(behind=.9), 1.0)
        watch.life.see_status(status(behind=1.9), 2.0)
        watch.look(3.0)
        self.assertTrue(watch.is_passed(4.0))
        watch.look(3.1)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, 'silence is no success', 'they were 1.9 s behind')

    def test_says_that_nothing_came(self):
        self.check_failure(self.watch(at_least=.05), 'no message came')


class Topics(WatchTest):
    def test_is_the_one_that_is_named(self):
        """The verdict rests on the message alone."""
        watch = self.watch(topic='/robot/bounds/distances', **ARM_AND_TABLE)
        self.assertEqual([(topic.name, topic.is_needed) for topic in watch.topics],
                         [('/robot/bounds/distances', True)])


if __name__ == '__main__':
    unittest.main()
