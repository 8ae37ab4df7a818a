#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every file includes the standard headers of what it names, itself or by a header of ours:
includes_test.py PACKAGE

Which headers of the standard library include each other differs from compiler to compiler, so a
file that leaves one out may compile here and not on another system.
"""
import pathlib
import re
import sys

NAMES = {
    'algorithm': 'all_of any_of clamp copy_if count_if equal fill fill_n find_if lower_bound max '
                 'max_element min min_element none_of nth_element reverse rotate shuffle sort '
                 'transform unique upper_bound',
    'array': 'array',
    'atomic': 'atomic',
    'chrono': 'chrono',
    'cmath': 'abs acos asin atan2 ceil cos floor frexp hypot isfinite isnan ldexp nan nextafter '
             'sin sqrt',
    'condition_variable': 'condition_variable',
    'cstdint': 'int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t',
    'cstdio': 'fopen printf remove snprintf',
    'cstdlib': 'abort exit getenv strtod strtol',
    'cstring': 'memcmp memcpy memset strcmp strerror strlen',
    'deque': 'deque',
    'filesystem': 'filesystem',
    'fstream': 'fstream ifstream ofstream',
    'functional': 'bind function greater hash less plus',
    'future': 'async future packaged_task promise',
    'iomanip': 'setfill setprecision setw',
    'iostream': 'cerr cin cout',
    'limits': 'numeric_limits',
    'list': 'list',
    'map': 'map multimap',
    'memory': 'make_shared make_unique shared_ptr unique_ptr weak_ptr',
    'mutex': 'call_once lock_guard mutex once_flag scoped_lock unique_lock',
    'numeric': 'accumulate inner_product iota partial_sum',
    'optional': 'make_optional nullopt optional',
    'random': 'mt19937 normal_distribution uniform_int_distribution uniform_real_distribution',
    'set': 'multiset set',
    'sstream': 'istringstream ostringstream stringstream',
    'stdexcept': 'invalid_argument logic_error out_of_range runtime_error',
    'string_view': 'string_view',
    'thread': 'this_thread thread',
    'tuple': 'make_tuple tie tuple',
    'unordered_map': 'unordered_map',
    'unordered_set': 'unordered_set',
    'variant': 'get_if holds_alternative variant visit',
}
HEADER_OF = {name: header for header, names in NAMES.items() for name in names.split()}
NAMED = re.compile(r'\bstd::(\w+)')
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r'//.*')
MIN_FILES = 300  # fewer are not this package


def needed(text):
    return {HEADER_OF[name] for name in NAMED.findall(COMMENT.sub('', text)) if name in HEADER_OF}


class Sources:
    def __init__(self, package):
        paths = (path for root in ('include', 'src', 'test')
                 for path in sorted((package / root).rglob('*')))
        self.texts = {path: path.read_text('utf-8') for path in paths
                      if path.suffix in ('.h', '.cpp')}
        self.by_name = {}
        for path in self.texts:
            self.by_name.setdefault(path.name, []).append(path)

    def ours(self, include):
        """Our headers that the include may mean: those whose path ends so."""
        parts = pathlib.PurePath(include).parts
        return [path for path in self.by_name.get(parts[-1], [])
                if path.parts[-len(parts):] == parts]

    def included(self, path, seen):
        """The standard headers, through any number of ours."""
        if path in seen:
            return set()
        seen.add(path)
        includes = INCLUDE.findall(self.texts[path])
        return set(includes).union(*(self.included(header, seen) for include in includes
                                     for header in self.ours(include)))

    def missing(self, path):
        return sorted(needed(self.texts[path]) - self.included(path, set()))


def check_that_it_fails():
    wrong = '#include <vector>\nstd::atomic<int> a;  // std::map\nint b = std::max(1, 2);\n'
    if needed(wrong) - set(INCLUDE.findall(wrong)) != {'atomic', 'algorithm'}:
        raise AssertionError('missing headers are not seen')


def main(package):
    check_that_it_fails()
    sources = Sources(package)
    faults = ['%s: <%s> is not included' % (path.relative_to(package), header)
              for path in sources.texts for header in sources.missing(path)]
    if len(sources.texts) < MIN_FILES:
        faults.append('only %d files were found in %s' % (len(sources.texts), package))
    print('\n'.join(faults) or '%d files include what they name' % len(sources.texts))
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
