# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of published topics: parameters, the time of a hold, and the report."""
import json
import math
import os
import signal
import sys
import threading
import time
import traceback
import unittest
from typing import Any, Callable, NamedTuple
from xml.etree import ElementTree

import rosgraph
import rospkg
import rospy
from sign_of_life import MAX_AGE, publisher_of

PERIOD = 0.01  # wall s between two looks at the deadline
REQUIRED = None  # stands in place of a default: the parameter must be given

# On Debian 11 rospy calls isAlive() of threads when it shuts down, which Python 3.9 lacks.
if not hasattr(threading.Thread, 'isAlive'):
    threading.Thread.isAlive = threading.Thread.is_alive


class ParameterError(AssertionError):
    """A fault of the test itself: its parameters cannot be used."""


def is_number(value):
    return type(value) in (int, float)  # bool is a subclass of int


def is_triple(value):
    return isinstance(value, list) and len(value) == 3 and all(map(is_number, value))


KINDS = {  # kind: check of a value, and the name of such a value in messages
    'string': (lambda value: isinstance(value, str), 'a string'),
    'double': (is_number, 'a number'),
    'double[3]': (is_triple, 'a list of 3 numbers')}


class Parameter(NamedTuple):
    """One row of the table of parameters, which the reader and --help use."""
    name: str
    kind: str
    default: Any
    is_valid: Callable
    rule: str  # the end of the message about a value that is not valid
    meaning: str

    def row(self):
        default = ('(required)' if self.default is REQUIRED else
                   '.inf' if self.default == math.inf else json.dumps(self.default))
        return f'  {self.name} | {self.kind} | {default} | {self.meaning}'

    def wrong(self, value, fault):
        return f'parameter ~{self.name} is {json.dumps(value)}, but {fault}'

    def value_in(self, values):
        """The value, or the default; throws ParameterError."""
        if self.name not in values:
            return self.default
        value = values[self.name]
        is_of_kind, kind = KINDS[self.kind]
        if not is_of_kind(value):
            raise ParameterError(self.wrong(value, f'must be {kind}'))
        if not self.is_valid(value):
            raise ParameterError(self.wrong(value, self.rule))
        return value


def times_of(check):
    """The parameters that every test has."""
    return (
        Parameter('deadline', 'double', 10.0, lambda seconds: 0 < seconds < math.inf,
                  'must be a finite number > 0',
                  'wall seconds, > 0, until the test has passed or failed'),
        Parameter('hold', 'double', 0.0, lambda seconds: 0 <= seconds < math.inf,
                  'must be a finite number >= 0',
                  f'wall seconds, >= 0 and less than deadline, for which {check} must stay true '
                  'without a break; 0 = once is enough'),
        Parameter('max_age', 'double', MAX_AGE, lambda seconds: seconds > 0, 'must be a number > 0',
                  'seconds, > 0, of wall time and of ROS time: silence for longer than that is a '
                  'break. A publisher that sends nothing new lives by its /diagnostics; .inf = not '
                  'checked'))


def read_parameters(table, values):
    """{name: value} of each parameter. Throws ParameterError, also for an unknown name: a test that
    overlooks a misspelt tolerance would be worse than none."""
    values = values if isinstance(values, dict) else {}
    read = {parameter.name: parameter.value_in(values) for parameter in table}
    for name in sorted(set(values) - set(read)):
        raise ParameterError(f'parameter ~{name} is unknown; see --help')
    for name, value in read.items():
        if value is REQUIRED:
            raise ParameterError(f'parameter ~{name} is required')
    if read['hold'] >= read['deadline']:
        raise ParameterError('parameter ~hold must be less than ~deadline')
    return read


OUTPUT = '--gtest_output=xml:'
USAGE = """usage, in a .test file:
  <test test-name="NAME" pkg="link_bounds" type="%s">
    <rosparam>%s</rosparam>
  </test>

%s
A deadline of about a minute and more needs a time-limit of the <test>.

Parameters, private (name | type | default | meaning):
%s

Options:
  --gtest_output=xml:FILE   where the result is written; rostest gives it
  --text                    accepted and without effect; rostest gives it, too
  --version                 prints the version

Exit status: 0 passed, 1 failed.
"""


class Hold:
    """Whether something once stayed true for long enough. Times are seconds of a steady clock."""

    def __init__(self, seconds):
        self._seconds = seconds
        self._since = None  # None while it is not true
        self._longest = 0.0  # s, the longest time that ended before _since
        self._was_kept = False  # before _since

    def update(self, is_true, now):
        self._longest, self._was_kept = self.longest(now), self.is_kept(now)
        if not is_true:
            self._since = None
        elif self._since is None:
            self._since = now

    def look(self, is_true, silent_since, now):
        """As update(), but it counts as not true from silent_since on, if that is not None."""
        if silent_since is None:
            self.update(is_true, now)
        else:
            self.update(False, silent_since)

    def is_kept(self, now):
        return self._was_kept or (self._since is not None and now - self._since >= self._seconds)

    def longest(self, now):
        """The longest time so far for which it stayed true."""
        return self._longest if self._since is None else max(self._longest, now - self._since)

    def told(self, now):
        """For the report of a failure."""
        if self._seconds == 0:
            return ''
        return (f' for {self._seconds:.3g} s without a break, '
                f'at most for {self.longest(now):.3g} s,')


