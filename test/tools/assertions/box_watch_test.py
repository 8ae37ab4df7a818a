#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The checks and reports of assert_box, without a ROS master: box_watch_test.py ASSERT_BOX"""
import math
import os
import sys
import tempfile
import unittest
from xml.etree import ElementTree

from assertion_testing import load_script
from geometry_msgs.msg import Point
from link_bounds.msg import AxisAlignedBox, AxisAlignedBoxArray
from std_msgs.msg import Header

INF, NAN = math.inf, math.nan
TOLERANCE = 1e-3  # m
ROUNDING = 1e-12  # m


assert_box = load_script(sys.argv.pop())
topic_assertion = sys.modules['topic_assertion']
Box = assert_box.Box
WANTED = Box((-1, -2, 0), (1, 2, 3))
HALF = (math.cos(math.pi / 6) + math.sin(math.pi / 6)) / 2
CUBE = Box((-HALF, -HALF, 1), (HALF, HALF, 2))  # around a cube of 1 m, turned by 30 degrees about z
PALM_INSIDE = {'name': 'palm', 'min': [-1, -2, 0], 'max': [1.0, 2.0, 3.0], 'check': 'inside',
               'hold': 1}


def moved(box, x, y, z):
    return Box(*(tuple(map(sum, zip(corner, (x, y, z)))) for corner in box))


def grown(metres):
    """Each side of WANTED further out, or further in."""
    return Box(tuple(c - metres for c in WANTED.min), tuple(c + metres for c in WANTED.max))


def with_coordinate(box, number, value):
    """The first three are those of min."""
    corners = [*box.min, *box.max]
    corners[number] = value
    return Box(tuple(corners[:3]), tuple(corners[3:]))


def assertion(check, wanted=WANTED):
    return assert_box.Assertion('/boxes', 'palm', check, wanted, TOLERANCE, 10.0, 0.0)


def message_of(name, box=CUBE, incomplete=(), seq=0):
    return AxisAlignedBoxArray(
        header=Header(frame_id='world', seq=seq), incomplete=list(incomplete),
        boxes=[AxisAlignedBox(name=name, min=Point(*box.min), max=Point(*box.max))])


class Checks(unittest.TestCase):
    def check(self, is_kept, check, box, wanted=WANTED):
        with self.subTest(box=box):
            self.assertEqual(assertion(check, wanted).is_kept([box]), is_kept)

    def check_excess(self, check, box, metres):
        self.assertAlmostEqual(assertion(check).excess(box), metres, delta=ROUNDING)

    def test_equal_compares_each_coordinate(self):
        self.check(True, 'equal', WANTED)
        coordinates = [*WANTED.min, *WANTED.max]
        for number, value in enumerate(coordinates):
            for step in (-TOLERANCE, TOLERANCE):
                far = with_coordinate(WANTED, number, value + 1.1 * step)
                self.check(True, 'equal', with_coordinate(WANTED, number, value + 0.9 * step))
                self.check(False, 'equal', far)
                self.check_excess('equal', far, 1.1 * TOLERANCE)

    def test_inside_grows_the_zone_by_the_tolerance(self):
        self.check(True, 'inside', CUBE)
        self.check(True, 'inside', grown(0.9 * TOLERANCE))
        for axis in range(3):
            for sign in (-1, 1):
                step = [0, 0, 0]
                step[axis] = sign * 1.1 * TOLERANCE
                self.check(False, 'inside', moved(WANTED, *step))
                self.check_excess('inside', moved(WANTED, *step), 1.1 * TOLERANCE)

    def test_outside_needs_one_axis_without_overlap(self):
        touching = 1 + HALF  # m along x
        for sign in (-1, 1):
            self.check(True, 'outside', moved(CUBE, sign * touching, 0, 0))
            self.check(True, 'outside', moved(CUBE, sign * (touching - 0.9e-3), 0, 0))
            self.check(False, 'outside', moved(CUBE, sign * (touching - 1.1e-3), 0, 0))
        self.check(True, 'outside', moved(CUBE, 0, 0, 2))
        self.check(False, 'outside', CUBE)

    def test_a_flat_box_across_the_zone_is_not_outside(self):
        self.check(False, 'outside', Box((-5, -5, 1), (5, 5, 1)))

    def test_a_box_partly_inside_is_neither(self):
        self.check(False, 'inside', moved(CUBE, 1, 0, 0))
        self.check(False, 'outside', moved(CUBE, 1, 0, 0))

    def test_an_infinite_side_is_no_limit(self):
        half_space = Box((-INF, -INF, 0), (INF, INF, INF))
        self.check(True, 'inside', CUBE, half_space)
        self.check(False, 'inside', moved(CUBE, 0, 0, -1.5), half_space)
        self.check(True, 'outside', moved(CUBE, 0, 0, -2), half_space)
        self.check(False, 'outside', CUBE, half_space)

    def test_what_is_no_box_keeps_nothing(self):
        inverted = moved(WANTED, 10, 0, 0)
        inverted = Box((11, *inverted.min[1:]), (9, *inverted.max[1:]))
        for check in ('equal', 'inside', 'outside'):
            for number in range(6):
                for value in (NAN, INF, -INF):
                    self.check(False, check, with_coordinate(WANTED, number, value))
            self.check(False, check, inverted)
            self.check(False, check, Box((INF, -1, 0), (INF, 1, 1)))

    def test_each_of_several_boxes_must_keep_it(self):
        inside = assertion('inside')
        self.assertTrue(inside.is_kept([CUBE, WANTED]))
        self.assertFalse(inside.is_kept([CUBE, moved(WANTED, 0, 1, 0)]))
        self.assertFalse(inside.is_kept([]))


