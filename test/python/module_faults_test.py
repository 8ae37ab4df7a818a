#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""link_bounds.Robot refuses what is wrong in words, ends at Ctrl-C, and keeps no memory."""
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import threading
import tracemalloc
import types
import unittest
import warnings

import numpy as np

import link_bounds
from patience import PATIENCE
from urdf_bounds_testing import ARM, UrdfBoundsTest, mesh, solid, tetrahedron, tree

DEMO = str(pathlib.Path(__file__).parents[2] / 'launch/demo/demo.urdf')
INIT = pathlib.Path(__file__).parents[2] / 'src/python/link_bounds/__init__.py'
CALLS = 10**6
INTERRUPTED = '''
import sys, numpy, link_bounds
robot = link_bounds.Robot(sys.argv[1])
print('ready', flush=True)
try:
    %s
except KeyboardInterrupt:
    print('interrupted', robot.boxes({}).shape)
'''
# Rospy calls callbacks on such threads. What was registered first is called last.
ENDING = '''
import atexit
atexit.register(lambda: print(robot.boxes(rows).shape))
import os, signal, sys, threading, time, numpy, link_bounds
robot = link_bounds.Robot(sys.argv[1])
rows = numpy.zeros((10**4, len(robot.joints)))
begun = threading.Event()
def callback():
    while True:
        begun.set()
        %s
threading.Thread(target=callback, daemon=True).start()
begun.wait(float(sys.argv[2]))
time.sleep(0.05)  # whether it is within the call, nobody can ask
'''
FORKED = '''
child = os.fork()
if child:
    os._exit(os.waitpid(child, 0)[1] % 255)
signal.setitimer(signal.ITIMER_REAL, float(sys.argv[2]))
'''


def resident():
    """Bytes of this process."""
    pages = int(pathlib.Path('/proc/self/statm').read_text().split()[1])
    return pages * os.sysconf('SC_PAGE_SIZE')


class Broken:
    """What has keys, but is no mapping that can be read."""

    def __init__(self, keys):
        self.keys = keys

    def __getitem__(self, key):
        raise KeyError('the mapping is broken')


class Series:
    """As one of pandas: an array that has keys(), too."""

    def __init__(self, values):
        self._values = values

    def keys(self):
        return range(len(self._values))

    def __array__(self, *_, **__):
        return np.array(self._values)


