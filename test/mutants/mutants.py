#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Do the tests see it when one line of src is wrong?

Run as: mutants.py BUILD_FOLDER [--count N] [--room ROOM] [--log FILE.jsonl] [--before FILE.jsonl]

Changes one line at a time: another operator, a constant off by one, a condition turned round, a
statement left out. Builds, and runs the unit tests of the room, then those of the rooms above it,
until one fails. A mutant that passes them all has survived. Which lines are changed depends on
their text alone, not on where they stand: after files have moved, the same mutants are tried again.
The log has a line for each mutant, and one that is there is not tried again. Exit code 1 if a mutant
survives that was killed before.
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
# What is replaced by what, at one place of a line.
CHANGES = [(r' < ', ' <= '), (r' <= ', ' < '), (r' > ', ' >= '), (r' >= ', ' > '),
           (r' == ', ' != '), (r' != ', ' == '), (r' \+ ', ' - '), (r' - ', ' + '),
           (r' \* ', ' / '), (r' && ', ' || '), (r' \|\| ', ' && '), (r'std::min\(', 'std::max('),
           (r'std::max\(', 'std::min('), (r'\btrue\b', 'false'), (r'\bfalse\b', 'true'),
           (r'\b1\b(?![.\'])', '2'), (r'\b0\b(?![.\'x])', '1'), (r'\+\+', '--'), (r'\bif \(', 'if (!(')]
STATEMENT = re.compile(r'^ +[\w.:>\-\[\]]+(\(.*\)| [-+*|]?= .*);$')  # a call or an assignment
# Tests of texts, and those that take minutes, such as all that start a node.
NOT_RUN = 'house_|node_load_|_rostest_|three_hosts|certificate|master_restart|same_name'
ABOVE = {'geometry': ['geometry', 'robot', 'tools_urdf_bounds', 'world'],
         'robot': ['robot', 'tools_urdf_bounds'], 'world': ['world', 'node', 'tools_bag_bounds'],
         'node': ['node'], 'tools': ['tools'], 'text': ['text', 'tools'], 'packages': ['packages']}
SECONDS = 600  # for the tests of one room


def changed_lines(line):
    """(what was done, the line after it) for each way to change the line."""
    code = line.split('//')[0]
    if not code.strip() or code.lstrip().startswith(('#', '*', 'static_assert', 'template', 'namespace')):
        return
    for pattern, new in CHANGES:
        for match in re.finditer(pattern, code):
            rest = line[match.end():]
            if new == 'if (!(':
                if line.count('(') != line.count(')'):
                    continue
                rest = rest[:rest.rindex(')')] + '))' + rest[rest.rindex(')') + 1:]
            yield f'{match.group().strip()} at {match.start()}', line[:match.start()] + new + rest
    if STATEMENT.match(code):
        yield 'left out', '\n'


def mutants(room):
    """Sorted by their text, which gives the same order wherever the files are."""
    found = []
    for path in sorted((PACKAGE / 'src' / room).rglob('*.cpp')):
        seen = {}
        for number, line in enumerate(path.read_text('utf-8').splitlines(keepends=True)):
            seen[line] = seen.get(line, 0) + 1
            for change, new in changed_lines(line):
                text = f'{path.name} {seen[line]} {line.strip()} {change}'
                found.append((hashlib.sha256(text.encode()).hexdigest()[:16], path, number, new, text))
    return sorted(found, key=lambda mutant: mutant[0])


def run(command, folder, seconds=None):
    try:
        return subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=seconds,
                              check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def fate(path, build):
    """'killed by ROOM', 'survived', or 'does not compile'."""
    if not run(['cmake', '--build', '.', '--parallel', '2', '--target', 'all', 'tests'], build):
        return 'does not compile'
    parts = path.relative_to(PACKAGE / 'src').parent.parts
    rooms = ['_'.join(parts)] + ABOVE.get(parts[0], [])
    for room in dict.fromkeys(rooms):
        if not run(['ctest', '-R', f'(^|_gtest_){room}_', '-E', NOT_RUN, '-j', '4',
                    '--stop-on-failure', '--timeout', '300'], build, SECONDS):
            return 'killed by ' + room
    return 'survived'


def tried(log):
    if not log or not log.exists():
        return {}
    entries = map(json.loads, log.read_text('utf-8').splitlines())
    return {entry['mutant']: entry['fate'] for entry in entries}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('--count', type=int, default=200)
    parser.add_argument('--room', default='', help='a folder of src')
    parser.add_argument('--log', type=pathlib.Path)
    parser.add_argument('--before', type=pathlib.Path, help='the FILE of another version')
    arguments = parser.parse_args()
    known, before, worse, counts = tried(arguments.log), tried(arguments.before), [], {}
    chosen = mutants(arguments.room)[:arguments.count]
    for key, path, number, new, text in chosen:
        result = known.get(key)
        if result is None:
            lines = path.read_text('utf-8').splitlines(keepends=True)
            whole = ''.join(lines)
            try:
                path.write_text(''.join(lines[:number] + [new] + lines[number + 1:]), 'utf-8')
                result = fate(path, arguments.build)
            finally:
                path.write_text(whole, 'utf-8')
            if arguments.log:
                with arguments.log.open('a', encoding='utf-8') as log:
                    log.write(json.dumps({'mutant': key, 'fate': result, 'text': text}) + '\n')
        kind = result.split()[0]
        counts[kind] = counts.get(kind, 0) + 1
        print(f'{result:24} {text}', flush=True)
        if kind == 'survived' and before.get(key, '').startswith('killed'):
            worse.append(text)
    print(', '.join(f'{count} {kind}' for kind, count in sorted(counts.items())))
    for text in worse:
        print('was killed before:', text)
    return 1 if worse else 0


if __name__ == '__main__':
    sys.exit(main())