class Losses:
    """Counts messages that were published but did not arrive, by their sequence numbers. Once the
    numbers of a publisher go back, they are ignored: it may pass on the messages of several
    publishers."""

    def __init__(self):
        self.count = 0
        self._next = {}  # the next number of each publisher, or None if they are ignored

    def see(self, message, tells):
        """The number of messages lost before this one; 0 if `tells` is False."""
        publisher, number = publisher_of(message), message.header.seq
        due = self._next.get(publisher, number)
        goes_back = due is None or number < due - 1
        self._next[publisher] = None if goes_back else number + 1
        lost = 0 if goes_back or not tells else max(0, number - due)
        self.count += lost
        return lost

    def told(self):
        """For the report of a failure."""
        return [f'{self.count} messages of the topic were lost on the way, and nobody knows what they '
                'said: the machine is too busy'] if self.count else []


class Topic(NamedTuple):
    """A topic that a watch listens to."""
    name: str
    kind: type
    see: Callable  # called with a message and the time [s]
    is_needed: bool = True  # without its publisher, nothing holds


class Program(NamedTuple):
    """One of the tests."""
    name: str
    example: str  # parameters
    about: str
    parameters: tuple
    watch: Callable  # a Watch, from a dictionary of private parameters; throws ParameterError

    def usage(self):
        return USAGE % (self.name, self.example, self.about,
                        '\n'.join(parameter.row() for parameter in self.parameters))


class Watch:
    """Compares messages with one assertion, and keeps the last one for the report. Times are in s.
    A watch defines is_kept_by(message), failure(now), and told(): lines about the last message."""

    fault = ''  # why the test cannot pass at all; '' if it can

    def __init__(self, title, assertion, kind, life):
        self.title = title
        self.deadline = assertion.deadline
        self.topics = [Topic(assertion.topic, kind, self.see)]
        self.life = life
        self._assertion = assertion
        self._hold = Hold(assertion.hold)
        self._losses = Losses()
        self._last = None
        self._last_time = 0.0
        self._is_kept = False  # by the last message
        self._has_lost_publisher = False

    def see(self, message, now):
        self.life.see(message, now)
        if self._losses.see(message, tells=self.life.is_of_node()):
            self._hold.update(False, self._last_time)
        self._last, self._last_time = message, now
        self._has_lost_publisher = False
        self._is_kept = self.is_kept_by(message)
        self.look(now)

    def look(self, now):
        """Silence is a break, until the next message or sign of life."""
        self._hold.look(self._is_kept and not self._has_lost_publisher,
                        self.life.silent_since(now), now)

    def lose_publisher(self, now):
        """Nobody publishes any more, so nobody knows whether the last message still holds."""
        if self._last is None:
            return
        self._has_lost_publisher = True
        self.look(now)

    def is_passed(self, now):
        return not self.fault and self._hold.is_kept(now)

    def evidence(self):
        """What the verdict rests on, as text; '' if nothing needs to be said."""
        return ''

    def last_seen(self):
        """For the report of a failure."""
        if self._last is None:
            return "no message came; is the topic's name right, and does its publisher run?"
        lost = ['nobody publishes this topic any more'] if self._has_lost_publisher else []
        return '\n'.join(self.told() + lost + self._losses.told() + self.life.told())


