#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Broken, hostile and odd robots, each through urdf_bounds.

Run as: bad_urdf_test.py PATH_OF_urdf_bounds
"""
import json
import math
import os
import resource
import subprocess
import sys
import unittest

import bad_inputs
from patience import PATIENCE

GROUP = 'group:robot'

URDF_BOUNDS = ''
TIMEOUT_SECONDS = PATIENCE * (180 if bad_inputs.SANITIZED else 60)  # one robot; hangs never end
MEMORY_BYTES = 4000000 * 1024


def limit_memory():
    if not bad_inputs.SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))


def run(text):
    """Exit code, parsed standard output (None if there is none), lines of standard error."""
    environment = dict(os.environ, ROS_PACKAGE_PATH=bad_inputs.DATA)
    done = subprocess.run([URDF_BOUNDS, '-', '--format', 'json'], env=environment, input=text,
                          preexec_fn=limit_memory, timeout=TIMEOUT_SECONDS, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    out = done.stdout.decode('utf-8')
    return done.returncode, json.loads(out) if out else None, done.stderr.decode('utf-8')


class BadUrdfTest(unittest.TestCase):
    def test_every_case(self):
        cases = list(bad_inputs.cases())
        for case in cases:
            with self.subTest(case=case.name):
                self.check(case.text, case.expected)
        print('faults: %d broken robots on the command line' % len(cases))

    def check(self, text, expected):
        code, found, messages = run(text)
        self.check_rule(code, found, messages)
        if not expected:
            return
        self.assertEqual(code, expected.get('exit', 0), messages)
        self.assertIn(expected.get('words', ''), messages)
        if code == 0:
            self.check_boxes(found, expected['boxes'], expected.get('within', 1e-9))
            links = [name for name in found['incomplete'] if name != GROUP]
            self.assertEqual(links, expected.get('incomplete', []))
            self.assertEqual(messages.count('link "'), len(links))

    def check_rule(self, code, found, messages):
        """Rules for all inputs, also for those that are not in the tables."""
        self.assertIn(code, (0, 1), messages)
        self.assertNotIn('root:x:', '%s%s' % (found, messages))
        if code == 1:
            self.assertIsNone(found)
            self.assertEqual(messages.count('urdf_bounds: error: '), 1)
            return
        self.assertEqual(messages.count('urdf_bounds: error: '), 0)
        for box in list(found['boxes'].values()) + list(found['groups'].values()):
            for low, high in zip(box['min'], box['max']):
                self.assertTrue(math.isfinite(low) and math.isfinite(high) and low <= high, box)
        self.assertEqual(GROUP in found['incomplete'], bool(found['incomplete']))
        for name, reason in found['incomplete'].items():
            self.assertNotEqual(reason, '')
            if name == GROUP:
                continue
            self.assertIn('urdf_bounds: warning: link "%s"' % name, messages)

    def check_boxes(self, found, expected, within):
        self.assertEqual(set(found['boxes']), set(expected))
        for name, (low, high) in expected.items():
            box = found['boxes'][name]
            allowed = within + 1e-12 * max(abs(x) for x in low + high)
            for value, exact in zip(box['min'] + box['max'], low + high):
                self.assertAlmostEqual(value, exact, delta=allowed, msg=name)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    global URDF_BOUNDS
    URDF_BOUNDS = os.path.abspath(sys.argv.pop())
    unittest.main()


if __name__ == '__main__':
    main()