class RobotFaultsTest(UrdfBoundsTest):
    def check(self, words, call, *arguments, error=ValueError, **named):
        with self.assertRaisesRegex(error, words):
            call(*arguments, **named)

    def test_poses(self):
        robot = link_bounds.Robot(ARM)
        for call in (robot.boxes, lambda q: robot.distances(q, 1)):
            self.check(r'shape is \(3,\), but the robot has 2 joints', call, [1, 2, 3])
            self.check(r'shape is \(2, 1\)', call, [[1], [2]])
            self.check(r'shape is \(\)', call, 1.0)
            self.check(r'shape is \(1, 1, 2\)', call, np.zeros((1, 1, 2)))
            self.check('q must be a dict', call, None)
            self.check('q must be a dict', call, ['a', 'b'])
            self.check('q must be a dict', call, np.array([1j, 0]))
            self.check('masked array; fill it', call, np.ma.array([0.0, 9.0], mask=[False, True]))
            self.check('joint "push" in q is nan', call, [0, float('nan')])
            self.check('joint "turn" in q is inf', call, {'turn': float('inf')})
            self.check(r'joint "turn" in q\[2\] is nan', call, [[0, 0], [0, 0], [np.nan, 0]])
            self.check('masked array; fill it', call, [np.ma.array([0.0, 9.0], mask=[0, 1])])
            endless = []
            endless.append(endless)
            self.check('q must be a dict', call, endless)
            self.check('"elbow" is no movable joint of the robot; .* turn push', call, {'elbow': 1})
            self.check('"bar" is no movable joint', call, [{}, {'bar': 1}])
            self.check('value of joint "turn" is \'a\'', call, {'turn': 'a'})
            self.check('1 is not the name of a joint', call, {1: 1})
            self.check('"a\ufffd" is no movable joint', call, {'a\udcff': 1})
            self.check(r"'\\ud800' is not the name of a joint", call, {'\ud800': 1})

    def test_values_without_a_box(self):
        robot = link_bounds.Robot(ARM, 'collision')
        for call in (robot.boxes, lambda q: robot.distances(q, 1)):
            self.check(r'q\[1\]: link "slide": its size and pose give no finite', call,
                       [[0, 0], [0, sys.float_info.max]])

    def test_a_row_without_a_box_among_many(self):
        """Whichever thread has that row, and whatever the others do then."""
        robot = link_bounds.Robot(ARM, 'collision')
        rows = np.zeros((20000, 2))
        rows[19990, 1] = sys.float_info.max
        for call in (robot.boxes, lambda q, jobs: robot.distances(q, 0, jobs=jobs)):
            for jobs in (0, 2, 4):
                for _ in range(10):
                    self.check(r'q\[19990\]: link "slide": its size and pose give no finite', call,
                               rows, jobs=jobs)

    def test_names_that_are_not_utf8(self):
        """As .joints has them, they are taken."""
        path = self.write('r.urdf', ARM.encode().replace(b'"turn"', b'"t\xff"'))
        robot = link_bounds.Robot(pathlib.Path(path))
        self.assertEqual(robot.joints[0], 't\udcff')
        np.testing.assert_array_equal(robot.boxes({'t\udcff': 1}), robot.boxes([1, 0]))
        self.check('value of joint "t\ufffd" is', robot.boxes, {'t\udcff': 'a'})
        self.check('range of joint "t\ufffd" is', robot.reach, {'t\udcff': (2, 1)})
        self.check('joint "t\ufffd" in q is nan', robot.boxes, [np.nan, 0])

    def test_links_that_are_not_utf8(self):
        """What is printed of them can be printed anywhere."""
        urdf = tree(solid('a'), solid('b'), solid('c')).replace('"fixed"', '"continuous"')
        path = self.write('l.urdf', urdf.encode().replace(b'"b"', b'"b\xff"'))
        robot = link_bounds.Robot(pathlib.Path(path))
        self.assertIn('b\udcff', robot.links)
        self.assertRegex(repr(robot.pairs(budget=0.1)), '<Pair b\ufffd, c: [A-Z]+>')
        self.assertEqual(repr(robot.check_path([[0, 0], [0, 1]])[0]),
                         '<Segment 0: COLLIDES, nearest b\ufffd and c>')

    def test_links_that_are_left_out(self):
        """One of ARM has collision geometry only; each robot says so once."""
        reason = 'left out are links with collision geometry only: "slide"; geometry=.both. takes'
        for call in (lambda robot: robot.distances([0, 0], 1),
                     lambda robot: robot.distances([[0, 0]], 1),
                     lambda robot: robot.reach(budget=0.1),
                     lambda robot: robot.pairs(budget=0.1),
                     lambda robot: robot.check_path([[0, 0], [1, 0]])):
            robot = link_bounds.Robot(ARM)
            for times in (1, 0):
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter('always')
                    robot.boxes([0, 0])
                    call(robot)
                found = [str(warning.message) for warning in caught
                         if re.match(reason, str(warning.message))]
                self.assertEqual(len(found), times, [str(warning) for warning in caught])
        with warnings.catch_warnings():
            warnings.simplefilter('error')
            link_bounds.Robot(ARM, geometry='both').distances([0, 0], 1)

    def test_numbers(self):
        robot = link_bounds.Robot(ARM)
        for limit in (-1, float('nan'), float('inf')):
            self.check('limit is .*>= 0', robot.distances, {}, limit)
        self.check('accuracy is 0.0', robot.reach, accuracy=0)
        self.check('budget is nan', robot.pairs, budget=float('nan'))
        self.check('clearance is -1', robot.pairs, clearance=-1)
        self.check('range of joint "turn" is', robot.reach, {'turn': (2, 1)})
        self.check('range of joint "turn" is', robot.pairs, {'turn': (0, float('nan'))})
        self.check('ranges must be a dict', robot.reach, [1])
        self.check('"x" is no movable joint', robot.reach, {'x': (0, 1)})
        self.check('', robot.boxes, [[0, 0]], jobs=-1, error=TypeError)
        for call in (lambda jobs: robot.boxes([0, 0], jobs=jobs),
                     lambda jobs: robot.distances([0, 0], 1, jobs=jobs),
                     lambda jobs: robot.pairs(jobs=jobs),
                     lambda jobs: robot.check_path([[0, 0], [1, 0]], jobs=jobs)):
            self.check('jobs is 1025, but must be at most 1024, or 0', call, 1025)
            call(1024)

    def test_paths(self):
        robot = link_bounds.Robot(ARM)
        call, rows = robot.check_path, [[0, 0], [1, 0]]
        for poses in ([0, 0], {}, [[0, 0]], [{}]):
            self.check('q has one row; a path needs two or more', call, poses)
        self.check('q has no row; a path needs two or more', call, np.zeros((0, 2)))
        self.check(r'joint "push" in q\[1\] is nan', call, [[0, 0], [0, np.nan]])
        self.check('"elbow" is no movable joint', call, [{}, {'elbow': 1}])
        self.check('velocities has 3 rows, but q has 2', call, rows, velocities=np.zeros((3, 2)),
                   times=[0, 1])
        self.check(r'joint "turn" in velocities\[0\] is inf', call, rows, times=[0, 1],
                   velocities=[[np.inf, 0], [0, 0]])
        self.check(r'the motion to q\[1\] is not finite', call, rows, times=[0, 3],
                   velocities=[[0, 0], [0, 1e308]])
        self.check('velocities need times', call, rows, velocities=rows)
        self.check('accelerations need velocities', call, rows, accelerations=rows, times=[0, 1])
        self.check(r'times\[1\] .* times must grow', call, rows, times=[0, 0])
        self.check(r'times must be an array \[rows\] of 2', call, rows, times=[0, 1, 2])
        self.check('times must be an array', call, rows, times='ab')
        for times in (np.array([0, 2000], 'timedelta64[ms]'), ['0', '2'], [False, True],
                      np.array(['2026-01-01T00:00', '2026-01-01T00:02'], 'datetime64[ms]'),
                      np.array([0, 2 + 7j]), np.array([0, 2], object)):
            self.check('times must .* of seconds, but its values are of the type '
                       + re.escape(str(np.asarray(times).dtype)), call, rows, times=times)
        for times in ([0, 2], (0.0, 2.5), np.array([0, 2], 'u1'), np.array([0, 2], 'f4')):
            self.assertEqual(len(call(rows, times=times)), 1)
        masked = np.ma.array(rows, mask=[[False, True], [False, False]])
        self.check('times must .* masked array; fill it', call, rows,
                   times=np.ma.array([0, 1], mask=[False, True]))
        self.check('velocities must .* masked array', call, rows, times=[0, 1], velocities=masked)
        self.check('accelerations must .* masked array', call, rows, times=[0, 1], velocities=rows,
                   accelerations=masked)
        self.check('clearance is -1', call, rows, clearance=-1)
        self.check('budget is 0', call, rows, budget=0)
        self.check('cannot read /no/such.yaml', call, rows, objects='/no/such.yaml',
                   error=link_bounds.RobotError)
        self.check('.*object "o" .*no/such.stl', call, rows, error=link_bounds.RobotError,
                   objects=self.write('o.yaml', 'o: {type: MESH_RESOURCE, '
                                                'mesh_resource: "file:///no/such.stl"}'))
        self.check('"bar" has the name of a link', call, rows, objects=self.write(
            'p.yaml', 'bar: {type: CUBE, scale: {x: 1, y: 1, z: 1}}'))
        self.check('', call, rows, srdf=self.write('a.srdf', '<robot'),
                   error=link_bounds.RobotError)
        segment, = call(rows, budget=1e-9)
        self.assertEqual((segment.verdict, segment.first, segment.pose), ('UNDECIDED', '', {}))

    def test_descriptions(self):
        self.check('cannot read /no/such.urdf: No such file', link_bounds.Robot, '/no/such.urdf',
                   error=link_bounds.RobotError)
        self.check('', link_bounds.Robot, '<robot', error=link_bounds.RobotError)
        self.check('geometry is "visaul".*collision', link_bounds.Robot, ARM, 'visaul')
        self.check('"-" is no file; give the path of a URDF', link_bounds.Robot, '-',
                   error=link_bounds.RobotError)
        turn = '<joint name="turn" type="revolute">'
        circle = ARM.replace(turn, turn + '<mimic joint="follow"/>')
        self.check('mimics in a circle', link_bounds.Robot, circle, error=link_bounds.RobotError)

    def test_packages(self):
        for name in (1, None, '\ud800'):
            self.check(re.escape(repr(name)) + ' is not the name of a package', link_bounds.Robot, ARM,
                       packages={name: '/tmp'})
        for packages in (1, 'ab', ['ab'], dict):
            self.check('packages must be a dict {package: folder}, but is ' +
                       re.escape(repr(packages)), link_bounds.Robot, ARM, packages=packages)
        self.check('the folder of package "a" is 1, but must be a path', link_bounds.Robot, ARM,
                   packages={'a': 1})

    def test_mappings(self):
        """What has keys() is taken as a dict, unless it is an array, too."""
        robot = link_bounds.Robot(ARM)
        proxy = types.MappingProxyType
        for call in (robot.boxes, lambda q: robot.distances(q, 9)):
            self.check('"elbow" is no movable joint', call, proxy({'elbow': 1}))
            self.check('1 is not the name of a joint', call, [{}, proxy({1: 1})])
            for q in (dict, Broken(1), [dict], [{}, Broken(1)]):
                self.check('q must be a dict .*, but is ', call, q)
            self.check('the mapping is broken', call, Broken(lambda: ['turn']), error=KeyError)
            self.check(r'shape is \(3,\), but the robot has 2 joints', call, Series([1, 2, 3]))
            np.testing.assert_array_equal(call(Series([1, 0])), call([1, 0]))
        for ranges in (dict, Broken(1), 'ab'):
            self.check('ranges must be a dict .*, but is ', robot.reach, ranges)
        self.check('1 is not the name of a joint', robot.reach, proxy({1: 1}))
        self.check('range of joint "turn" is', robot.pairs, proxy({'turn': (2, 1)}))

    def test_names_of_files_and_texts(self):
        for urdf in DEMO + '\0.urdf', ARM + '\0', ' \0':
            self.check('has a null byte', link_bounds.Robot, urdf)
        marked = link_bounds.Robot('\ufeff' + ARM)  # a BOM
        self.assertEqual(marked.links, link_bounds.Robot(ARM).links)

    def test_a_build_without_pybind11(self):
        """Has the messages' package alone, and says so where a robot is asked for."""
        folder = os.path.dirname(self.write('link_bounds/__init__.py', INIT.read_text('utf-8')))
        code = 'import sys; sys.path.insert(0, sys.argv[1]); import link_bounds; link_bounds.Robot'
        done = subprocess.run([sys.executable, '-c', code, os.path.dirname(folder)], check=False,
                              stderr=subprocess.PIPE, encoding='utf-8')
        self.assertRegex(done.stderr, 'ImportError: .* built without pybind11; install pybind11-dev')

    def test_lost_geometry(self):
        urdf = tree(solid('a'), mesh('b', 'file:///no/such.stl'))
        self.check('link "b", visual 1 .*no/such.stl', link_bounds.Robot, urdf,
                   error=link_bounds.RobotError)
        with self.assertWarnsRegex(RuntimeWarning, 'no/such.stl'):
            robot = link_bounds.Robot(urdf, allow_incomplete=True)
        self.assertEqual(list(robot.incomplete), ['b'])
        self.assertTrue(np.isnan(robot.boxes([])[1]).all())
        np.testing.assert_allclose(robot.boxes([])[0], [[-0.5] * 3, [0.5] * 3], atol=1e-12)

    def test_a_mesh_without_triangles(self):
        """Its boxes are exact, its distances those of its hull."""
        content = tetrahedron().replace(struct.pack('<f', 3), struct.pack('<f', 2e30))
        urdf = tree(mesh('a', 'file://' + self.write('far.stl', content)))
        with self.assertWarnsRegex(RuntimeWarning, 'link "a", visual 1 .*convex hull.* exceeds 1e30 m'):
            robot = link_bounds.Robot(urdf)
        np.testing.assert_allclose(robot.boxes([])[0, 1, 2], 2e30, 1e-6)

    def test_a_reader_of_meshes_that_dies(self):
        """The library looks for mesh_worker beside the running program first."""
        worker = self.write('bin/mesh_worker', '#!/bin/sh\nkill -SEGV $$')
        os.chmod(worker, 0o755)
        python = shutil.copy(os.path.realpath('/proc/self/exe'), os.path.dirname(worker))
        urdf = tree(mesh('a', 'file://' + self.write('t.stl', tetrahedron())))
        code = ('import link_bounds, sys\ntry:\n    link_bounds.Robot(sys.argv[1])\n'
                'except link_bounds.RobotError as error:\n    print("refused:", error)')
        done = subprocess.run([python, '-c', code, urdf], check=True, stdout=subprocess.PIPE,
                              env=dict(os.environ, PYTHONHOME=sys.prefix), encoding='utf-8')
        self.assertRegex(done.stdout, 'refused: link "a".* died of it .*; repair or replace')

    def test_ctrl_c(self):
        for call in ('robot.distances(numpy.zeros((10**6, len(robot.joints))), 0.5)',
                     'robot.pairs(accuracy=1e-9, budget=1000)',
                     'robot.reach(accuracy=1e-12, budget=1000)',
                     'robot.check_path(numpy.zeros((10**5, len(robot.joints))) +'
                     ' numpy.arange(10**5)[:, None] / 1e3, budget=1000)'):
            process = subprocess.Popen([sys.executable, '-c', INTERRUPTED % call, DEMO],
                                       stdout=subprocess.PIPE, encoding='utf-8')
            try:
                self.assertEqual(process.stdout.readline(), 'ready\n')
                # The first signals may come before the call.
                late = threading.Timer(1, process.send_signal, [signal.SIGINT])
                late.start()
                out, _ = process.communicate(timeout=60 * PATIENCE)
            finally:
                late.cancel()
                process.kill()
            self.assertRegex(out, r'interrupted \(\d+, 2, 3\)', call)

    def ending(self, code):
        limit = 20 * PATIENCE
        done = subprocess.run([sys.executable, '-c', code, DEMO, str(limit)], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8',
                              timeout=2 * limit)
        self.assertEqual(done.returncode, 0, (code, done.stderr))
        self.assertRegex(done.stdout, r'^\(10000, \d+, 2, 3\)\n$', code)
        return done.stderr

    def test_python_ends_while_another_thread_calls(self):
        for call in ('robot.boxes(rows[0])', 'robot.boxes(rows)', 'robot.distances(rows[0], 1)',
                     'robot.distances(rows, 1)', 'robot.pairs(accuracy=1e-9, budget=1000)',
                     'robot.reach(accuracy=1e-12, budget=1000)',
                     'robot.check_path(rows + numpy.arange(10**4)[:, None] / 1e3, budget=1000)',
                     'link_bounds.Robot(sys.argv[1])'):
            err = self.ending(ENDING % call)
            self.assertNotIn('Exception', err, call)
            self.assertNotIn('terminate', err, call)

    def test_python_waits_for_a_thread_that_calls(self):
        """As rospy does for its own when Python ends."""
        self.ending('''
import atexit, threading, sys
begun, ends = threading.Event(), threading.Event()
def end():
    ends.set()
    thread.join(float(sys.argv[2]))
    print(robot.boxes(rows).shape)
    if thread.is_alive():
        raise SystemExit('it is still there')
atexit.register(end)
import numpy, link_bounds
robot = link_bounds.Robot(sys.argv[1])
rows = numpy.zeros((10**4, len(robot.joints)))
def calls():
    while not ends.is_set():
        begun.set()
        robot.boxes(rows)
thread = threading.Thread(target=calls, daemon=True)
thread.start()
begun.wait(float(sys.argv[2]))
''')

    def test_forks_while_another_thread_calls(self):
        """Other modules call Python after a fork, too."""
        self.ending('''
import concurrent.futures.thread, logging, os, sys, threading, numpy, link_bounds
robot = link_bounds.Robot(sys.argv[1])
rows = numpy.zeros((10**4, len(robot.joints)))
def calls():
    while True:
        robot.boxes(rows[0])
        robot.distances(rows[0], 1)
threading.Thread(target=calls, daemon=True).start()
sys.setswitchinterval(1e-6)  # other threads get the lock of Python in every hook
for _ in range(100):
    child = os.fork()
    if not child:
        os._exit(0)
    os.waitpid(child, 0)
print(robot.boxes(rows).shape)
''')

    def test_a_forked_process_ends(self):
        """It has none of the threads that call."""
        self.ending(ENDING % 'robot.pairs(accuracy=1e-9, budget=1000)' + FORKED)

    def test_large_arrays_are_not_copied(self):
        robot = link_bounds.Robot(ARM)
        rows = np.zeros((10**5, len(robot.joints)))
        for given, copies in ((rows, 0), (np.asfortranarray(rows), 1), (rows.astype('f4'), 1)):
            for call, result in ((robot.boxes, len(rows) * len(robot.links) * 48),
                                 (lambda q: robot.distances(q, 0), 0)):
                tracemalloc.start()
                call(given)
                peak = tracemalloc.get_traced_memory()[1]
                tracemalloc.stop()
                self.assertEqual(round((peak - result) / rows.nbytes), copies)

    def test_many_calls_keep_no_memory(self):
        robot = link_bounds.Robot(ARM)
        rows = np.zeros((64, 2))

        def calls(count):
            for _ in range(count):
                robot.boxes([0.5, 0])
                robot.boxes({'turn': 0.5})
                try:
                    robot.boxes([0.5])
                except ValueError:
                    pass
            for _ in range(count // 500):
                robot.boxes(rows, jobs=2)
                robot.distances(rows, 10, jobs=2)
        calls(5000)
        before = resident()
        calls(CALLS // 3)
        self.assertLess(resident() - before, 2 << 20)


if __name__ == '__main__':
    unittest.main()