class TopicTest(unittest.TestCase):
    """The only test: passes as soon as the assertion has held for long enough."""

    def __init__(self, program, start):
        super().__init__()
        self.title = 'parameters'  # name of the test in the report; later what it asserts
        self.evidence = ''  # what the verdict rests on; '' if nothing needs to be said
        self._program = program
        self._start = start
        self._is_interrupted = False

    def runTest(self):
        unknown = [argument for argument in rospy.myargv()[1:]
                   if argument != '--text' and not argument.startswith(OUTPUT)]
        if unknown:
            self.fail(f'unknown argument: {unknown[-1]}; see --help')
        try:
            is_online = rosgraph.is_master_online()
        except ValueError:
            self.fail(f'ROS_MASTER_URI is "{rosgraph.get_master_uri()}"; '
                      'it must be http://HOST:PORT')
        if not is_online:
            self.fail(f'no ROS master answers at {rosgraph.get_master_uri()}; start it by rostest')
        # All times are wall time.
        rospy.init_node(self._program.name, disable_rostime=True, disable_signals=True)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._interrupt)
        watch = self._program.watch(rospy.get_param(rospy.get_name(), {}))
        self.title = watch.title
        self._await(watch)

    def _interrupt(self, *_):
        """Takes no lock, as rospy's own handler does: the thread that it interrupts may hold it."""
        self._is_interrupted = True

    def _now(self):
        return time.monotonic() - self._start

    def _await(self, watch):
        lock = threading.Lock()
        seen = set()  # names of the topics of which a message has come

        def see(message, topic):
            with lock:
                seen.add(topic.name)
                topic.see(message, self._now())

        topics = watch.topics + watch.life.topics(Topic, rospy.get_param('/use_sim_time', False))
        subscribers = [(topic, rospy.Subscriber(topic.name, topic.kind, see, topic,
                                                tcp_nodelay=True)) for topic in topics]
        while not (self._is_interrupted or rospy.is_shutdown()):
            time.sleep(PERIOD)
            with lock:
                now = self._now()
                if watch.fault:
                    self.fail(watch.fault)
                watch.look(now)
                if watch.is_passed(now):
                    self.evidence = watch.evidence()
                    return
                if now > watch.deadline:
                    self.fail(watch.failure(now))
                # In each turn: the last message may be handled after its connection has ended. A
                # topic without any message so far may still connect, and has nothing to lose.
                for topic, subscriber in subscribers:
                    if topic.is_needed and topic.name in seen and connections(subscriber) == 0:
                        watch.lose_publisher(now)
        self.fail('interrupted\n' + watch.failure(self._now()))


def connections(subscriber):
    """The number of connected publishers. get_num_connections() of Debian 11's rospy also counts
    those that have gone, to which it tries to connect again."""
    return sum(connection.socket is not None for connection in subscriber.impl.connections or ())


class Verdict(unittest.TestResult):
    """Keeps why the test failed: the text of an assertion, or the traceback of an exception."""

    failure = ''  # '' = passed

    def addFailure(self, test, err):
        self.failure = printable(str(err[1]))

    def addError(self, test, err):
        self.failure = printable(''.join(traceback.format_exception(*err)))


def printable(text):
    """Control characters, which XML does not allow and which could move the cursor, become spaces.
    Line breaks stay."""
    return ''.join(c if c == '\n' or c.isprintable() else ' ' for c in text)


def junit_xml(suite, test, seconds, failure):
    """A report in JUnit's format, with the attributes that gtest writes, as bytes."""
    duration = f'{seconds:.3f}'
    root = ElementTree.Element('testsuite', name=printable(suite), tests='1', errors='0',
                               failures='1' if failure else '0', time=duration)
    case = ElementTree.SubElement(root, 'testcase', classname=printable(suite),
                                  name=printable(test), status='run', time=duration)
    if failure:
        text = printable(failure)
        ElementTree.SubElement(case, 'failure', type='', message=text.split('\n')[0]).text = text
    return ElementTree.tostring(root, encoding='utf-8', xml_declaration=True)


def write_file(path, content):
    """Makes the folder if it is missing. A reader finds the complete file or none. If there
    is something else than a file, such as /dev/null or a pipe, writes into it and keeps it."""
    is_descriptor = path.startswith(('/dev/fd/', '/dev/std', '/proc/'))
    if is_descriptor or os.path.exists(path) and not os.path.isfile(path):
        with open(path, 'ab') as device:
            device.write(content)
        return
    path = os.path.realpath(path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    unfinished = f'{path}.{os.getpid()}'
    try:
        with open(unfinished, 'wb') as file:
            file.write(content)
        os.replace(unfinished, path)
    except OSError:
        if os.path.exists(unfinished):
            os.remove(unfinished)
        raise


def node_name(default):
    """The name that the command line gives this node, also where there is no master."""
    names = rosgraph.names
    name = names.load_mappings(sys.argv).get('__name', default)
    return names.ns_join(names.get_ros_namespace(), name)


def version():
    """The version in package.xml. rospkg's manifest would need the data of rosdep."""
    folder = rospkg.RosPack().get_path('link_bounds')
    return ElementTree.parse(os.path.join(folder, 'package.xml')).findtext('version')


def run(program):
    """Runs the program and returns its exit status."""
    start = time.monotonic()
    arguments = rospy.myargv()[1:]
    if '--help' in arguments or '-h' in arguments:
        print(program.usage(), end='')
        return 0
    if '--version' in arguments:
        print(program.name, version())
        return 0
    test, verdict = TopicTest(program, start), Verdict()
    test.run(verdict)
    if verdict.failure:
        print('failed:', verdict.failure, file=sys.stderr)
    for path in [argument[len(OUTPUT):] for argument in arguments if argument.startswith(OUTPUT)]:
        try:
            write_file(path, junit_xml(node_name(program.name)[1:], test.title,
                                       time.monotonic() - start, verdict.failure))
        except OSError:
            print('failed: cannot write', path, file=sys.stderr)
            return 1
    if not verdict.failure:
        print('passed:', printable(test.title + test.evidence))
    return 1 if verdict.failure else 0
