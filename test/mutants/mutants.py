#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Do the tests see it when one line of src is wrong?

Run as: mutants.py FOLDER [--count N] [--room ROOM] [--seconds S] [--log FILE.jsonl]
            [--before FILE.jsonl]

Makes mutants of random lines: another operator, a constant off by one, a condition turned round, a
statement left out. All are built at once, in a copy of the checkout in FOLDER, which is outside of
the checkout. There a line does what it did, or what the mutant does if LINK_BOUNDS_MUTANT has its
number. Each test first runs without a mutant, to see which mutants it reaches. Then the tests that
reach a mutant run with it, the quickest first, until one fails twice or takes far too long, or S
seconds have passed.

Which lines are changed depends on their text alone, not on where they stand: after files have
moved, the same mutants are tried again. The log has a line for each mutant, and one that is there
is not tried again. Exit code 1 if a mutant survives that was killed before. 200 mutants take about
two hours on two processors; if it was stopped, the next run goes on.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import threading
import time

from mutated_source import PACKAGE, candidates, mutated

MARKS = 4096  # as many as the switch has
# Not run: tests of texts and packages; those that measure time or memory or make a load; and those
# that need networks of their own.
NOT_RUN = re.compile(r'house_|_meshes$|node_load_|_load\.test|sanitizers|soak|_memory|heap_test'
                     r'|three_hosts|cloud_(burst|turns)|few_threads|rosrun')
AT_ONCE = 2 * os.cpu_count()  # tests, of which many wait most of the time
MEGABYTES = 8000  # of addresses for each process, as a mutant may take all the memory there is


class Tree:
    """The copy of the checkout, and its build."""

    def __init__(self, folder):
        self.folder, self.tree, self.build = folder, folder / 'tree', folder / 'tree' / 'build'

    def shell(self, command, **environment):
        """(succeeds, output) of a command in the environment of scripts/test."""
        start = f'. scripts/common.sh; clean_environment; use_localhost; ulimit -v {MEGABYTES}000; '
        # In a session of its own, as a test may stop its group of processes.
        done = subprocess.run(['bash', '-c', start + command], cwd=self.tree, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, **environment}, start_new_session=True)
        return done.returncode == 0, done.stdout.decode('utf-8', 'replace')

    def make(self, targets):
        succeeds, output = self.shell(
            'configure build -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null && '
            f'cmake --build build --parallel {os.cpu_count()} --target {targets}')
        if not succeeds:
            sys.exit(output[-5000:] + '\nThe build failed')

    def copy(self, contents):
        """What has not changed keeps its time, and so what was built of it."""
        names = subprocess.run(['git', 'ls-files', '-z'], cwd=PACKAGE, stdout=subprocess.PIPE,
                               check=True)
        digest = hashlib.sha256()
        for name in sorted(map(pathlib.Path, names.stdout.decode().split('\0')[:-1])):
            source, target = PACKAGE / name, self.tree / name
            content = contents.get(name, '').encode() or source.read_bytes()
            if name.parts[0] in ('include', 'msg', 'src', 'srv', 'test'):
                digest.update(str(name).encode() + b'\0' + content)
            if not target.exists() or target.read_bytes() != content:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
                target.chmod(source.stat().st_mode)
        return digest.hexdigest()

    def commands(self):
        """The compiler's arguments for each source; those compiled together have the same."""
        result = {}
        for entry in json.loads((self.build / 'compile_commands.json').read_text('utf-8')):
            file, files = pathlib.Path(entry['file']), []
            if file.parent.name == 'Unity':
                files = re.findall('#include "(/.*)"', file.read_text('utf-8'))
            arguments = shlex.split(entry['command'])
            arguments = arguments[:arguments.index('-o')]
            arguments += ['-fsyntax-only', '-w', '-Werror=return-type']
            for name in files or [file]:
                path = pathlib.Path(name).relative_to(self.tree)
                result.setdefault(path, (arguments, entry['directory']))
        return result

    def compiling(self, path, chosen, command):
        """Those of the mutants with which the source compiles."""
        file = self.tree / path.with_name('mutants_check_' + path.name)
        while chosen:
            file.write_text(mutated(path, ((1, mutant) for mutant in chosen)), 'utf-8')
            done = subprocess.run(command[0] + [file], cwd=command[1], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, check=False)
            file.unlink()
            if done.returncode == 0:
                break
            content = (PACKAGE / path).read_text('utf-8')
            lines = [content.count('\n', 0, mutant.edit.start) + 1 for mutant in chosen]
            output, left = done.stdout.decode('utf-8', 'replace'), chosen
            for kind in ': error', '':
                found = re.findall(rf'{re.escape(file.name)}:(\d+):\d+{kind}', output)
                left = [mutant for mutant, line in zip(chosen, lines) if str(line) not in found]
                if left != chosen:
                    break
            chosen = left if left != chosen else []
        return chosen

    def choose(self, room, count):
        """The first mutants that compile and do not overlap."""
        queue, good, commands = candidates(room), collections.defaultdict(list), self.commands()
        queue = [mutant for mutant in queue if mutant.path in commands]
        place = 0
        while (missing := count - sum(map(len, good.values()))) > 0 and place < len(queue):
            tried = collections.defaultdict(list)
            while missing > 0 and place < len(queue):
                mutant, place = queue[place], place + 1
                others = good[mutant.path] + tried[mutant.path]
                if all(mutant.edit.start >= other.edit.end or mutant.edit.end <= other.edit.start
                       for other in others):
                    tried[mutant.path].append(mutant)
                    missing -= 1
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                checks = {path: pool.submit(self.compiling, path, new, commands[path])
                          for path, new in tried.items()}
                for path, check in checks.items():
                    good[path] += check.result()
        return sorted(mutant for mutants in good.values() for mutant in mutants)


