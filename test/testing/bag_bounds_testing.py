# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of bag_bounds: bags of the arms, and running the program."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import genpy
import rosbag
from node_testing import ARMS, DYNAMIC, arm_transform
from patience import PATIENCE
from raw_messages import serialized
from tf2_msgs.msg import TFMessage

BAG_BOUNDS = ''
BEGIN = 1000.0  # s, record time of the first message
PERIOD = 0.02  # s between the transforms
COUNT = 150  # messages of most bags
ENTERED = UNDERCUT = 3  # exit codes
PARTLY_READ = INCOMPLETE = 4


def time_of(seconds):
    return genpy.Time(nsecs=round(seconds * 1e9))


def degrees_at(index):
    """The arms swing forth and back."""
    return 40 - abs(index % 200 - 100) * 0.8


def seconds(index):
    """The record time of a message, after the first one."""
    return round(PERIOD * index, 9)


def zone_text(name, low, high, frame=''):
    return '%s: {%smin: %s, max: %s}\n' % (name, 'frame: %s, ' % frame if frame else '', low, high)


def static_arms(recorded=BEGIN):
    """The message of the mast, which does not move."""
    return '/tf_static', TFMessage([arm_transform('mast', genpy.Time(), 0)]), time_of(recorded)


def moving_arms(index, recorded=None, links=tuple(DYNAMIC), angle_index=None):
    """A message of the other arms; recorded at its stamp unless told otherwise."""
    stamp = time_of(BEGIN + PERIOD * index)
    degrees = degrees_at(index if angle_index is None else angle_index)
    message = TFMessage([arm_transform(link, stamp, degrees) for link in links])
    return '/tf', message, stamp if recorded is None else time_of(recorded)


def arms(count):
    """The messages of a bag of the arms."""
    return [static_arms()] + [moving_arms(index) for index in range(count)]


def write_bag(path, messages, compression=rosbag.Compression.NONE):
    """A bag of (topic, message, record time)."""
    with rosbag.Bag(path, 'w', compression=compression) as bag:
        for topic, message, time in messages:
            bag.write(topic, message, time)
    return path


def raw(message):
    """The bytes of a message with its type, for Bag.write(raw=True)."""
    return message._type, serialized(message), message._md5sum, type(message)


def run(*arguments, **options):
    """Exit code, standard output and standard error."""
    done = subprocess.run([BAG_BOUNDS, *arguments], timeout=100 * PATIENCE, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8',
                          **options)
    return done.returncode, done.stdout, done.stderr


class BagBoundsTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.urdf = self.write('arms.urdf', ARMS)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as file:
            file.write(text)
        return self.path(name)

    def bag(self, messages, name='arms.bag', **options):
        return write_bag(self.path(name), messages, **options)

    def report(self, bags, *arguments, code=0, err=''):
        """The parsed JSON of a run with that exit code and a standard error that fits `err`."""
        bags = [bags] if isinstance(bags, str) else bags
        found = run(*bags, '--urdf', self.urdf, '--format', 'json', *arguments)
        self.assertEqual(found[0], code, found)
        said = found[2]
        if code == ENTERED and not err:  # what else is open is not asked here
            said = re.sub(r'^bag_bounds: warning: not everything was answered: [^;\n]*(; [^;\n]*)*\n$',
                          '', said)
        self.assertRegex(said, '(?s)^' + err + '$' if not err else err)
        return json.loads(found[1], object_pairs_hook=self.unique)

    def unique(self, pairs):
        """An object of JSON, in which a key that stands twice would hide another value."""
        self.assertEqual(len(dict(pairs)), len(pairs), pairs)
        return dict(pairs)

    def check_refused(self, reason, *arguments):
        code, out, err = run(*arguments)
        self.assertEqual((code, out), (1, ''), err)
        self.assertRegex(err, 'bag_bounds: error: .*' + reason)
        self.assertIn('--help', err)
        self.assertEqual(err.count('\n'), 1, err)


def main():
    """Runs the tests of the script with the path of bag_bounds, its last argument."""
    global BAG_BOUNDS
    BAG_BOUNDS = os.path.abspath(sys.argv.pop())
    unittest.main()
