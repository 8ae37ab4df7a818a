# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects around the robot, for check_certificate.

Of YAML only what is text, lists and maps counts, and a number is what urdf_bounds takes for one:
another reader of YAML makes 8 of 010."""
import math
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
from certificate_intervals import Interval, Pose, dot, exact, rounded
from certificate_robot import NotCovered, Refused, scaled, shape, solid_of

NUMBER = re.compile(r'[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?')


def number(text, what):
    value = float(text) if isinstance(text, str) and NUMBER.fullmatch(text) else math.nan
    if not math.isfinite(value):
        raise Refused('%s is "%s", but must be a number' % (what, text))
    return value


def plain(node, file):
    """What a node of YAML says: a text, a list, or a dict whose keys are texts that differ."""
    import yaml
    if isinstance(node, yaml.ScalarNode):
        return node.value
    if isinstance(node, yaml.SequenceNode):
        return [plain(each, file) for each in node.value]
    found = {}
    for key, value in node.value:
        name = plain(key, file)
        if not isinstance(name, str) or name in found:
            raise Refused('%s: a name is no text, or there twice: %s' % (file, name))
        found[name] = plain(value, file)
    return found


def fields_of(value, known, what):
    """The value, which must be a dict with no other keys."""
    if not isinstance(value, dict) or not value.keys() <= set(known):
        raise Refused('%s may have %s, but is %s' % (what, ', '.join(known), value))
    return value


def read_objects(file):
    """{name: fields}"""
    import yaml
    try:
        with open(file, encoding='utf-8') as text:
            documents = [node for node in yaml.compose_all(text, yaml.BaseLoader)
                         if not isinstance(node, yaml.ScalarNode) or node.value]
    except yaml.YAMLError as reason:
        raise Refused('%s is no YAML: %s' % (file, reason)) from reason
    objects = plain(documents[0], file) if len(documents) == 1 else None
    if not objects or not isinstance(objects, dict):
        raise Refused('%s has no objects, or several documents' % file)
    return objects


def add_objects(file, robot):
    """As links that are fixed to the root."""
    objects = read_objects(file)
    root = robot.root(next(iter(robot.links)))
    for name, fields in objects.items():
        what = '%s: object "%s"' % (file, name)
        if name in robot.links or not name:
            raise Refused('%s has the name of a link, or none' % what)
        joint = ElementTree.Element('joint', name='to object ' + name, type='fixed')
        ElementTree.SubElement(joint, 'parent', link=root)
        robot.joints[joint.get('name')] = robot.above[name] = joint
        robot.links[name] = ElementTree.Element('link')
        fields_of(fields, ('type', 'pose', 'scale', 'mesh_resource'), what)
        robot.bodies[name] = [placed(fields, robot, what)]
    return set(objects)


def placed(fields, robot, what):
    """The shape of an object."""
    kind, size = fields.get('type'), fields.get('scale')
    is_mesh = kind == 'MESH_RESOURCE'
    if is_mesh != ('mesh_resource' in fields) or (size is None and not is_mesh):
        raise Refused('%s has no size, or a mesh is missing or without its type' % what)
    scale = scale_of(size, what)
    if kind == 'SPHERE' and len(set(scale)) > 1 or kind == 'CYLINDER' and scale[0] != scale[1]:
        raise NotCovered('an object is an ellipsoid, or round in no circle')
    x, y, z = map(repr, scale)
    radius = repr(scale[0] / 2)
    text = {'CUBE': '<box size="%s %s %s"/>' % (x, y, z),
            'SPHERE': '<sphere radius="%s"/>' % radius,
            'CYLINDER': '<cylinder radius="%s" length="%s"/>' % (radius, z),
            'MESH_RESOURCE': '<mesh scale="%s %s %s"/>' % (x, y, z)}.get(kind)
    if text is None:
        raise Refused('%s is of the type "%s"' % (what, kind))
    element = ElementTree.fromstring('<visual><geometry>%s</geometry></visual>' % text)
    if is_mesh:
        if not fields['mesh_resource'].startswith(('file:///', 'package://')):
            raise NotCovered('the mesh of an object has a relative name')
        solid_of(element).set('filename', fields['mesh_resource'])
    frame, position = pose_of(fields.get('pose', {}), what)
    points, swell, parts = shape(element, robot.file_of)
    return frame.apply(points) + position, swell, parts


def scale_of(size, what):
    if size is None:
        return [1.0, 1.0, 1.0]
    fields_of(size, 'xyz', what + ': scale')
    scale = [number(size.get(key), '%s: %s of its scale' % (what, key)) for key in 'xyz']
    if min(scale) < 0 or max(scale) <= 0:
        raise Refused('%s: scale is negative or zero' % what)
    return scale


def pose_of(pose, what):
    """How it is turned, and where it is."""
    def read(name, keys):
        found = fields_of(pose.get(name, {}), keys, '%s: %s' % (what, name))
        return [number(found.get(key, '0'), '%s: %s of its %s' % (what, key, name)) for key in keys]
    fields_of(pose, ('position', 'orientation'), what + ': pose')
    turn = read('orientation', 'wxyz') if 'orientation' in pose else [1.0, 0.0, 0.0, 0.0]
    return quaternion(turn), Interval(read('position', 'xyz'))


def quaternion(values):
    """The rotation of the unit quaternion along w, x, y, z."""
    q = scaled(Interval(values))
    square = dot(q[None, 1:], q[None, 1:])[0] + q[0] * q[0]
    if not square.lo > 0:
        raise Refused('an orientation is zero')
    twice = rounded(2 / square.hi, 2 / square.lo)
    w, x, y, z = (q[i] for i in range(4))
    one = exact(1)
    rows = [[one - twice * (y * y + z * z), twice * (x * y - w * z), twice * (x * z + w * y)],
            [twice * (x * y + w * z), one - twice * (x * x + z * z), twice * (y * z - w * x)],
            [twice * (x * z - w * y), twice * (y * z + w * x), one - twice * (x * x + y * y)]]
    return Pose(Interval(*(np.array([[float(getattr(cell, end)) for cell in row] for row in rows])
                           for end in ('lo', 'hi'))))