class Tests:
    """What each test takes, and which mutants it reaches."""

    def __init__(self, tree, mutants, digest):
        self.tree, self.file = tree, tree.folder / 'reached.json'
        self.lock, self.busy = threading.Lock(), collections.defaultdict(threading.Lock)
        known = json.loads(self.file.read_text('utf-8')) if self.file.exists() else {}
        self.digest, self.found = digest, known['tests'] if known.get('digest') == digest else {}
        listed = json.loads(self.tree.shell('cd build && ctest --show-only=json-v1')[1])
        names = [test['name'] for test in listed['tests'] if not NOT_RUN.search(test['name'])]
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            list(pool.map(lambda name: self.measure(name, len(mutants)),
                          (name for name in names if name not in self.found)))

    def run(self, name, seconds, **environment):
        """'passed', 'failed' or 'timed out'. A test never runs beside itself."""
        with self.busy[name]:
            command = f'cd build && ctest -R "^{re.escape(name)}$" --timeout {seconds:.0f}'
            passes, output = self.tree.shell(command, **environment)
        return 'passed' if passes else 'timed out' if 'Timeout' in output else 'failed'

    def measure(self, name, count):
        marks = self.tree.folder / f'{name}.marks'
        marks.write_bytes(bytes(MARKS))
        start = time.monotonic()
        fate = self.run(name, 300, LINK_BOUNDS_MUTANT_LOG=str(marks))
        seconds, reached = time.monotonic() - start, marks.read_bytes()
        marks.unlink()
        numbers = [number for number in range(1, count + 1) if reached[number]]
        print(f'{fate:10} {seconds:5.1f} s, reaches {len(numbers):4}: {name}', flush=True)
        with self.lock:
            self.found[name] = {'fate': fate, 'seconds': seconds, 'reached': numbers}
            self.file.write_text(json.dumps({'digest': self.digest, 'tests': self.found}), 'utf-8')

    def fate(self, number, limit):
        tests = sorted((test['seconds'], name) for name, test in self.found.items()
                       if test['fate'] == 'passed' and number in test['reached'])
        if not tests:
            return 'not reached'
        for done, (seconds, name) in enumerate(tests):
            limit -= seconds
            if done and limit < 0:
                return f'survived {done} of {len(tests)} tests'
            for attempt in 'first', 'second':
                fate = self.run(name, 20 + 5 * seconds, LINK_BOUNDS_MUTANT=str(number))
                if fate == 'timed out' or (fate == 'failed' and attempt == 'second'):
                    suffix = ', which timed out' if fate == 'timed out' else ''
                    return f'killed by {name}{suffix}'
                if fate == 'passed':
                    break
        return f'survived {len(tests)} of {len(tests)} tests'


def tried(log):
    if not log or not log.exists():
        return {}
    entries = map(json.loads, log.read_text('utf-8').splitlines())
    return {entry['mutant']: entry['fate'] for entry in entries}


def choose(tree, room, count):
    """(number, mutant) of each mutant that is tried, which are the same while the sources are."""
    known = {mutant.key: mutant for mutant in candidates(room)}
    file, wanted = tree.folder / 'chosen.json', [room, count, str(sorted(known.items()))]
    wanted[2] = hashlib.sha256(wanted[2].encode()).hexdigest()
    chosen = json.loads(file.read_text('utf-8')) if file.exists() else {}
    if chosen.get('wanted') != wanted:
        tree.copy({})
        tree.make('link_bounds_generate_messages_cpp')
        chosen = {'wanted': wanted, 'keys': [mutant.key for mutant in tree.choose(room, count)]}
        file.write_text(json.dumps(chosen), 'utf-8')
    return list(enumerate((known[key] for key in chosen['keys']), 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--count', type=int, default=200)
    parser.add_argument('--room', default='', help='a folder of src')
    parser.add_argument('--seconds', type=float, default=120, help='for the tests of one mutant')
    parser.add_argument('--log', type=pathlib.Path, help='default: FOLDER/mutants.jsonl')
    parser.add_argument('--before', type=pathlib.Path, help='the FILE of another version')
    arguments = parser.parse_args()
    tree = Tree(arguments.folder.resolve())
    log = arguments.log or tree.folder / 'mutants.jsonl'
    known, before = tried(log), tried(arguments.before)
    numbered = choose(tree, arguments.room, arguments.count)
    by_path = collections.defaultdict(list)
    for number, mutant in numbered:
        by_path[mutant.path].append((number, mutant))
    digest = tree.copy({path: mutated(path, items) for path, items in by_path.items()})
    tree.make('all tests')
    tests = Tests(tree, numbered, digest)

    def judge(item):
        number, mutant = item
        if mutant.key in known:
            return
        fate = tests.fate(number, arguments.seconds)
        entry = {'mutant': mutant.key, 'fate': fate, 'file': str(mutant.path), 'text': mutant.text,
                 'number': number}
        print(f'{number:4} {fate:24} {mutant.text}', flush=True)
        with tests.lock, log.open('a', encoding='utf-8') as file:
            known[mutant.key] = fate
            file.write(json.dumps(entry) + '\n')

    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        list(pool.map(judge, numbered))
    # Without the names and numbers of tests.
    counts = collections.Counter(re.match('killed|survived|not reached', known[mutant.key]).group()
                                 for _, mutant in numbered)
    print(', '.join(f'{count} {fate}' for fate, count in sorted(counts.items())))
    worse = [mutant.text for _, mutant in numbered if known[mutant.key].startswith('survived')
             and before.get(mutant.key, '').startswith('killed')]
    for text in worse:
        print('was killed before:', text)
    return 1 if worse else 0


if __name__ == '__main__':
    sys.exit(main())
