#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/packages.sh has a package for each key of package.xml: package_keys_test.py FOLDER"""
import subprocess
import sys
from xml.etree import ElementTree

# Debian's names for a key of rosdep, and a package whose name follows none of these forms.
OTHER_NAMES = {'eigen': 'libeigen3-dev'}
FORMS = ('{}', '{}-dev', 'lib{}-dev', 'libros-{}-dev', 'python3-{}', 'ros-{}')
GROUPS = 'build run test display link'


def keys(folder):
    package = ElementTree.parse(f'{folder}/package.xml').getroot()
    return {element.text for element in package if element.tag.endswith('depend')}


def packages(folder):
    command = f'. {folder}/scripts/packages.sh; for group in {GROUPS}; do packages_of $group; done'
    return set(subprocess.run(['bash', '-euc', command], check=True, capture_output=True,
                              text=True).stdout.split())


def is_known(key, known):
    name = key.replace('_', '-')
    if name.endswith('-dev'):
        name = name[:-len('-dev')]
    return OTHER_NAMES.get(name) in known or any(form.format(name) in known for form in FORMS)


def main():
    folder = sys.argv[1]
    known = packages(folder)
    missing = sorted(key for key in keys(folder) if not is_known(key, known))
    print('scripts/packages.sh has no package for: ' + ', '.join(missing) if missing else
          f'{len(keys(folder))} keys have a package')
    return 1 if missing else 0


if __name__ == '__main__':
    sys.exit(main())
