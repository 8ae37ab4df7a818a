#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The libraries know neither ROS nor assimp, and only mesh_worker loads assimp, which may crash on
a mesh: no_ros_test.py LIBLINK_BOUNDS_SO MESH_WORKER PROGRAM ..."""

import pathlib
import re
import subprocess
import sys

FORBIDDEN_INCLUDE = re.compile(
    r'^\s*#\s*include\s*[<"]'
    r'((ros|tf2?|tf2_\w+|rosconsole|assimp|std_srvs|\w+_msgs)/[^>"]*|urdf/model\.h)[>"]',
    re.MULTILINE)
FORBIDDEN_LIBRARY = re.compile(
    r'lib(roscpp\w*|rosconsole\w*|roslib|tf2\w*|rostime|cpp_common|xmlrpcpp|assimp)\.so')


def forbidden_includes(text):
    return [match.group(1) for match in FORBIDDEN_INCLUDE.finditer(text)]


def forbidden_libraries(dynamic_section):
    needed = [line for line in dynamic_section.splitlines() if '(NEEDED)' in line]
    return [match.group(0) for line in needed for match in FORBIDDEN_LIBRARY.finditer(line)]


def check_patterns():
    """The patterns match what they must find; without that the test could not fail."""
    bad = ['ros/ros.h', 'ros/package.h', 'tf2/buffer_core.h', 'tf2_ros/buffer.h',
           'rosconsole/macros_generated.h', 'geometry_msgs/Point.h', 'std_srvs/Trigger.h',
           'assimp/scene.h']
    for header in bad:
        for line in (f'#include <{header}>', f'  # include "{header}"'):
            assert forbidden_includes(f'// first\n{line}\n') == [header], line
    good = ('#include <Eigen/Core>\n#include "link_bounds/geometry/box/aabb.h"\n'
            '// #include <ros/ros.h>\n')
    assert not forbidden_includes(good)
    for name in ('roscpp', 'rosconsole', 'roslib', 'tf2', 'rostime', 'cpp_common', 'xmlrpcpp',
                 'roscpp_serialization', 'assimp'):
        line = f' 0x1 (NEEDED)  Shared library: [lib{name}.so.5]'
        assert forbidden_libraries(line), line
    assert not forbidden_libraries(' 0x1 (NEEDED)  Shared library: [liburdfdom_model.so.3.0]')
    assert not forbidden_libraries(' 0xf (RUNPATH)  Library runpath: [/opt/libroscpp.so]')


# The conversions to and from messages, in no library.
KNOWS_ROS = 'include/link_bounds/ros/messages.h'
# The end of the worker process that reads meshes.
KNOWS_ASSIMP = ('confined_files.cpp', 'confined_files.h', 'mesh_formats.cpp', 'mesh_formats.h',
                'mesh_import.cpp', 'mesh_text.h')


def check_sources(package):
    sources = [path for folder in ('include', 'src/geometry', 'src/robot')
               for path in sorted((package / folder).rglob('*')) if path.suffix in ('.h', '.cpp')
               and path.name not in KNOWS_ASSIMP and path != package / KNOWS_ROS]
    assert forbidden_includes((package / KNOWS_ROS).read_text('utf-8')), 'it needs no exception'
    assert len(sources) > 20, 'the sources have moved, this test looks in the wrong place'
    return [f'{path.relative_to(package)} includes {header}'
            for path in sources for header in forbidden_includes(path.read_text('utf-8'))]


def check_library(path):
    section = subprocess.run(['readelf', '-d', path], check=True, capture_output=True,
                             text=True, env={'LC_ALL': 'C', 'PATH': '/usr/bin:/bin'}).stdout
    assert 'urdfdom' in section, 'this is not the library, which is known to need urdfdom'
    return [f'{path} needs {library}' for library in forbidden_libraries(section)]


def loads_assimp(program):
    """True if the program or one of its libraries needs assimp."""
    return 'libassimp' in subprocess.run(['ldd', program], check=True, capture_output=True,
                                         text=True).stdout


def check_programs(worker, programs):
    assert loads_assimp(worker), 'mesh_worker is known to need assimp'
    return [f'{program} loads assimp' for program in programs if loads_assimp(program)]


def main():
    library, worker, *programs = sys.argv[1:]
    check_patterns()
    faults = (check_sources(pathlib.Path(__file__).resolve().parents[2]) + check_library(library) +
              check_programs(worker, programs))
    print('\n'.join(faults) or 'the core library knows neither ROS nor assimp')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