class Hold(unittest.TestCase):
    def test_begins_anew_after_a_break(self):
        hold = topic_assertion.Hold(2.0)
        self.assertFalse(hold.is_kept(0.0))
        hold.update(True, 1.0)
        hold.update(True, 2.0)
        self.assertFalse(hold.is_kept(2.9))
        hold.update(False, 2.9)
        self.assertFalse(hold.is_kept(4.0))
        hold.update(True, 5.0)
        self.assertFalse(hold.is_kept(6.9))
        self.assertAlmostEqual(hold.longest(6.0), 1.9)
        self.assertTrue(hold.is_kept(7.0))

    def test_of_no_length_is_kept_at_once(self):
        hold = topic_assertion.Hold(0.0)
        self.assertFalse(hold.is_kept(1.0))
        hold.update(True, 1.0)
        self.assertTrue(hold.is_kept(1.0))

    def test_stays_kept_whatever_comes_later(self):
        at_once = topic_assertion.Hold(0.0)
        at_once.update(True, 1.0)
        at_once.update(False, 1.0)
        self.assertTrue(at_once.is_kept(1.0))
        hold = topic_assertion.Hold(2.0)
        hold.update(True, 1.0)
        hold.update(False, 3.0)
        hold.update(True, 3.5)
        self.assertTrue(hold.is_kept(3.6))


class Parameters(unittest.TestCase):
    def test_become_an_assertion(self):
        self.assertEqual(assert_box.assertion_from(PALM_INSIDE), assert_box.Assertion(
            '/link_bounds_publisher/boxes', 'palm', 'inside', WANTED, 1e-6, 10.0, 1, 1.0))

    def test_are_checked_alone_and_together(self):
        faults = (({'name': None}, 'must be a string'), ({'name': ''}, 'must not be empty'),
                  ({'tolerance': True}, 'must be a number'),
                  ({'tolerance': INF}, 'must be a finite number >= 0'),
                  ({'tolerance': -1e-3}, '~tolerance is -0.001, but must be'),
                  ({'deadline': 0}, '~deadline is 0, but must be'),
                  ({'min': [0, 0]}, r'~min is \[0, 0\], but must be a list of 3 numbers'),
                  ({'max': '[1, 1, 1]'}, r'"\[1, 1, 1\]", but must be a list of 3 numbers'),
                  ({'check': 'in'}, '~check is "in", but must be equal, inside or outside'),
                  ({'min': [0.0, 0.0, NAN]}, 'must hold neither NaN nor .inf'),
                  ({'topic': ''}, 'must not be empty'),
                  ({'min': [INF, 0.0, 0.0], 'max': [INF, 2.0, 2.0]},
                   '~min .* must hold neither NaN nor .inf'),
                  ({'min': [-INF, 0.0, 0.0], 'max': [-INF, 2.0, 2.0]},
                   '~max .* must hold neither NaN nor -.inf'),
                  ({'min': [0.0, 2.1, 0.0]}, '~min must not be greater'),
                  ({'hold': 10.0}, '~hold must be less than ~deadline'),
                  ({'check': 'equal', 'max': [1.0, 2.0, INF]}, 'must be finite'),
                  ({'max_age': 0}, '~max_age is 0, but must be a number > 0'),
                  ({'tolerence': 0.1}, '~tolerence is unknown'))
        for change, text in faults:
            with self.subTest(change):
                with self.assertRaisesRegex(topic_assertion.ParameterError, text):
                    assert_box.assertion_from(dict(PALM_INSIDE, **change))

    def test_name_and_corners_are_required(self):
        for name in ('name', 'min', 'max'):
            without = {key: value for key, value in PALM_INSIDE.items() if key != name}
            with self.assertRaisesRegex(topic_assertion.ParameterError, f'~{name} is required'):
                assert_box.assertion_from(without)


