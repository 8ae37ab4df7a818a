#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""package.xml: each key is one of rosdep's and has a package in scripts/packages.sh; the package for
apt depends on those that run beside it; who builds with messages and library gets what he needs,
and nothing that only a display needs: package_keys_test.py FOLDER"""
import pathlib
import re
import subprocess
import sys
from xml.etree import ElementTree

# Debian's names for a key of rosdep, and a package whose name follows none of these forms.
OTHER_NAMES = {'bzip2': 'libbz2-dev', 'eigen': 'libeigen3-dev', 'nodelet': 'libnodeletlib-tools',
               'pluginlib': 'libnodeletlib-dev',
               'robot_state_publisher': 'ros-robot-state-publisher'}
FORMS = ('{}', '{}-dev', 'lib{}-dev', 'libros-{}-dev', 'python3-{}', 'ros-{}')
GROUPS = 'build nodelet manager run demo test display link'

# Keys that are libraries, on which packages for apt depend by ${shlibs:Depends}; and all that rosmsg
# and rossrv need: messages and manifest.
LIBRARIES = {'assimp', 'roscpp', 'rospack', 'tf2', 'tf2_ros'}
OF_MESSAGES = ('ros-{}', 'lib{}-dev')
DISPLAY_ONLY = {'rviz'}

# Packages of the public headers of C++, by the first folder of what they include.
HEADERS = {'Eigen': 'eigen', 'geometry_msgs': 'geometry_msgs', 'std_msgs': 'std_msgs',
           'trajectory_msgs': 'trajectory_msgs'}


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


def rosdep_keys(folder):
    with open(f'{folder}/test/data/rosdep_keys.txt', encoding='utf-8') as file:
        return {line.strip() for line in file if not line.startswith('#')}


def texts(folder, patterns):
    return {path: path.read_text(encoding='utf-8')
            for pattern in patterns for path in pathlib.Path(folder).glob(pattern)}


def exported_packages(folder):
    """What our headers and messages use of other packages."""
    text = '\n'.join(texts(folder, ['include/**/*.h', 'msg/*.msg', 'srv/*.srv']).values())
    names = re.findall(r'^(?:#include <)?(\w+)/\w+', text, re.MULTILINE)
    return {HEADERS[name] for name in names if name in HEADERS} | {'message_runtime'}


def groups_of_deb(folder):
    """The groups that the packages for apt depend on or recommend, to run or to be linked."""
    control = pathlib.Path(folder, 'scripts/debian/control.in').read_text(encoding='utf-8')
    binary_packages = control.split('\nPackage: ', 1)[1]
    return ' '.join(re.findall('^@packages (.*)@$', binary_packages, re.MULTILINE))


def launched_packages(folder):
    """Of the nodes in launch files and tests."""
    files = texts(folder, ['launch/*.launch', 'test/**/*.test'])
    return {name for text in files.values() for name in re.findall(r'<node[^>]*\spkg="(.*?)"', text)}


def main():
    folder = sys.argv[1]
    known, of_deb = packages(folder, GROUPS), packages(folder, groups_of_deb(folder))
    all_keys = keys(folder, r'\w*depend')
    run_keys = keys(folder, '(exec_)?depend') - LIBRARIES
    export_keys = keys(folder, '(build_export_)?depend')
    cmake = texts(folder, ['CMakeLists.txt', 'src/**/CMakeLists.txt', 'src/**/*.cmake'])
    lists = {
        'test/data/rosdep_keys.txt, the list of rosdep\'s keys, lacks':
            all_keys - rosdep_keys(folder),
        'scripts/packages.sh has no package for':
            {key for key in all_keys if not is_known(key, known)},
        'the packages for apt depend on no package for':
            {key for key in run_keys if not is_complete_at_run_time(key, of_deb)},
        'only a display needs, so package.xml should have as test_depend':
            DISPLAY_ONLY & keys(folder, '(exec_|build_export_|build_)?depend'),
        'launch files start nodes of, so package.xml should have as exec_depend or test_depend':
            launched_packages(folder) - keys(folder, '(exec_|test_)?depend') - {'link_bounds'},
        'only the demos need, so the packages for apt should only recommend':
            {name for name in packages(folder, 'run') if re.search('rviz|state-publisher', name)},
        'headers and messages need, so package.xml should have as build_export_depend':
            exported_packages(folder) - export_keys,
        'the tests need, so package.xml should have as test_depend':
            {'rostest'} - keys(folder, 'test_depend'),
        'ROS One refuses the flag -std in':
            {path.name for path, text in cmake.items() if re.search('-std=|CXX_STANDARD', text)},
        'warnings must not be errors in a user\'s build, so OFF should be the default in':
            {path.name for path, text in cmake.items()
             if re.search(r'option\(LINK_BOUNDS_WERROR [^)]* ON\)', text)},
        'the tests accept warnings, because -DLINK_BOUNDS_WERROR=ON is missing in':
            {path.name for path, text in texts(folder, ['scripts/test', 'scripts/san*.sh']).items()
             if 'DLINK_BOUNDS_WERROR=ON' not in text},
    }
    for words, names in lists.items():
        if names:
            print(f'{words}: ' + ', '.join(sorted(names)))
    if not any(lists.values()):
        print(f'{len(all_keys)} keys have a package')
    return 1 if any(lists.values()) else 0


if __name__ == '__main__':
    sys.exit(main())
