# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""URDF and STL files, for check_certificate: shapes and joints of which each number is exact or an
interval. Shares nothing with the library."""
import itertools
import math
import os
import re
import struct
import urllib.parse
import xml.etree.ElementTree as ElementTree

import numpy as np
from certificate_intervals import Interval, Pose, cross, dot, exact, length, rotation, rounded


SIDES = 512  # of the prism around a cylinder, which is wider by 2e-5 of its radius


class NotCovered(Exception):
    """This program cannot read it."""


class Unusable(Exception):
    """Something else is to be given."""


class Refused(Exception):
    """The file does not prove what it says."""


def numbers(text, count=3):
    values = np.array(text.split(), float)
    if len(values) != count or not np.isfinite(values).all():
        raise NotCovered('"%s" is not %d numbers' % (text, count))
    return values


def scaled(vector):
    """It times a power of two, which is exact, or nearly so for numbers that vanish. The largest is
    near 1 then: squares neither overflow nor vanish."""
    power = math.frexp(np.maximum(abs(vector.lo), abs(vector.hi)).max())[1]
    found = vector.map(lambda ends: np.ldexp(ends, -power))
    wider = rounded(found.lo, found.hi)
    return Interval(*(np.where(np.ldexp(end, power) == given, end, outside)
                      for end, given, outside in ((found.lo, vector.lo, wider.lo),
                                                  (found.hi, vector.hi, wider.hi))))


def unit(vector):
    vector = scaled(vector)
    size = length(vector)
    return vector * rounded(1 / size.hi, 1 / size.lo)


def axis_of(joint):
    axis = joint.find('axis')
    return np.array([1.0, 0, 0]) if axis is None else numbers(axis.get('xyz'))


def origin(element):
    found = element.find('origin')
    given = {} if found is None else found.attrib
    xyz, rpy = (numbers(given.get(name, '0 0 0')) for name in ('xyz', 'rpy'))
    x, y, z = (rotation(Interval(axis), angle) for axis, angle in zip(np.eye(3), rpy))
    return Pose(place=Interval(xyz)) * z * y * x


def triangles(path):
    with open(path, 'rb') as file:
        data = file.read()
    if len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from('<I', data, 80)[0]:
        rows = np.frombuffer(data, np.dtype([('f', '<f4', 12), ('a', '<u2')]), offset=84)
        return rows['f'][:, 3:].reshape(-1, 3).astype(float)
    words = re.findall(rb'vertex\s+(\S+)\s+(\S+)\s+(\S+)', data)
    if not data.lstrip().startswith(b'solid') or not words or len(words) % 3:
        raise NotCovered('%s is no STL file' % path)
    return np.array(words, np.float32).astype(float)


def solid_of(element):
    """The box, ball, cylinder or mesh of a <visual>, a <collision> or an object."""
    geometry = element.find('geometry')
    if geometry is None or len(geometry) != 1:
        raise NotCovered('a <%s> has not one shape' % element.tag)
    return geometry[0]


def shape(element, file_of):
    """Balls of one radius around points of the link, and of which points each part is the hull."""
    solid = solid_of(element)
    radius = 0.0
    if solid.tag == 'box':
        corners = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
        points = corners * numbers(solid.get('size'))
    elif solid.tag == 'sphere':
        points, radius = np.zeros((1, 3)), numbers(solid.get('radius'), 1)[0]
    elif solid.tag == 'cylinder':  # in a prism
        outer = numbers(solid.get('radius'), 1)[0] / math.cos(math.pi / SIDES) * (1 + 1e-9)
        half = numbers(solid.get('length'), 1)[0] / 2
        angles = np.arange(SIDES) * (2 * math.pi / SIDES)
        points = np.array([(outer * math.cos(angle), outer * math.sin(angle), z)
                           for angle in angles for z in (-half, half)])
    elif solid.tag == 'mesh':
        points = triangles(file_of(solid.get('filename')))
    else:
        raise NotCovered('<%s> is unknown' % solid.tag)
    if not np.isfinite(points).all():
        raise NotCovered('a vertex is no number')
    points, index = np.unique(points, axis=0, return_inverse=True)
    scale = Interval(numbers(solid.get('scale', '1 1 1') if solid.tag == 'mesh' else '1 1 1'))
    return (origin(element).apply(Interval(points) * scale), radius,
            index.reshape((-1, 3) if solid.tag == 'mesh' else (1, -1)))


def nearest(points, parts, hint):
    """A point of a triangle of a mesh near there."""
    corners = points.lo[parts]
    edges = corners[:, 1:] - corners[:, :1]
    gram = edges @ edges.transpose(0, 2, 1)
    along = (edges @ (hint - corners[:, 0])[..., None])[..., 0]
    weights = np.stack([gram[:, 1, 1] * along[:, 0] - gram[:, 0, 1] * along[:, 1],
                        gram[:, 0, 0] * along[:, 1] - gram[:, 0, 1] * along[:, 0]], 1)
    weights /= np.maximum(np.linalg.det(gram), 1e-300)[:, None]
    weights = np.clip(weights, 0, 1)
    weights /= np.maximum(1, weights.sum(1) * (1 + 1e-15))[:, None]
    found = corners[:, 0] + (weights[:, None] @ edges)[:, 0]
    best = np.argmin(np.linalg.norm(found - hint, axis=1))
    a, b, c = (points[i] for i in parts[best])
    return a + (b - a) * exact(weights[best, 0]) + (c - a) * exact(weights[best, 1])


def inside(element, body, hint):
    """A point of the shape near there, and the radius of a ball around it that is in the shape."""
    solid, (points, _, parts) = solid_of(element), body
    if solid.tag == 'mesh':
        return nearest(points, parts, hint), 0.0
    place, rooms = origin(element), []
    p = place.inverse().apply(Interval(hint)).lo
    if solid.tag != 'box':
        radius, of_circle = numbers(solid.get('radius'), 1)[0], solid.tag == 'cylinder'
        around = p * (1, 1, 0 if of_circle else 1)
        p -= around * (1 - min(1, radius * (1 - 1e-15) / max(np.linalg.norm(around), 1e-300)))
        rooms.append(exact(radius) - length(Interval(p * (1, 1, 0 if of_circle else 1))))
    if solid.tag != 'sphere':
        axes = slice(0 if solid.tag == 'box' else 2, 3)
        half = numbers(solid.get('size') or solid.get('length'), axes.stop - axes.start) / 2
        p[axes] = np.clip(p[axes], -half, half)
        rooms.append(Interval(half) - abs(Interval(p[axes])))
    return place.apply(Interval(p)), min(room.lo.min() for room in rooms)


def parsed(path):
    """The XML of a robot description, of which urdf_bounds takes more than this program does."""
    with open(path, 'rb') as file:
        data = file.read()
    try:
        tree = ElementTree.fromstring(data)
    except ElementTree.ParseError as reason:
        raise NotCovered('%s is no XML by the rules: %s' % (path, reason)) from reason
    encoding = re.match(rb'[^>]*encoding=.([\w-]+)', data)
    if tree.tag != 'robot' or (encoding and encoding[1].lower() not in (b'utf-8', b'us-ascii')):
        raise NotCovered('%s has a default namespace, or another encoding than UTF-8' % path)
    return tree


class Robot:
    def __init__(self, file, given):
        tree = parsed(file)
        self.name = tree.get('name')
        self.folder, self.given, self.bodies = os.path.dirname(os.path.abspath(file)), given, {}
        self.links = {link.get('name'): link for link in tree.findall('link')}
        self.joints = {joint.get('name'): joint for joint in tree.findall('joint')}
        self.above = {joint.find('child').get('link'): joint for joint in self.joints.values()}
        self.axes = {}  # of the parts of joints
        for joint in list(self.joints.values()):
            if joint.get('type') in ('floating', 'planar'):
                self.split(joint)
        for link in self.above:
            self.root(link)  # which refuses loops, in which way() would not end

    def split(self, whole):
        """A floating or planar joint is a chain of joints with one value each, its parts."""
        if whole.get('type') == 'floating':
            x, y, z = (Interval(axis) for axis in np.eye(3))
            parts = {'x': x, 'y': y, 'z': z, 'yaw': z, 'pitch': y, 'roll': x}
        else:  # the plane of x and y is square to the axis; x is near the frame's axis after it
            normal = unit(Interval(axis_of(whole)))
            x = Interval(np.eye(3)[(np.abs(axis_of(whole)).argmax() + 1) % 3])
            x = unit(x - normal * dot(x, normal))
            parts = {'x': x, 'y': cross(normal, x), 'yaw': normal}
        parent, child = (whole.find(end).get('link') for end in ('parent', 'child'))
        for part, axis in parts.items():
            name = '%s.%s' % (whole.get('name'), part)
            joint = ElementTree.Element('joint', name=name, part_of=whole.get('name'),
                                        type='prismatic' if part in 'xyz' else 'continuous')
            ElementTree.SubElement(joint, 'parent', link=parent)
            joint.extend(whole.findall('origin') if part == 'x' else ())
            parent = child if part == list(parts)[-1] else name
            self.joints[name], self.above[parent], self.axes[name] = joint, joint, axis
        del self.joints[whole.get('name')]

    def fix_base(self):
        """What is floating or planar at the root stays at 0."""
        for name, joint in self.joints.items():
            whole, link = joint.get('part_of'), joint.find('parent').get('link')
            above = self.way(self.root(link), link)
            if whole and all(each.get('type') == 'fixed' or each.get('part_of') == whole
                             for each, _ in above):
                self.given[name] = 0.0, 0.0

    def file_of(self, name):
        name = urllib.parse.unquote(name)
        if not name.startswith('package://'):
            return os.path.join(self.folder, re.sub('^file://', '', name))
        package, _, rest = name[len('package://'):].partition('/')
        for root in filter(None, os.environ.get('ROS_PACKAGE_PATH', '').split(':')):
            for folder, below, files in os.walk(root):
                if 'package.xml' in files:
                    below.clear()
                    manifest = ElementTree.parse(os.path.join(folder, 'package.xml'))
                    if manifest.findtext('name').strip() == package:
                        return os.path.join(folder, rest)
        raise NotCovered('package %s is not in ROS_PACKAGE_PATH' % package)

    def body(self, link, kinds):
        if link not in self.bodies:
            elements = [element for element in self.links[link] if element.tag in kinds]
            self.bodies[link] = [shape(element, self.file_of) for element in elements]
        return self.bodies[link]

    def inside(self, link, kinds, hint):
        """A point of the link near there, and the radius of a ball around it that is in the link."""
        hint = np.array(hint, float)
        if hint.shape != (3,) or not np.isfinite(hint).all():
            raise Refused('%s is no point' % hint)
        elements = [element for element in self.links[link] if element.tag in kinds]
        found = [inside(*shape, hint) for shape in zip(elements, self.body(link, kinds))]
        return max(found, key=lambda ball: ball[1] - np.linalg.norm(ball[0].lo - hint))

    def cylinders(self, link, kinds):
        """Of each shape of body(): its pose, radius and length if it is a cylinder, or None."""
        for element in (element for element in self.links[link] if element.tag in kinds):
            solid = solid_of(element)
            yield None if solid.tag != 'cylinder' else (
                origin(element), *(float(solid.get(name)) for name in ('radius', 'length')))

    def motion(self, joint):
        """Its type, its unit axis, and what lead() gives."""
        kind, name = joint.get('type'), joint.get('name')
        if kind not in ('fixed', 'revolute', 'continuous', 'prismatic'):
            raise NotCovered('a %s joint is on the way' % kind)
        axis = self.axes[name] if name in self.axes else unit(Interval(axis_of(joint)))
        return kind, axis, self.lead(name)

    def lead(self, name):
        """Which joint this one follows, with factor and offset."""
        factor, offset, passed = 1.0, 0.0, set()
        while self.joints[name].find('mimic') is not None:
            if name in passed:
                raise NotCovered('joint %s follows itself' % name)
            passed.add(name)
            mimic = self.joints[name].find('mimic')
            offset += factor * float(mimic.get('offset', 0))
            factor *= float(mimic.get('multiplier', 1))
            name = mimic.get('joint')
        return name, factor, offset

    def range(self, name):
        """Of a joint that follows none. One turn has all angles, unless others differ after it."""
        kind, limit = self.joints[name].get('type'), self.joints[name].find('limit')
        if kind == 'fixed':
            return [0.0, 0.0]
        lower, upper = -math.inf, math.inf
        if kind != 'continuous' and limit is not None:
            lower, upper = (float(limit.get(end, 0)) for end in ('lower', 'upper'))
        lower, upper = self.given.get(name, (lower, upper))
        leads = [(joint, self.lead(other)) for other, joint in self.joints.items()]
        returns = all(factor == int(factor) and joint.get('type') != 'prismatic'
                      for joint, (leader, factor, _) in leads if leader == name)
        if returns and upper - lower >= 2 * math.pi - 1e-12:
            middle = min(max(0.0, lower + math.pi), upper - math.pi)
            return [middle - math.pi - 1e-14, middle + math.pi + 1e-14]
        if not lower <= upper or math.isinf(upper - lower):
            raise NotCovered('joint %s has no range' % name)
        return [lower, upper]

    def bounded(self, kinds):
        """The links that have geometry."""
        return [name for name, link in self.links.items() if any(e.tag in kinds for e in link)]

    def root(self, link):
        passed = {link}
        while link in self.above:
            link = self.above[link].find('parent').get('link')
            if link in passed:
                raise Unusable('the joints above link %s are a loop' % link)
            passed.add(link)
        return link

    def way(self, first, second):
        """From one link to another: the joints, and whether they are passed upward."""
        ways = []
        for link in (first, second):
            ways.append([])
            while link in self.above:
                ways[-1].append(self.above[link])
                link = ways[-1][-1].find('parent').get('link')
        while ways[0] and ways[1] and ways[0][-1] is ways[1][-1]:
            ways = [ways[0][:-1], ways[1][:-1]]
        return [(joint, True) for joint in ways[0]] + [(joint, False) for joint in ways[1][::-1]]

    def moving(self, first, second):
        """The joints between two links that are not fixed; one with parts is one."""
        return {joint.get('part_of', joint.get('name')) for joint, _ in self.way(first, second)
                if joint.get('type') != 'fixed'}
