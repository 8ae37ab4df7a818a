# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small robot descriptions, unusable, partly lost, or odd but right, and what must become of each.
"""
import bad_meshes


def links(*names):
    return ''.join('<link name="%s"/>' % name for name in names)


def joint(name, parent, child):
    return ('<joint name="%s" type="fixed"><parent link="%s"/><child link="%s"/></joint>'
            % (name, parent, child))


def robot(*elements):
    return '<robot name="small">%s</robot>' % ''.join(elements)


def visual(shape, origin=''):
    return '<visual>%s<geometry>%s</geometry></visual>' % (origin, shape)


# Name: description, and words of the reason.
UNUSABLE = {
    'empty': ('', 'empty'),
    'blank': (' \n', 'empty'),
    'no_xml': ('no xml', 'not a usable URDF'),
    'cut_off': ('<robot name="small"><link name="a"', 'not a usable URDF'),
    'no_robot': ('<html/>', 'not a usable URDF'),
    'no_link': (robot(), 'not a usable URDF'),
    'loop_beside_the_tree': (robot(links('base', 'a', 'b'), joint('j', 'a', 'b'),
                                   joint('k', 'b', 'a')), 'loop'),
    'loop_of_all': (robot(links('a', 'b'), joint('j', 'a', 'b'), joint('k', 'b', 'a')), 'root'),
    'own_child': (robot(links('a'), joint('j', 'a', 'a')), 'root'),
    'two_parents': (robot(links('a', 'b', 'c'), joint('j', 'a', 'b'), joint('k', 'a', 'c'),
                          joint('l', 'b', 'c')), '"c" has two parents'),
    'two_roots': (robot(links('a', 'b')), '[a] and [b]'),
    'two_links_of_one_name': (robot(links('a', 'a')), "'a' is not unique"),
    'two_joints_of_one_name': (robot(links('a', 'b', 'c'), joint('j', 'a', 'b'),
                                     joint('j', 'a', 'c')), "'j' is not unique"),
}

def mesh(filename, scale='1 1 1'):
    return visual('<mesh filename="%s" scale="%s"/>' % (filename, scale))


CUBE = 'file://%s' % (bad_meshes.FOLDER / 'cube.stl')
BOX = visual('<box size="2 2 2"/>')
MISSING = mesh('file:///no/such/mesh.stl')

# Name: content of a link; and words of the error, its exact box (low, high), or both.
LINKS = {
    'missing_mesh': (MISSING, '/no/such/mesh.stl'),
    'missing_mesh_beside_boxes': (BOX + MISSING + BOX, 'visual 2', ([-1] * 3, [1] * 3)),
    'relative_mesh': (mesh('no/such/mesh.stl'), 'no/such/mesh.stl'),
    'foreign_package': (mesh('package://no_such_package/mesh.stl'), '"no_such_package"'),
    'foreign_scheme': (mesh('http://127.0.0.1:9/mesh.stl'), 'http://127.0.0.1:9/mesh.stl'),
    'nan_size': (visual('<box size="1 nan 1"/>'), 'nan'),
    'two_numbers': (visual('<box size="1 2"/>'), '1 2'),
    'comma_for_point': (visual('<sphere radius="1,5"/>'), '1,5'),
    'nan_origin': (visual('<box size="1 1 1"/>', '<origin xyz="nan 0 0"/>'), 'nan'),
    'infinite_origin': (visual('<box size="1 1 1"/>', '<origin xyz="0 inf 0"/>'), 'inf'),
    'unknown_shape': (visual('<capsule radius="1" length="2"/>'), 'capsule'),
    'broken_inertial': ('<inertial><mass value="heavy"/></inertial>' + BOX, 'inertial'),
    'negative_size': (visual('<box size="1 -1 1"/>'), 'negative'),
    'negative_radius': (visual('<cylinder radius="-1" length="1"/>'), 'negative'),
    'nan_scale': (mesh(CUBE, '1 nan 1'), 'nan'),
    'one_number_scale': (mesh(CUBE, '2'), 'scale'),
    'mirrored': (mesh(CUBE, '-1 2 1'), ([-1, 0, 0], [0, 2, 1])),
    'zero_scale': (mesh(CUBE, '0 1 1'), ([0] * 3, [0, 1, 1])),
    'zero_size': (visual('<box size="0 0 0"/>'), ([0] * 3, [0] * 3)),
    'zero_radius': (visual('<cylinder radius="0" length="2"/>'), ([0, 0, -1], [0, 0, 1])),
}
