#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long a message counts, without a ROS master: sign_of_life_test.py FOLDER_OF_ASSERTIONS"""
import math
import sys
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rosgraph_msgs.msg import Clock

sys.path.append(sys.argv.pop())
from sign_of_life import SignOfLife  # noqa: E402

NODE = '/arm/bounds'
STATUS = 'arm/bounds: boxes'


def of(publisher, message):
    message._connection_header = {'callerid': publisher}
    return message


def boxes(publisher=NODE):
    return of(publisher, DiagnosticArray())  # any type does


def status(name=STATUS, publisher=NODE):
    return of(publisher, DiagnosticArray(status=[DiagnosticStatus(name=name)]))


def published(count):
    message = status()
    message.status[0].values = [KeyValue('publications', str(count))]
    return message


def clock(seconds):
    return Clock(rospy.Time.from_sec(seconds))


class SignOfLifeTest(unittest.TestCase):
    def setUp(self):
        self.life = SignOfLife(1.0)

    def check_counts(self, until, begin):
        """Life lasts until then; looked at from `begin` on."""
        self.assertIsNone(self.life.silent_since(begin))
        self.assertIsNone(self.life.silent_since(until))
        self.assertEqual(self.life.told(), [])
        self.assertEqual(self.life.silent_since(until + 0.001), until)
        self.assertEqual(self.life.silent_since(until + 9), until)

    def test_before_the_first_message_nothing_is_silent(self):
        """That it never came is another fault."""
        self.life.see_status(status(), 0.0)
        self.assertIsNone(self.life.silent_since(99.0))

    def test_the_first_message_counts_as_a_status(self):
        self.life.see(boxes(), 1.0)
        self.check_counts(3.0, 1.0)

    def test_each_further_message_counts_for_max_age(self):
        for now in (1.0, 1.9, 2.8, 3.7):
            self.life.see(boxes(), now)
        self.check_counts(4.7, 3.7)

    def test_a_status_says_that_nothing_has_changed(self):
        """As of a robot that stands still; also while /clock stands."""
        self.life.see(boxes(), 1.0)
        for now in range(2, 90):
            self.assertIsNone(self.life.silent_since(now))
            self.life.see_status(status(), now)
        self.check_counts(91.0, 89.0)

    def test_a_status_of_another_node_or_of_something_else_says_nothing(self):
        self.life.see(boxes(), 1.0)
        for other in (status(publisher='/other'), status(name='arm/bounds: motors'),
                      status(name=''), of(NODE, DiagnosticArray())):
            self.life.see_status(other, 3.0)
        self.check_counts(3.0, 1.0)

    def test_of_the_statuses_that_a_player_sends_only_that_of_the_node_counts(self):
        others = 'bounds: boxes', 'arm: boxes', 'leg/bounds: boxes'
        for topic, until in ((NODE + '/boxes', 6.0), ('/elsewhere', 3.0)):
            self.life = SignOfLife(1.0, topic=topic)
            self.life.see(boxes('/play'), 1.0)
            self.life.see_status(status(STATUS, '/play'), 2.0)  # the only one so far
            for now, names in ((3.0, others), (4.0, (STATUS, *others)), (5.0, others)):
                for name in names:
                    self.life.see_status(status(name, '/play'), now)
            with self.subTest(topic):
                self.assertIsNone(self.life.silent_since(until))
                self.assertEqual(self.life.silent_since(9.0), until)
        self.assertIn('/play sent statuses of arm, arm/bounds, bounds, leg/bounds, which tell '
                      'nothing of /elsewhere', self.life.told())

    def test_a_node_with_another_name_of_its_topic_sends_its_own_status(self):
        self.life = SignOfLife(1.0, topic='/elsewhere')
        self.life.see(boxes(), 1.0)
        self.life.see_status(status(), 2.0)
        self.check_counts(4.0, 2.0)

    def test_a_status_does_not_count_if_boxes_were_published_and_no_message_came(self):
        """As of a subscriber that was cut off."""
        self.life.see(boxes(), 1.0)
        for now, count in ((2.0, 7), (3.0, 7), (4.0, 8), (5.0, 9), (6.0, 9)):
            self.assertIsNone(self.life.silent_since(min(now, 5.0)))
            self.life.see_status(published(count), now)
        self.assertEqual(self.life.silent_since(6.0), 5.0)
        self.assertIn('published ~boxes meanwhile', self.life.told()[-1])

    def test_a_status_counts_after_each_message_whatever_was_published_before(self):
        self.life.see(boxes(), 1.0)
        for now in range(2, 90):
            self.life.see_status(published(now), now)
            self.life.see(boxes(), now + 0.5)
            self.life.see_status(published(now + 0.5), now + 0.6)
            self.assertIsNone(self.life.silent_since(now + 0.6))
        self.check_counts(91.6, 90.0)

    def test_a_status_of_a_node_that_has_published_nothing_more_counts(self):
        self.life.see(boxes(), 1.0)
        for now in range(2, 90):
            self.assertIsNone(self.life.silent_since(now))
            self.life.see_status(published(7), now)
        self.check_counts(91.0, 89.0)

    def test_the_first_message_of_a_new_node_counts_as_a_status(self):
        self.life.see(boxes(), 1.0)
        self.life.see(boxes('/new'), 9.0)
        self.check_counts(11.0, 9.0)

    def test_ros_time_makes_a_message_old_too(self):
        self.life.see(boxes(), 1.0)
        self.life.see_clock(clock(100.0), 3.5)
        self.life.see(boxes(), 3.5)
        self.life.see_clock(clock(101.0), 3.6)
        self.assertIsNone(self.life.silent_since(3.6))
        self.life.see_clock(clock(101.01), 3.6)
        self.assertEqual(self.life.silent_since(3.6), 3.6)
        self.life.see_status(status(), 3.7)  # counts by the wall alone
        self.assertIsNone(self.life.silent_since(5.7))
        self.assertEqual(self.life.silent_since(5.8), 5.7)

    def test_a_clock_that_jumps_back_makes_nothing_older(self):
        self.life.see(boxes(), 1.0)
        self.life.see_clock(clock(100.0), 3.5)
        self.life.see(boxes(), 3.5)
        self.life.see_clock(clock(5.0), 3.6)
        self.check_counts(4.5, 3.6)

    def test_an_infinite_age_is_not_checked(self):
        self.life = SignOfLife(math.inf)
        self.life.see(boxes(), 1.0)
        self.assertIsNone(self.life.silent_since(1e9))

    def test_clock_is_heard_where_time_is_simulated(self):
        names = [[topic[0] for topic in self.life.topics(lambda *row, is_needed: row, is_simulated)]
                 for is_simulated in (True, False)]
        self.assertEqual(names, [['/diagnostics', '/clock'], ['/diagnostics']])


if __name__ == '__main__':
    unittest.main()
