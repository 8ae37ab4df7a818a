#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/packages.sh has a package for each key of package.xml, and the package for apt depends on
those that run beside it: package_keys_test.py FOLDER"""
import re
import subprocess
import sys
from xml.etree import ElementTree

# Debian's names for a key of rosdep, and a package whose name follows none of these forms.
OTHER_NAMES = {'bzip2': 'libbz2-dev', 'eigen': 'libeigen3-dev'}
FORMS = ('{}', '{}-dev', 'lib{}-dev', 'libros-{}-dev', 'python3-{}', 'ros-{}')
GROUPS = 'build run test display link'

# Groups that the package for apt depends on or recommends; keys that are libraries, on which it
# depends by ${shlibs:Depends}; and all that rosmsg and rossrv need: messages and manifest.
GROUPS_OF_DEB = 'run display link'
LIBRARIES = {'assimp', 'roscpp', 'rospack', 'tf2', 'tf2_ros'}
OF_MESSAGES = ('ros-{}', 'lib{}-dev')


def keys(folder, tags):
    package = ElementTree.parse(f'{folder}/package.xml').getroot()
    return {element.text for element in package if re.fullmatch(tags, element.tag)}


def packages(folder, groups):
    command = f'. {folder}/scripts/packages.sh; for group in {groups}; do packages_of $group; done'
    return set(subprocess.run(['bash', '-euc', command], check=True, capture_output=True,
                              text=True).stdout.split())


def is_known(key, known):
    name = key.replace('_', '-')
    if name.endswith('-dev'):
        name = name[:-len('-dev')]
    return OTHER_NAMES.get(name) in known or any(form.format(name) in known for form in FORMS)


def is_complete_at_run_time(key, known):
    if not key.endswith(('_msgs', '_srvs')):
        return is_known(key, known)
    return all(form.format(key.replace('_', '-')) in known for form in OF_MESSAGES)


def main():
    folder = sys.argv[1]
    known, of_deb = packages(folder, GROUPS), packages(folder, GROUPS_OF_DEB)
    all_keys = keys(folder, r'\w*depend')
    run_keys = keys(folder, '(exec_)?depend') - LIBRARIES
    missing = sorted(key for key in all_keys if not is_known(key, known))
    absent = sorted(key for key in run_keys if not is_complete_at_run_time(key, of_deb))
    if missing:
        print('scripts/packages.sh has no package for: ' + ', '.join(missing))
    if absent:
        print('the package for apt depends on no package for: ' + ', '.join(absent))
    if not missing and not absent:
        print(f'{len(all_keys)} keys have a package')
    return 1 if missing or absent else 0


if __name__ == '__main__':
    sys.exit(main())
