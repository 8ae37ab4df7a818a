#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reader gives the same messages as rosbag, of whole bags in the same order, and at least those
that rosbag reindex saves: bag_beside_rosbag_test.py PATH_OF_bag_contents"""
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from std_msgs.msg import String

BAG_CONTENTS = ''
COMPRESSIONS = ('none', 'bz2', 'lz4')


def messages_of(count, seed=1):
    """Topic, publisher, text, and a time of its own, which sometimes goes on by seconds."""
    numbers = random.Random(seed)
    time = 1_000_000_000_000_000_000
    for index in range(count):
        time += numbers.choice((1, 1_000, 1_000_000, 3_000_000_000))
        size = numbers.choice((0, 1, 100, 100, 100, 5_000))
        text = ''.join(numbers.choice('abc') for _ in range(size))
        yield numbers.choice('ab'), f'/node_{numbers.randrange(3)}', f'{index} {text}', time


def header_of(topic, publisher):
    return {'topic': topic, 'type': String._type, 'md5sum': String._md5sum,
            'message_definition': String._full_text, 'callerid': publisher}


def write(bag, messages):
    for topic, publisher, text, time in messages:
        stamp = rospy.Time(time // 10**9, time % 10**9)
        bag.write('/' + topic, String(text), stamp,
                  connection_header=header_of('/' + topic, publisher))


def by_rosbag(path):
    with rosbag.Bag(path) as bag:
        return [f'{topic} {raw[0]} {header.get("callerid", b"").decode()} {time.to_nsec()} '
                f'{raw[1].hex()}'
                for topic, raw, time, header in bag.read_messages(
                    raw=True, return_connection_header=True)]


def by_us(*paths):
    """Messages and losses."""
    lines = subprocess.run([BAG_CONTENTS, *paths], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    return ([line for line in lines if not line.startswith('lost: ')],
            [line for line in lines if line.startswith('lost: ')])


class BesideRosbag(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='link_bounds_')
        self.addCleanup(shutil.rmtree, self.folder)
        self.path = os.path.join(self.folder, 'a.bag')

    def record(self, compression, messages, chunk=20_000):
        with rosbag.Bag(self.path, 'w', compression=compression, chunk_threshold=chunk) as bag:
            write(bag, messages)

    def test_whole_bags(self):
        for compression in COMPRESSIONS:
            for chunk in (1, 20_000, 786_432):
                self.record(compression, messages_of(300), chunk)
                messages, losses = by_us(self.path)
                self.assertEqual(len(messages), 300)
                self.assertEqual(messages, by_rosbag(self.path), (compression, chunk))
                self.assertEqual(losses, [])

    def test_a_message_that_is_larger_than_a_chunk(self):
        for compression in COMPRESSIONS:
            self.record(compression, [('a', '/node', 'x' * 3_000_000, 5), ('a', '/node', '', 6)])
            messages, losses = by_us(self.path)
            self.assertEqual(messages, by_rosbag(self.path), compression)
            self.assertEqual(losses, [])

    def test_several_files(self):
        messages = list(messages_of(200))
        expected = []
        paths = []
        for index, compression in enumerate(COMPRESSIONS):
            self.record(compression, messages[index::3])
            paths.append(os.path.join(self.folder, f'{index}.bag'))
            os.rename(self.path, paths[-1])
            expected += by_rosbag(paths[-1])
        self.assertEqual(by_us(*paths)[0], sorted(expected, key=lambda line: int(line.split()[3])))

    def test_a_bag_that_is_still_open(self):
        for compression in COMPRESSIONS:
            with rosbag.Bag(self.path, 'w', compression=compression,
                            chunk_threshold=20_000) as bag:
                write(bag, messages_of(300))
                bag._file.flush()
                messages, losses = by_us(self.path)
            everything = by_rosbag(self.path)
            self.assertEqual(messages, everything[:len(messages)])
            self.assertGreater(len(messages), 250, compression)
            self.assertEqual(len(losses), 1)

    def test_no_less_than_rosbag_reindex_saves(self):
        for compression in COMPRESSIONS:
            self.record(compression, messages_of(300))
            everything = by_rosbag(self.path)
            cut = os.path.getsize(self.path) * 2 // 3
            os.truncate(self.path, cut)
            messages, losses = by_us(self.path)
            self.assertEqual(messages, everything[:len(messages)])
            self.assertEqual(losses, [f'lost: {self.path}: was cut at byte {cut}: messages are '
                                      'missing; copy it again from where it was recorded'])
            with rosbag.Bag(self.path, 'a', allow_unindexed=True) as bag:
                for _ in bag.reindex():
                    pass
            saved = by_rosbag(self.path)
            self.assertGreater(len(saved), 100)
            self.assertGreaterEqual(len(messages), len(saved), compression)

    def test_rosbag_reads_what_the_writer_writes(self):
        self.record('none', messages_of(300))
        copy = os.path.join(self.folder, 'copy.bag')
        subprocess.run([BAG_CONTENTS, '--copy', self.path, copy], check=True)
        fields = [line.split() for line in by_rosbag(self.path)]
        self.assertEqual([line.split() for line in by_rosbag(copy)],
                         [[*line[:2], '/copy', *line[3:]] for line in fields])
        with rosbag.Bag(copy) as bag:
            self.assertEqual(bag.get_message_count(), 300)
            self.assertAlmostEqual(bag.get_end_time(), int(fields[-1][3]) / 1e9, places=3)
            texts = [message.data for _, message, _ in bag.read_messages()]
        self.assertEqual(texts, [text for _, _, text, _ in messages_of(300)])
        with rosbag.Bag(copy, 'a') as bag:
            write(bag, [('a', '/late', 'appended', 2_000_000_000_000_000_000)])
        self.assertEqual(len(by_rosbag(copy)), 301)
        self.assertEqual(by_us(copy), (by_rosbag(copy), []))


if __name__ == '__main__':
    BAG_CONTENTS = sys.argv.pop(1)
    unittest.main()
