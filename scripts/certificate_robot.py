# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""URDF and STL files, for check_certificate: shapes and joints of which each number is exact or an
interval. Shares nothing with the library."""
import itertools
import math
import os
import re
import struct
import xml.etree.ElementTree as ElementTree

import numpy as np
from certificate_intervals import Interval, Pose, length, rotation, rounded


class NotCovered(Exception):
    """This program cannot read it."""


class Refused(Exception):
    """The file does not prove what it says."""


def numbers(text, count=3):
    values = np.array(text.split(), float)
    if len(values) != count or not np.isfinite(values).all():
        raise NotCovered('"%s" is not %d numbers' % (text, count))
    return values


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


def shape(element, file_of):
    """Balls of one radius around points of the link, and of which points each part is the hull."""
    solid = element.find('geometry')[0]
    radius = 0.0
    if solid.tag == 'box':
        corners = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
        points = corners * numbers(solid.get('size'))
    elif solid.tag == 'sphere':
        points, radius = np.zeros((1, 3)), numbers(solid.get('radius'), 1)[0]
    elif solid.tag == 'cylinder':  # in a prism
        outer = numbers(solid.get('radius'), 1)[0] / math.cos(math.pi / 64) * (1 + 1e-9)
        half = numbers(solid.get('length'), 1)[0] / 2
        angles = np.arange(64) * (math.pi / 32)
        points = np.array([(outer * math.cos(angle), outer * math.sin(angle), z)
                           for angle in angles for z in (-half, half)])
    elif solid.tag == 'mesh':
        points = triangles(file_of(solid.get('filename')))
    else:
        raise NotCovered('<%s> is unknown' % solid.tag)
    if not np.isfinite(points).all():
        raise NotCovered('a vertex is no number')
    points, index = np.unique(points, axis=0, return_inverse=True)
    scale = Interval(numbers(solid.get('scale', '1 1 1')))
    return (origin(element).apply(Interval(points) * scale), radius,
            index.reshape((-1, 3) if solid.tag == 'mesh' else (1, -1)))


class Robot:
    def __init__(self, file, given):
        tree = ElementTree.parse(file).getroot()
        self.folder, self.given, self.bodies = os.path.dirname(os.path.abspath(file)), given, {}
        self.links = {link.get('name'): link for link in tree.findall('link')}
        self.joints = {joint.get('name'): joint for joint in tree.findall('joint')}
        self.above = {joint.find('child').get('link'): joint for joint in self.joints.values()}

    def file_of(self, name):
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

    def cylinders(self, link, kinds):
        """Of each shape of body(): its pose, radius and length if it is a cylinder, or None."""
        for element in (element for element in self.links[link] if element.tag in kinds):
            solid = element.find('geometry').find('cylinder')
            yield None if solid is None else (
                origin(element), *(float(solid.get(name)) for name in ('radius', 'length')))

    def motion(self, joint):
        """Its type, its unit axis, and what lead() gives."""
        kind, axis = joint.get('type'), joint.find('axis')
        if kind not in ('fixed', 'revolute', 'continuous', 'prismatic'):
            raise NotCovered('a %s joint is on the way' % kind)
        axis = Interval([1.0, 0, 0] if axis is None else numbers(axis.get('xyz')))
        size = length(axis)
        return kind, axis * rounded(1 / size.hi, 1 / size.lo), self.lead(joint.get('name'))

    def lead(self, name):
        """Which joint this one follows, with factor and offset."""
        factor, offset = 1.0, 0.0
        while self.joints[name].find('mimic') is not None:
            mimic = self.joints[name].find('mimic')
            offset += factor * float(mimic.get('offset', 0))
            factor *= float(mimic.get('multiplier', 1))
            name = mimic.get('joint')
        return name, factor, offset

    def range(self, name):
        """Of a joint that follows none. One turn has all angles, unless others differ after it."""
        kind, limit = self.joints[name].get('type'), self.joints[name].find('limit')
        lower, upper = -math.inf, math.inf
        if kind != 'continuous':
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

    def root(self, link):
        while link in self.above:
            link = self.above[link].find('parent').get('link')
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
