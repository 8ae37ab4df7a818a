#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every file includes only headers of its own room and of rooms below it: layers_test.py PACKAGE

A room is a folder of src, with its folders of the same path in include/link_bounds and test.
"""
import collections
import pathlib
import re
import sys

# From the bottom to the top.
ROOMS = ['geometry', 'geometry/box', 'geometry/support/table', 'geometry/support/query',
         'geometry/support', 'geometry/mesh', 'geometry/shape', 'geometry/volumes',
         'geometry/parts', 'geometry/pairs', 'geometry/distance', 'geometry/cloud',
         'text', 'robot/urdf', 'robot/threads', 'robot/mesh', 'robot/worker', 'robot', 'robot/pairs',
         'robot/posed', 'robot/reach', 'robot/stopping',
         'packages', 'ros',
         'world/log', 'world/tf', 'world/model', 'world/bodies', 'world/moment', 'world/history',
         'world/stopping', 'world/path', 'world/cloud',
         'node/threads', 'node/interface', 'node/master', 'node/inputs', 'node/loading',
         'node/outputs/messages', 'node/outputs/markers', 'node/outputs/topic',
         'node/outputs/copies', 'node/outputs', 'node/services', 'node/upkeep', 'node',
         'tools/formats', 'tools/command_line', 'tools/urdf_bounds/request',
         'tools/urdf_bounds/poses', 'tools/urdf_bounds/reach', 'tools/urdf_bounds/pairs',
         'tools/urdf_bounds/path', 'tools/urdf_bounds', 'tools/mesh_worker',
         'tools/bag_bounds/bag/records', 'tools/bag_bounds/bag', 'tools/bag_bounds/scene',
         'tools/bag_bounds/boxes', 'tools/bag_bounds/watch', 'tools/bag_bounds/run',
         'tools/bag_bounds/lines', 'tools/bag_bounds', 'tools/cloud_filter', 'python',
         'bench/common', 'bench/core', 'bench/volumes', 'bench/overlaps', 'bench/distances',
         'bench/cloud', 'bench/pipeline', 'bench/node', 'bench/tools', 'bench']
ROOTS = ['include/link_bounds', 'src', 'test']
# Folders of test that are no rooms, and folders of tests that look at the node as a whole.
WITHOUT_RULES = ['test/consumer', 'test/fuzz', 'test/house', 'test/mutants', 'test/sanitizers',
                 'test/soak', 'test/testing']
WHOLE_NODE = ['test/node/demos', 'test/node/sequences']
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def level_of(folder):
    """The number of the room that the folder is, or is a part of; None if it is none."""
    while folder not in ROOMS:
        if '/' not in folder:
            return None
        folder = folder.rpartition('/')[0]
    return ROOMS.index(folder)


def upward(room, text):
    """The included headers of rooms above that one."""
    headers = (name[len('link_bounds/'):] if name.startswith('link_bounds/') else name
               for name in INCLUDE.findall(text))
    levels = ((header, level_of(header.rpartition('/')[0])) for header in headers if '/' in header)
    return [header for header, level in levels if level is not None and level > room]


def unplaced(text):
    """Headers included without their room's path; messages have none."""
    return [name for name in INCLUDE.findall(text)
            if '/' not in name or re.fullmatch(r'link_bounds/[a-z_]+\.h', name)]


def files_of(package):
    """Each source file with the level of its room."""
    for root in ROOTS:
        for path in sorted((package / root).rglob('*')):
            folder = path.parent.relative_to(package).as_posix()
            if path.suffix not in ('.h', '.cpp') or folder in WITHOUT_RULES:
                continue
            room = 'node' if folder in WHOLE_NODE else folder[len(root):].strip('/')
            # A room of src that is not listed would count as a part of the one around it.
            is_unlisted = root == 'src' and room and room not in ROOMS
            yield path, None if is_unlisted else level_of(room)


def faults_of(path, level):
    if level is None:
        return [f'{path} is in no room']
    text = path.read_text('utf-8')
    return ([f'{path}: {header} is above it' for header in upward(level, text)] +
            [f'{path}: {header} belongs to the node'
             for header in publishers(path.as_posix(), text)] +
            [f'{path}: {header} has no room' for header in unplaced(text)])


def publishers(path, text):
    """What src/world must not know: it computes, and the node sends."""
    headers = re.findall(r'#include <(ros/(?:ros|node_handle|publisher|subscriber|init)\.h)>', text)
    return headers if '/src/world/' in path else []


def types_of(text):
    """The types that a header makes for all of the namespace link_bounds."""
    shared = re.split(r'^namespace \{$', text, flags=re.MULTILINE)[0]
    definition = r'^(?:class|struct|enum class) (\w+)(?: [:{]| final|$)'
    return set(re.findall(definition, shared, re.MULTILINE))


def twice_named(texts):
    """Two types of one name would be one to the linker."""
    count = collections.Counter(name for text in texts for name in types_of(text))
    return [f'there are two types named {name}' for name in sorted(count) if count[name] > 1]


def check_rules():
    """The rules find planted faults; without that the test could not fail."""
    support = level_of('geometry/support/query')
    assert support == ROOMS.index('geometry/support/query')
    assert level_of('geometry/support/query/deeper') == support
    assert level_of('elsewhere') is None
    assert upward(support, '#include "link_bounds/geometry/shape/shape.h"\n')
    assert upward(support, '# include "geometry/shape/shape_steps.h"\n')
    assert upward(support, '#include "link_bounds/geometry/support/point_set.h"\n')
    assert not upward(support, '#include "link_bounds/geometry/box/aabb.h"\n')
    assert not upward(support, '// #include "geometry/shape/shape_steps.h"\n')
    assert publishers('/p/src/world/tf/a.cpp', '#include <ros/node_handle.h>\n')
    assert not publishers('/p/src/world/tf/a.cpp', '#include <ros/time.h>\n')
    assert twice_named(['struct Pair {\n', 'class Pair : public Body {\n'])
    assert not twice_named(['struct Pair {\n', 'class Pair;\n', 'namespace {\nstruct Pair {\n'])
    assert unplaced('#include "aabb.h"\n') and unplaced('#include "link_bounds/aabb.h"\n')
    assert not unplaced('#include "link_bounds/AxisAlignedBox.h"\n#include <vector>\n')


def main():
    check_rules()
    package = pathlib.Path(sys.argv[1])
    files = list(files_of(package))
    rooms = {level for _, level in files}
    faults = [fault for path, level in files for fault in faults_of(path, level)]
    faults += [f'there is no room {room}' for i, room in enumerate(ROOMS) if i not in rooms]
    faults += twice_named(path.read_text('utf-8') for path, _ in files
                          if path.suffix == '.h' and 'test' not in path.relative_to(package).parts)
    print('\n'.join(faults) or f'{len(files)} files include only what is below them')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