class Watch(unittest.TestCase):
    def setUp(self):
        self.watch = assert_box.BoxWatch(assert_box.assertion_from(PALM_INSIDE))

    def check_failure(self, *texts):
        self.assertFalse(self.watch.is_passed(9.0))
        for text in texts:
            self.assertIn(text, self.watch.failure(9.0))

    def test_passes_after_the_hold_without_further_messages(self):
        self.watch.see(message_of('palm'), 1.0)
        self.assertFalse(self.watch.is_passed(1.9))
        self.assertTrue(self.watch.is_passed(2.0))

    def test_passes_though_the_break_came_before_it_was_asked(self):
        """The watch is asked now and then; many messages may come in between."""
        self.watch.see(message_of('palm'), 1.0)
        self.watch.see(message_of('palm'), 2.5)
        self.watch.see(message_of('thumb'), 2.5)
        self.assertTrue(self.watch.is_passed(2.5))
        self.assertTrue(self.watch.is_passed(9.0))

    def test_a_missing_box_is_a_break(self):
        self.watch.see(message_of('palm'), 1.0)
        self.watch.see(message_of('thumb'), 1.5)
        self.check_failure('Boxes: thumb', 'at most for 0.5 s', 'within 10 s',
                           'last box: [-0.683012702, -0.683012702, 1] to '
                           '[0.683012702, 0.683012702, 2] in frame "world"')

    def test_an_incomplete_box_is_a_break(self):
        self.watch.see(message_of('palm'), 1.0)
        self.watch.see(message_of('palm', incomplete=['palm']), 1.5)
        self.check_failure('incomplete')

    def test_nothing_holds_without_a_publisher(self):
        self.watch.see(message_of('palm'), 1.0)
        self.watch.lose_publisher(1.5)
        self.check_failure('nobody publishes')

    def see_numbers(self, *numbers, is_of_node=True):
        """A message every 0.3 s from 1 s on."""
        self.watch.life.is_of_node = lambda: is_of_node
        for place, seq in enumerate(numbers):
            self.watch.see(message_of('palm', seq=seq), 1 + 0.3 * place)

    def test_a_lost_message_is_a_break(self):
        self.see_numbers(7, 8, 9, 12)
        self.assertFalse(self.watch.is_passed(2.8))
        self.watch.see(message_of('thumb', seq=13), 2.8)
        self.check_failure('2 messages of the topic were lost', 'at most for 0.9 s')
        self.setUp()
        self.see_numbers(7, 8, 9, 12)
        self.assertTrue(self.watch.is_passed(2.9))  # a second after the newest one

    def test_a_publisher_without_numbers_or_of_several_robots_has_lost_none(self):
        for numbers in (7, 8, 9, 10), (0, 0, 0, 0), (9, 0, 1, 2), (9, 9, 9, 10), (500, 12, 501, 13):
            with self.subTest(numbers):
                self.setUp()
                self.see_numbers(*numbers)
                self.assertTrue(self.watch.is_passed(2.0))
        self.setUp()
        self.see_numbers(1, 5, 6, 9, is_of_node=False)
        self.assertTrue(self.watch.is_passed(2.0))

    def test_silence_is_a_break(self):
        self.watch = assert_box.BoxWatch(assert_box.assertion_from(dict(PALM_INSIDE, hold=4)))
        self.watch.see(message_of('palm'), 1.0)
        self.watch.look(5.1)  # also if nobody looked when it began
        self.check_failure('for 4.1 s no message came, and no status of its publisher in '
                           '/diagnostics', 'max_age 1 s', 'at most for 2 s')
        self.watch.see(message_of('palm'), 10.0)
        self.assertTrue(self.watch.is_passed(14.0))

    def test_a_message_that_comes_after_the_loss_does_not_hold_for_long(self):
        self.watch.lose_publisher(0.5)
        self.watch.see(message_of('palm'), 1.0)
        self.watch.lose_publisher(1.5)
        self.assertFalse(self.watch.is_passed(9.0))

    def test_says_how_far_off_the_box_is(self):
        self.watch.see(message_of('palm', moved(CUBE, 0, 0, 1.25)), 1.0)
        self.check_failure('off by 0.25 m')

    def test_says_which_faces_are_off(self):
        self.watch.see(message_of('palm', moved(CUBE, 0.5, 0, 1.25)), 1.0)
        self.check_failure('off by 0.25 m: max x by 0.183 m, max z by 0.25 m')
        faces = [f'{end} {axis}' for end in ('min', 'max') for axis in 'xyz']
        for number, face in enumerate(faces):
            value = [*WANTED.min, *WANTED.max][number]
            for step in (-0.1, 0.1):
                box = with_coordinate(WANTED, number, value + step)
                outward = (step > 0) == (number > 2)
                self.assertEqual(assertion('equal').wrong_faces(box), face + ' by 0.1 m')
                self.assertEqual(assertion('inside').wrong_faces(box),
                                 face + ' by 0.1 m' if outward else '')

    def test_says_where_the_shortest_way_out_is(self):
        for step, text in (((0.9, 0, 0), 'min x by 0.1 m'), ((-0.9, 0, 0), 'max x by 0.1 m'),
                           ((0, 0, -1.8), 'max z by 0.2 m')):
            box = moved(Box((0, 0, 1), (0, 0, 2)), *step)
            self.assertEqual(assertion('outside').wrong_faces(box), text)

    def test_says_what_is_no_box(self):
        broken = with_coordinate(CUBE, 2, NAN)
        self.assertEqual(assertion('equal').wrong_faces(broken), 'not finite, or a min above its max')

    def test_says_that_nothing_came(self):
        self.check_failure('no message came')


