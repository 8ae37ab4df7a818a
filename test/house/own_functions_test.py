#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The library calls its own functions, whatever a program that links it defines.

Templates such as Eigen's become weak functions of the library. By default the dynamic linker would
replace them by those of the program, whose compiler flags may give boxes other last bits.

Usage: own_functions_test.py LIBRARY ...
"""
import subprocess
import sys


def readelf(option, library):
    output = subprocess.run(['readelf', '--wide', option, library], check=True,
                            stdout=subprocess.PIPE, universal_newlines=True).stdout
    return [line.split() for line in output.splitlines()]


def defined_functions(library):
    """Names that the library exports; in a row: number, value, size, type, binding, visibility,
    section, name."""
    return {row[7].split('@')[0] for row in readelf('--dyn-syms', library)
            if len(row) > 7 and row[3] == 'FUNC' and row[6] != 'UND'}


def looked_up(library):
    """Names that the dynamic linker resolves; in a row: offset, info, type, value, name."""
    return {row[4].split('@')[0] for row in readelf('--relocs', library)
            if len(row) > 4 and row[2].startswith('R_')}


def main(library):
    defined = defined_functions(library)
    names = looked_up(library)
    if not defined or not names:
        print('no functions found in %s: does readelf print something else?' % library)
        return 1
    replaceable = sorted(defined & names)
    for name in replaceable[:10]:
        print('a program can replace', name)
    print('%d of %d functions can be replaced' % (len(replaceable), len(defined)))
    return 1 if replaceable else 0


if __name__ == '__main__':
    sys.exit(max(main(library) for library in sys.argv[1:]))
