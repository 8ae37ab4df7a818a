# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Broken, hostile and odd robots with the expected result of each: those of test/data, which are
always there, and those of $LINK_BOUNDS_DATA/bad.

Each robot has a sound link "base", mostly another sound link "good", and "bad" with the fault.
"""
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'data'))
import bad_meshes
import bad_robots

DATA = os.path.join(os.environ.get('LINK_BOUNDS_DATA', ''), 'bad')
HAS_DATA = bool(os.environ.get('LINK_BOUNDS_DATA')) and os.path.exists(DATA)

# A program under a sanitizer is slow, and claims more address space than any limit allows.
SANITIZED = 'ASAN_OPTIONS' in os.environ or 'TSAN_OPTIONS' in os.environ
NEEDS_LIMIT = ['ply_header_1e9_vertices.ply', 'ply_huge_list.ply', 'billion_vertices.ply',
               'nested.dae']

BASE = ([-.5, -1, -1.5], [.5, 1, 1.5])
GOOD = ([0, 0, 5], [1, 1, 6])
UNIT = ([-.5] * 3, [.5] * 3)


def refused(words):
    """Exit 1, nothing on standard output, one error with these words."""
    return {'exit': 1, 'words': words}


def lost(words):
    """Base and good exact, bad without a box, named with these words."""
    return {'boxes': {'base': BASE, 'good': GOOD}, 'incomplete': ['bad'], 'words': words}


def boxed(**others):
    """Base and good exact, and so are the others; nothing is incomplete."""
    return {'boxes': dict({'base': BASE, 'good': GOOD}, **others)}


def bad_at_ten(low, high):
    """Link bad stands 10 m along x of the base."""
    return boxed(bad=([low[0] + 10] + low[1:], [high[0] + 10] + high[1:]))


def about(row):
    """Decimal text in the file, float32 in our vertices."""
    return dict(row, within=5e-8)


def along_x(prefix, numbers, step):
    """Unit boxes at x = number * step."""
    return {'boxes': {'%s%d' % (prefix, i): ([i * step - .5, -.5, -.5], [i * step + .5, .5, .5])
                      for i in numbers}}


URDF = {
    'good.urdf': boxed(),
    'missing_mesh.urdf': lost('does_not_exist.stl'),
    'missing_package.urdf': lost('no package "no_such_package_xyz"'),
    'file_uri_dev_zero.urdf': lost('/dev/zero is not a regular file'),
    'file_uri_directory.urdf': lost('/tmp is not a regular file'),
    'http_uri.urdf': lost('http://127.0.0.1:9/a.stl'),
    'no_filename.urdf': lost('filename'),
    'relative_uri.urdf': lost('meshes/good_cube.stl'),
    'triple_slash_package.urdf': lost('names no package'),
    'spaces_and_percent.urdf': bad_at_ten([0, 0, 0], [2, 2, 2]),  # %20 stands for a space
    'cycle.urdf': refused('loop'),
    'cycle_no_root.urdf': refused('root'),
    'two_roots.urdf': refused('[a] and [b]'),
    'two_parents.urdf': refused('"c" has two parents'),
    'self_child.urdf': refused('root'),
    'duplicate_links.urdf': refused("'x' is not unique"),
    'duplicate_joints.urdf': refused("'j' is not unique"),
    'empty_string.urdf': refused('empty'),
    'not_xml.urdf': refused('not a usable URDF'),
    'truncated_xml.urdf': refused('not a usable URDF'),
    'root_not_robot.urdf': refused("'robot'"),
    'negative_box.urdf': lost('negative'),
    'zero_box.urdf': bad_at_ten([0, 0, 0], [0, 0, 0]),
    'nan_box.urdf': lost('nan'),
    'negative_radius.urdf': lost('negative'),
    'nan_origin.urdf': lost('nan'),
    'inf_origin.urdf': lost('inf'),
    'comma_decimal.urdf': lost('1,5'),
    'zero_scale.urdf': bad_at_ten([0, 0, 0], [0, 1, 1]),
    'nan_scale.urdf': lost('nan'),
    'negative_scale.urdf': bad_at_ten([-1, -2, 0], [0, 0, 3]),
    'four_number_scale.urdf': lost('scale'),
    'bad_inertial_drops_geometry.urdf': lost('inertial'),
    'one_bad_of_three_visuals.urdf': {
        'boxes': {'base': BASE, 'good': GOOD, 'bad': ([-1] * 3, [1] * 3)},
        'incomplete': ['bad'], 'words': 'visual 2'},
    'floating_planar.urdf': boxed(f=UNIT, p=UNIT),  # no tf here: these joints stand at zero
    'odd_link_names.urdf': {'boxes': {name: UNIT for name in (
        'with space', '/leading_slash', 'a/b', 'ümläut_链接', '"quot"', '.', 'x' * 5000)}},
    'external_entity.urdf': refused('not a usable URDF'),
    'declaration_not_first.urdf': boxed(),
    'latin1_bytes.urdf': boxed(),
    'deep_20000.urdf': along_x('l', range(0, 20000, 100), .001),
    'wide_20000.urdf': along_x('l', range(20000), 1),
    'visuals_10000_in_one_link.urdf': {'boxes': {'base': ([-.1] * 3, [9999.1, .1, .1])}},
    'same_mesh_1000_links.urdf': {'boxes': {'l%d' % i: ([0] * 3, [1] * 3) for i in range(1000)}},
}

MESH = {
    'good_cube.stl': bad_at_ten([0, 0, 0], [1, 1, 1]),
    'truncated_binary.stl': lost('truncated_binary.stl'),
    'lying_count_huge.stl': lost('lying_count_huge.stl'),
    'lying_count_big.stl': lost('lying_count_big.stl'),
    'lying_count_small.stl': lost('lying_count_small.stl'),
    'empty_0_bytes.stl': lost('empty'),
    'zero_triangles.stl': lost('no facets'),
    'header_only_40_bytes.stl': lost('header_only_40_bytes.stl'),
    'one_inf_vertex.stl': lost('not a finite number'),
    'all_nan.stl': lost('not a finite number'),
    'single_triangle.stl': bad_at_ten([0, 0, 0], [1, 2, 3]),
    'coplanar_z0.stl': bad_at_ten([0, 0, 0], [10, 10, 0]),
    'collinear.stl': bad_at_ten([0, 0, 0], [11, 22, 33]),
    'one_vertex_no_face.obj': lost('one_vertex_no_face.obj'),
    'unreferenced_far_vertex.obj': bad_at_ten([0, 0, 0], [1, 1, 1]),
    'huge_1e30.stl': bad_at_ten([0, 0, 0], [1.0000000150474662e30] * 3),
    'huge_3e38.stl': bad_at_ten([0, 0, 0], [3.000000005497804e38] * 3),
    'denormal_1e-40.stl': bad_at_ten([0, 0, 0], [1e-40] * 3),
    'truncated_ascii.stl': lost('truncated_ascii.stl'),
    'garbage_numbers_ascii.stl': lost('real number'),
    'bad_index_zero.obj': lost('index'),
    'obj_mtllib_etc_passwd.obj': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'ngon_10000.obj': bad_at_ten([-1, -1, 0], [1, 1, 0]),
    'ply_header_1e9_vertices.ply': lost('ply_header_1e9_vertices.ply'),
    'ply_face_index_out_of_range.ply': lost('vertex 77 of 3'),
    'ply_huge_list.ply': lost('ply_huge_list.ply'),
    'dae_recursive_self.dae': lost('dae_recursive_self.dae'),
    'dae_recursive_pair.dae': lost('dae_recursive_pair.dae'),
    'dae_nested_5000.dae': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'dae_unit_nan.dae': lost('not a finite number'),
    'dae_node_matrix_nan.dae': lost('not a finite number'),
    'dae_lines_only.dae': lost('no triangle'),
    'dae_missing_geometry.dae': lost('Unable to find geometry'),
    'dae_unit_zero.dae': lost('unit of length is zero'),
    'real_igea_tristrips.ply': lost('triangle strips'),
    'dae_billion_laughs.dae': bad_at_ten([0, 0, 0], [1, 1, 0]),
    'text_named.stl': lost('text_named.stl'),
    'text_named.dae': lost('text_named.dae'),
    'random_bytes.obj': lost('random_bytes.obj'),
    'stl_no_extension': lost('stl_no_extension'),
    'gltf_outside_buffer.gltf': lost('could not open'),
    'gltf_huge_accessor.gltf': lost('out of range'),
    'real_r200_lines.dae': about(bad_at_ten([0, 0, -.0006146885], [.13, .02, .0057])),
    'real_iiwa_base_junk_after_end.dae': about(bad_at_ten([-.136, -.121265, 0],
                                                          [.121471, .121325, .1575])),
}

SMALL_ROBOT = """<robot name="small">
<link name="base"><visual><geometry><box size="1 2 3"/></geometry></visual></link>
<link name="good"><visual><geometry><mesh filename="file://%s/cube.stl"/></geometry></visual></link>
<link name="bad">%s</link>
<joint name="to_good" type="fixed"><parent link="base"/><child link="good"/>
<origin xyz="0 0 5"/></joint>
<joint name="to_bad" type="fixed"><parent link="base"/><child link="bad"/>
<origin xyz="10 0 0"/></joint>
</robot>"""


# Texts that users give for a URDF, and the words that say what they are.
NO_URDF = {
    'file_name': ('/opt/robots/arm.urdf\n', 'rosparam set robot_description -t FILE'),
    'xacro_file_name': ('$(find arm)/arm.urdf.xacro', 'command="xacro FILE"'),
    'xacro_file': ('<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">'
                   '<xacro:include filename="arm.xacro"/><xacro:arm prefix="${left}"/></robot>',
                   'command="xacro FILE"'),
    'xacro_file_with_percent': ('<robot name="r"><!-- 10 % --><xacro:arm/></robot>',
                                '<xacro:arm>'),
    'no_xml': ('100 % no XML', 'no XML element'),
    'broken_xml_with_percent': ('<?xml version="1.0"?>\n<!-- 10 % -->\n<robot name="r">\n'
                                '<link name="a">\n</robot>', 'see line 4'),
    'sdf_with_percent': ('<sdf version="1.6"><!-- 10 % --></sdf>', 'root element is <sdf>'),
    'two_roots_with_percent': ('<robot name="r"><!-- 10 % --><link name="a"/><link name="b"/>'
                               '</robot>', 'its XML is well-formed and its root is <robot>'),
}


class Case:
    """A robot and its expected result; {} if only the rules for all robots apply."""

    def __init__(self, name, text, expected):
        self.name = name
        self.text = text  # bytes
        self.expected = expected


def small_case(name, content, *expected):
    """Link "bad" of a small robot with that content; expected are words, a box or both."""
    words = next((item for item in expected if isinstance(item, str)), None)
    box = next((item for item in expected if not isinstance(item, str)), None)
    row = bad_at_ten(*box) if box else lost(words)
    if box and words:
        row.update(incomplete=['bad'], words=words)
    return Case(name, (SMALL_ROBOT % (bad_meshes.FOLDER, content)).encode(), row)


def small_cases():
    for name, (text, words) in NO_URDF.items():
        yield Case(name, text.encode(), refused(words))
    for name, (_, expected) in bad_meshes.MESHES.items():
        mesh = bad_robots.visual('<mesh filename="file://%s"/>' % (bad_meshes.FOLDER / name))
        yield small_case(name, mesh, expected)
    for name, (content, *expected) in bad_robots.LINKS.items():
        yield small_case(name, content, *expected)
    for name, (text, words) in bad_robots.UNUSABLE.items():
        yield Case(name, text.encode(), refused(words))


def large_cases():
    with open(os.path.join(DATA, 'cases.json'), encoding='utf-8') as file:
        rows = [(kind, name) for kind, name, *_ in json.load(file)]
    names = {name for _, name in rows}
    assert not (set(URDF) | set(MESH)) - names, 'cases without a file'
    for kind, name in rows:
        urdf = name if kind == 'urdf' else 'mesh__%s.urdf' % name.replace('.', '_')
        text = pathlib.Path(DATA, 'bad_inputs', 'urdf', urdf).read_bytes()
        yield Case(name, text, (URDF if kind == 'urdf' else MESH).get(name, {}))


def cases():
    """All cases that can run here; prints those that cannot."""
    if not HAS_DATA:
        print('skipped: the robots of $LINK_BOUNDS_DATA/bad, which is not there')
    for case in [*small_cases(), *(large_cases() if HAS_DATA else ())]:
        if SANITIZED and case.name in NEEDS_LIMIT:
            print('skipped: %s under a sanitizer, where memory cannot be limited' % case.name)
        else:
            yield case