class Report(unittest.TestCase):
    def test_has_only_characters_of_xml(self):
        failure = 'first\x01 <line>\nsecond \ufffe \udcff \x1b[2J'
        root = ElementTree.fromstring(topic_assertion.junit_xml('a<b\x02', '"c" & d', 0.5, failure))
        case = root.find('testcase')
        self.assertEqual((root.get('name'), case.get('classname'), case.get('name')),
                         ('a<b ', 'a<b ', '"c" & d'))
        self.assertEqual(case.find('failure').get('message'), 'first  <line>')
        self.assertEqual(case.find('failure').text, 'first  <line>\nsecond      [2J')
        self.assertEqual((root.get('tests'), root.get('failures'), root.get('time')),
                         ('1', '1', '0.500'))

    def test_is_written_into_what_is_no_file(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe, link, file = (os.path.join(folder, name) for name in ('pipe', 'link', 'file'))
            os.mkfifo(pipe)
            os.symlink('file', link)
            reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
            self.addCleanup(os.close, reader)
            for path in pipe, link:
                topic_assertion.write_file(path, b'report')
            self.assertEqual(os.read(reader, 100), b'report')
            with open(file, 'rb') as opened:
                self.assertEqual(opened.read(), b'report')
            self.assertTrue(os.path.islink(link))
            self.assertEqual(sorted(os.listdir(folder)), ['file', 'link', 'pipe'])
        read_end, write_end = os.pipe()
        topic_assertion.write_file('/dev/fd/%d' % write_end, b'report')
        self.assertEqual(os.read(read_end, 100), b'report')
        for end in read_end, write_end:
            os.close(end)

    def test_has_no_failure_when_all_is_well(self):
        root = ElementTree.fromstring(topic_assertion.junit_xml('suite', 'test', 0.5, ''))
        self.assertEqual(root.get('failures'), '0')
        self.assertEqual(list(root.find('testcase')), [])

    def test_an_exception_that_nobody_expects_is_a_failure(self):
        verdict = topic_assertion.Verdict()
        unittest.FunctionTestCase(lambda: 1 / 0).run(verdict)
        self.assertIn('ZeroDivisionError', verdict.failure)


if __name__ == '__main__':
    unittest.main()
