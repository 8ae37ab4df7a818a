#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The checks and reports of assert_distance, without a ROS master: distance_watch_test.py
ASSERT_DISTANCE"""
import math
import sys
import unittest

import rospy
from assertion_testing import load_script
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Point
from link_bounds.msg import (AxisAlignedBox, AxisAlignedBoxArray, BoxOverlap, BoxOverlapArray,
                             Distance, DistanceArray)
from std_msgs.msg import Header

INF, NAN = math.inf, math.nan
LIMIT = 0.1  # m
NODE = '/link_bounds_publisher'
ARM_AND_TABLE = {'first': 'arm', 'second': 'table', 'at_least': 0.05}

assert_distance = load_script(sys.argv.pop())
ParameterError = sys.modules['topic_assertion'].ParameterError


def header(seconds=0.0):
    return Header(frame_id='world', stamp=rospy.Time.from_sec(seconds))


def pair(first, second, distance, distance_max=None, level=Distance.MESH):
    return Distance(first=first, second=second, distance=distance, level=level,
                    distance_max=distance if distance_max is None else distance_max)


def distances(*pairs, incomplete=(), stamp=0.0, publisher=NODE):
    message = DistanceArray(header=header(stamp), distances=list(pairs),
                            incomplete=list(incomplete))
    message._connection_header = {'callerid': publisher}
    return message


def boxes(*places, incomplete=(), stamp=0.0):
    """Cubes of 1 m: (name, x of the centre), or a name at 0."""
    places = [place if isinstance(place, tuple) else (place, 0) for place in places]
    return AxisAlignedBoxArray(
        header=header(stamp), incomplete=list(incomplete),
        boxes=[AxisAlignedBox(name=name, min=Point(x - .5, -.5, -.5), max=Point(x + .5, .5, .5))
               for name, x in places])


def status():
    message = DiagnosticArray(status=[DiagnosticStatus(name='link_bounds_publisher: boxes')])
    message._connection_header = {'callerid': NODE}
    return message


def overlap(first, second):
    return BoxOverlapArray(overlaps=[BoxOverlap(first=first, second=second)])


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


FAR = pair('arm', 'cup', .09)


class WatchTest(unittest.TestCase):
    def watch(self, limit=LIMIT, **parameters):
        self.limits = []

        def limit_of(publisher):
            self.limits.append(publisher)
            return limit

        return assert_distance.DistanceWatch(assert_distance.assertion_from(parameters), limit_of)

    def check(self, is_passed, watch, *messages):
        """After these messages at 1 s."""
        handlers = {topic.kind: topic.see for topic in watch.topics}
        for message in messages:
            if type(message) in handlers:
                handlers[type(message)](message, 1.0)
        self.assertEqual(watch.is_passed(1.0), is_passed, watch.failure(1.0))
        return watch

    def check_failure(self, watch, *texts):
        for text in texts:
            self.assertIn(text, watch.failure(9.0))


class AtLeast(WatchTest):
    def test_each_pair_of_the_names_must_be_so_far_apart(self):
        for distance, is_kept in ((.05, True), (.049, False), (0, False)):
            for names in (('arm', 'table'), ('table', 'arm')):
                self.check(is_kept, self.watch(**ARM_AND_TABLE), boxes('arm', 'table', 'lamp'),
                           distances(pair('arm', 'lamp', .01), pair(*names, distance, .09)))

    def test_the_proven_distance_counts(self):
        watch = self.check(False, self.watch(**ARM_AND_TABLE), boxes('arm', 'table'),
                           distances(pair('arm', 'table', .04, .06, Distance.HULL)))
        self.check_failure(watch, 'the distance of "arm" and "table", of '
                           '/link_bounds_publisher/distances, was not at least 0.05 m within 10 s',
                           'last distance: "arm" and "table" are 0.04 to 0.06 m apart (HULL) in '
                           'frame "world"')

    def test_an_empty_name_is_any(self):
        near = distances(pair('arm', 'lamp', .09), pair('cup', 'lamp', .01))
        names = boxes('arm', 'lamp', 'cup')
        self.check(True, self.watch(first='arm', at_least=.05), names, near)
        self.check(True, self.watch(second='arm', at_least=.05), names, near)
        self.check(False, self.watch(second='lamp', at_least=.05), names, near)
        watch = self.check(False, self.watch(at_least=.05), names, near)
        self.check_failure(watch, 'of any and any', '"cup" and "lamp" are 0.01 to 0.01 m apart',
                           'the nearest of 2 such pairs')

    def test_what_is_no_distance_keeps_nothing(self):
        for distance, distance_max in ((NAN, 1), (1, NAN), (INF, INF), (1, .5), (-1, 1)):
            self.check(False, self.watch(at_least=1e-9), boxes('a', 'b'),
                       distances(pair('a', 'b', distance, distance_max)))
            self.check(False, self.watch(at_most=9), boxes('a', 'b'),
                       distances(pair('a', 'b', distance, distance_max)))

    def test_beyond_the_limit_of_the_publisher_it_can_never_be_known(self):
        for limit, text in ((.0499, '~at_least is 0.05 m, but pairs farther apart than 0.0499 m '
                                    'are not in /link_bounds_publisher/distances; raise /node/'
                                    'distance_limit and call /node/reload'),
                            (None, '~distance_limit of /node is not known')):
            watch = self.check(False, self.watch(limit, **ARM_AND_TABLE), boxes('arm', 'table'),
                               distances(pair('arm', 'table', .06), publisher='/node'))
            self.assertIn(text, watch.fault)
            self.assertEqual(set(self.limits), {'/node'})
        self.assertEqual(self.check(True, self.watch(.05, **ARM_AND_TABLE), boxes('arm', 'table'),
                                    distances(pair('arm', 'table', .05))).fault, '')

    def test_a_limit_that_is_lowered_later_counts(self):
        limits = [LIMIT, .01]
        watch = assert_distance.DistanceWatch(
            assert_distance.assertion_from(dict(ARM_AND_TABLE, hold=2)), lambda _: limits.pop(0))
        watch.see_boxes(boxes('arm', ('table', 9)), 0.0)
        watch.see(distances(), 0.0)
        self.assertFalse(watch.is_passed(2.0))
        self.assertIn('0.01 m', watch.fault)

    def test_at_most_needs_no_limit(self):
        self.check(True, self.watch(None, at_most=.1), boxes('a', 'b'),
                   distances(pair('a', 'b', .05)))
        self.assertEqual(self.limits, [])


class Evidence(WatchTest):
    """Where any pair is asked for, a verdict rests on at least one that was compared."""

    def check_nothing(self, watch, *messages):
        self.check_failure(self.check(False, watch, *messages), 'nothing was checked: no pair of',
                           'compared: no pair')

    def test_without_boxes_nothing_is_checked(self):
        self.check_nothing(self.watch(at_least=.05), boxes(), distances())

    def test_boxes_alone_are_none(self):
        """As of one rigid body, or with ignore_pairs ["* *"]."""
        for names in ({}, {'first': 'arm'}, {'second': 'arm'}):
            self.check_nothing(self.watch(at_least=.05, **names), boxes('arm', ('cup', 9)),
                               distances())

    def test_a_pair_that_was_compared_once_is_enough(self):
        watch = self.check(False, self.watch(at_least=.05), boxes('arm', 'cup'),
                           distances(pair('arm', 'cup', .01)))
        self.check(True, watch, distances())
        watch = self.check(False, self.watch(first='arm', at_least=.05), boxes('arm', 'cup'),
                           distances())
        self.check(True, watch, overlap('cup', 'arm'))

    def test_is_none_once_its_boxes_have_gone(self):
        watch = self.check(False, self.watch(at_least=.05), boxes('arm', 'cup'),
                           distances(pair('arm', 'cup', .01)))
        self.check(False, watch, boxes('arm', 'lamp', stamp=1), distances(stamp=1))
        self.check_failure(watch, 'nothing was checked: no pair of any and any',
                           'compared: "arm" and "cup". ')

    def test_of_other_names_is_told(self):
        others = distances(pair('arm', 'lamp', .09), pair('arm', 'table', .02))
        watch = self.check(False, self.watch(first='cup', at_least=.05),
                           boxes('arm', 'cup', 'lamp', 'table'), others)
        self.check_failure(watch, 'no pair of "cup" and any',
                           'compared: 2 pairs, the nearest "arm" and "table"')

    def test_of_a_success_is_told(self):
        for parameters, text in (({}, '; compared: 2 pairs, the nearest "arm" and "cup"'),
                                 ({'first': 'lamp'}, '; compared: "arm" and "lamp"')):
            watch = self.check(True, self.watch(at_least=.05, **parameters),
                               boxes('arm', 'cup', 'lamp'),
                               distances(FAR, pair('arm', 'lamp', .095)))
            self.assertEqual(watch.evidence(), text)


class Unpublished(WatchTest):
    """The pair is not in the message."""

    def test_is_farther_apart_if_it_has_been_near(self):
        watch = self.check(False, self.watch(**ARM_AND_TABLE), boxes('arm', 'table'),
                           distances(pair('arm', 'table', .01)))
        self.check(True, watch, distances())

    def test_is_farther_apart_if_it_has_been_an_overlap(self):
        watch = self.check(False, self.watch(**ARM_AND_TABLE), boxes('arm', 'table'), distances())
        self.check(False, watch, overlap('arm', 'lamp'))
        self.check(True, watch, overlap('table', 'arm'))

    def test_is_so_far_apart_if_its_boxes_are(self):
        for x, is_kept in ((1.04, False), (1.06, True), (-1.06, True)):
            self.check(is_kept, self.watch(**ARM_AND_TABLE), boxes('arm', ('table', x)),
                       distances())

    def test_may_be_one_that_is_never_compared(self):
        watch = self.check(False, self.watch(**ARM_AND_TABLE), boxes('arm', ('table', 1.01)),
                           distances())
        self.check_failure(watch, 'neither in ~distances nor in ~overlaps', 'its boxes are 0.01',
                           'it is never compared', 'the last message has no such pair')

    def test_is_no_pair_if_a_name_has_no_box(self):
        for names, missing in ((('arm',), 'table'), (('table',), 'arm')):
            watch = self.watch(**ARM_AND_TABLE)
            self.check(False, watch, boxes('arm', 'table'), distances(pair('arm', 'table', .01)))
            self.check(False, watch, boxes(*names, 'lamp', stamp=1), distances(stamp=1))
            self.check_failure(
                watch, '"%s" has no box in /link_bounds_publisher/boxes. Boxes: %s'
                % (missing, ', '.join(sorted(names + ('lamp',)))))
        self.check(False, self.watch(first='arm', at_least=.05), boxes('table'), distances())

    def test_is_not_near_enough(self):
        watch = self.check(False, self.watch(first='arm', at_most=.05), boxes('arm', 'table'),
                           distances())
        self.check_failure(watch, 'was not at most 0.05 m', 'the last message has no such pair')


class AtMost(WatchTest):
    def test_one_pair_is_enough_and_its_upper_bound_counts(self):
        names = boxes('arm', 'cup', 'lamp')
        far = pair('arm', 'lamp', .09)
        for cup, is_kept in ((pair('arm', 'cup', .01, .02), True),
                             (pair('arm', 'cup', .01, .021), False)):
            self.check(is_kept, self.watch(first='arm', at_most=.02), names, distances(cup, far))

    def test_needs_no_other_evidence(self):
        self.check(True, self.watch(at_most=.1), boxes('arm', 'cup'), distances(FAR))
        self.check(False, self.watch(at_most=.1), boxes('arm', 'cup'), distances())

    def test_together_with_at_least_it_is_a_range(self):
        for distance, is_kept in ((.02, False), (.03, True), (.05, True), (.06, False)):
            self.check(is_kept, self.watch(at_least=.03, at_most=.05), boxes('arm', 'cup'),
                       distances(pair('arm', 'cup', distance)))


class Incomplete(WatchTest):
    def test_a_name_in_incomplete_is_not_known(self):
        for parameters in (ARM_AND_TABLE, {'first': 'arm', 'at_least': .05}, {'at_most': .2}):
            watch = self.check(False, self.watch(**parameters), boxes('arm', 'table'),
                               distances(pair('arm', 'table', .09), incomplete=['arm']))
            self.check_failure(watch, '"arm" is named in incomplete')

    def test_any_other_may_be_of_the_pair(self):
        near = distances(pair('arm', 'table', .09), incomplete=['lamp'])
        names = boxes('arm', 'table', 'lamp')
        self.check(True, self.watch(**ARM_AND_TABLE), names, near)
        for parameters in ({'first': 'arm', 'at_least': .05}, {'at_least': .05}):
            self.check_failure(self.check(False, self.watch(**parameters), names, near),
                               '"lamp" is named in incomplete')

    def test_that_of_boxes_counts_too(self):
        self.check(False, self.watch(at_least=.05), boxes('arm', 'cup', incomplete=['lamp']),
                   distances(FAR))


class Time(WatchTest):
    def test_nothing_is_known_before_the_boxes_of_that_stamp(self):
        watch = self.watch(at_least=.05)
        self.check(False, watch, distances(FAR, stamp=2))
        self.check_failure(watch, 'no message of /link_bounds_publisher/boxes has the stamp')
        self.check(False, watch, boxes('arm', 'cup', stamp=1))
        self.check(True, watch, boxes('arm', 'cup', stamp=2))

    def test_boxes_may_come_long_before(self):
        watch = self.watch(first='arm', at_least=.05)
        self.check(False, watch, *(boxes('arm' if i == 0 else 'lamp', 'cup', stamp=i)
                                   for i in range(999)))
        self.check(True, watch, distances(FAR, stamp=0))
        self.check(False, self.watch(first='arm', at_least=.05),
                   *(boxes('arm', 'cup', stamp=i) for i in range(1001)), distances(FAR, stamp=0))

    def test_boxes_that_come_later_change_nothing(self):
        """A name that is new in ~boxes is not yet in the distances."""
        watch = self.watch(first='arm', at_least=.05)
        self.check(False, watch, boxes('cup'), distances(FAR), boxes('arm', 'cup'))

    def test_a_hold_begins_anew_after_a_break(self):
        watch = self.watch(first='arm', at_least=.05, hold=2)
        far, near = distances(FAR), distances(pair('arm', 'cup', .01))
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        for message, now in ((far, 0.0), (far, 1.0), (near, 1.5), (far, 1.6)):
            watch.see(message, now)
            self.assertFalse(watch.is_passed(now))
        self.check_failure(watch, 'for 2 s without a break, at most for')
        self.assertFalse(watch.is_passed(3.5))
        self.assertTrue(watch.is_passed(3.6))

    def test_distances_whose_boxes_never_come_are_a_break(self):
        watch = self.watch(at_least=.05, hold=2)
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        watch.see(distances(FAR), 0.0)
        watch.see(distances(FAR, stamp=1), 1.0)
        watch.see(distances(FAR, stamp=2), 1.1)
        self.assertFalse(watch.is_passed(3.0))

    def test_nothing_holds_without_a_publisher(self):
        watch = self.watch(at_least=.05, hold=2)
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        watch.see(distances(FAR), 0.0)
        watch.lose_publisher(watch.topics[0].name, 1.0)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, 'nobody publishes this topic any more')

    def test_nothing_holds_without_a_publisher_of_boxes(self):
        watch = self.watch(at_least=.05, hold=2)
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        watch.see(distances(FAR), 0.0)
        watch.lose_publisher(watch.topics[1].name, 1.0)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, f'nobody publishes {watch.topics[1].name} any more')

    def test_silence_is_a_break(self):
        watch = self.watch(at_least=.05, hold=4)
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        watch.see(distances(FAR), 0.0)
        watch.look(2.0)
        self.assertTrue(watch.is_passed(4.0))
        watch.look(2.1)
        self.assertFalse(watch.is_passed(9.0))
        self.check_failure(watch, 'for 2.1 s no message came, and no status of ' + NODE)

    def test_distances_that_do_not_follow_their_boxes_are_a_break(self):
        """Though the node lives."""
        watch = self.watch(at_least=.05, hold=4)
        watch.see_boxes(boxes('arm', 'cup'), 0.0)
        watch.see(distances(FAR), 0.0)
        watch.life.see_status(status(), 2.0)
        watch.see_boxes(boxes('arm', 'cup', stamp=1), 2.5)
        watch.see_boxes(boxes('arm', 'cup', stamp=2), 3.4)
        watch.look(3.5)
        self.assertTrue(watch.is_passed(4.0))
        watch.look(3.6)
        self.assertFalse(watch.is_passed(9.0))
        self.assertIn('no distances of the last /link_bounds_publisher/boxes came within max_age',
                      watch.failure(3.6))
        watch.see(distances(FAR, stamp=2), 4.0)
        watch.life.see_status(status(), 7.0)
        watch.look(8.0)
        self.assertTrue(watch.is_passed(8.0))

    def test_says_that_nothing_came(self):
        self.check_failure(self.watch(at_least=.05), 'no message came')


class Topics(WatchTest):
    def test_are_of_one_namespace(self):
        watch = self.watch(topic='/robot/bounds/distances', **ARM_AND_TABLE)
        self.assertEqual([(topic.name, topic.is_needed) for topic in watch.topics],
                         [('/robot/bounds/distances', True), ('/robot/bounds/boxes', True),
                          ('/robot/bounds/overlaps', False)])
        self.assertEqual(len(self.watch(first='arm', at_most=.05).topics), 2)


if __name__ == '__main__':
    unittest.main()
