# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot and parameters as plain data: their text for the node, and the model they must give."""
import os

import numpy
from sequences_shapes import IDENTITY, ZERO, Shape, rpy_matrix, stl

DEFAULTS = dict(fixed_frame="", geometry="visual", links=[], ignore_links=[], padding=0.0,
                link_padding={}, groups={}, max_rate=0.0, timeout=2.0, overlap_margin=0.0,
                ignore_pairs=[], attached={}, adjacent_joints=1, parts_per_link=1)


class Element:
    """A <visual> or <collision>: a box, cylinder, sphere, or the name of a mesh file."""

    def __init__(self, kind, size=(1, 1, 1), mesh=None, xyz=None, rpy=(0, 0, 0)):
        self.kind, self.size, self.mesh = kind, tuple(map(float, size)), mesh
        self.xyz = None if xyz is None else tuple(map(float, xyz))  # None: there is no <origin>
        self.rpy = tuple(map(float, rpy))

    def text(self, tag, folder):
        geometry = {"box": '<box size="%r %r %r"/>' % self.size,
                    "cylinder": '<cylinder radius="%r" length="%r"/>' % self.size[1:],
                    "sphere": '<sphere radius="%r"/>' % self.size[0],
                    "mesh": '<mesh filename="file://%s/%s" scale="%r %r %r"/>' % (
                        folder, self.mesh, *self.size)}[self.kind]
        origin = "" if self.xyz is None else '<origin xyz="%r %r %r" rpy="%r %r %r"/>' % (
            *self.xyz, *self.rpy)
        return "<%s>%s<geometry>%s</geometry></%s>" % (tag, origin, geometry, tag)

    def shape(self, meshes):
        """None if the mesh file cannot be used."""
        linear = IDENTITY if self.xyz is None else rpy_matrix(self.rpy)
        offset = ZERO if self.xyz is None else self.xyz
        if self.kind == "box":
            return Shape(None, "box", self.size, linear, offset)
        if self.kind == "cylinder":
            return Shape(None, "cylinder", (2 * self.size[1], 2 * self.size[1], self.size[2]),
                         linear, offset)
        if self.kind == "sphere":
            return Shape(None, "ellipsoid", [2 * self.size[0]] * 3, linear, offset)
        points = meshes.points.get(self.mesh)
        return None if points is None else Shape(points * self.size, "none", ZERO, linear, offset)


class Link:
    """A link of a URDF with the joint to its parent. The first one is the root."""

    def __init__(self, name, parent=None, is_fixed=False, visual=(), collision=()):
        self.name, self.parent, self.is_fixed = name, parent, is_fixed
        self.visual, self.collision = list(visual), list(collision)

    def text(self, folder):
        elements = [e.text("visual", folder) for e in self.visual]
        elements += [e.text("collision", folder) for e in self.collision]
        joint = "" if self.parent is None else (
            '<joint name="to_%s" type="%s"><parent link="%s"/><child link="%s"/></joint>' % (
                self.name, "fixed" if self.is_fixed else "floating", self.parent, self.name))
        return '<link name="%s">%s</link>%s' % (self.name, "".join(elements), joint)


def description(links, folder):
    return '<robot name="sequences">%s</robot>' % "".join(link.text(folder) for link in links)


class Meshes:
    """Files that the node reads, and their points: float32, as they are in the file."""

    def __init__(self, folder):
        self.folder = folder
        self.points = {}

    def write(self, name, points, keeps_time=False):
        """Without points the file is no mesh. keeps_time: with the times of the file before it."""
        path = os.path.join(self.folder, name)
        before = os.stat(path) if keeps_time and os.path.exists(path) else None
        with open(path, "wb") as file:
            file.write(b"no mesh" if points is None else stl(points))
        if before:
            os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        self.points[name] = None if points is None else numpy.array(
            numpy.array(points, dtype=numpy.float32), dtype=float)

    def of_uri(self, uri):
        return self.points.get(os.path.basename(uri))


class BoundedLink:
    def __init__(self, link, elements, parameters, meshes):
        self.name = self.frame = link.name
        shapes = [element.shape(meshes) for element in elements]
        self.is_complete = all(shapes)
        self.shapes = [shape for shape in shapes if shape]
        self.padding = parameters["link_padding"].get(link.name, parameters["padding"])


class Model:
    """The robot with its parameters, as the node loads them."""

    def __init__(self, links, parameters, meshes):
        self.parameters = dict(DEFAULTS, **parameters)
        self.fixed_frame = self.parameters["fixed_frame"].lstrip("/") or links[0].name
        self.timeout = self.parameters["timeout"]
        self.links = [BoundedLink(link, self._elements(link), self.parameters, meshes)
                      for link in links if self._elements(link) and self._is_chosen(link.name)]
        self.without_geometry = {link.name for link in links if not self._elements(link)}
        self._bodies = rigid_bodies(links)

    def _elements(self, link):
        return {"visual": link.visual, "collision": link.collision,
                "both": link.visual + link.collision}[self.parameters["geometry"]]

    def _is_chosen(self, name):
        chosen, ignored = self.parameters["links"], self.parameters["ignore_links"]
        return (not chosen or name in chosen) and name not in ignored

    def are_joined(self, a, b):
        """Links with at most adjacent_joints movable joints between their rigid bodies. Objects are
        part of those to which they are attached."""
        a, b = self._holder(a), self._holder(b)
        if a not in self._bodies or b not in self._bodies:
            return False
        way_a, way_b = self._way_to_root(a), self._way_to_root(b)
        return len(set(way_a) ^ set(way_b)) <= self.parameters["adjacent_joints"]

    def _holder(self, name):
        """The link to which an object is attached, by NS/ID or NS/*; other names as they are."""
        for link in self._bodies:
            if {name, name.rsplit("/", 1)[0] + "/*"} & set(self.parameters["attached"].get(link, [])):
                return link
        return name

    def _way_to_root(self, link):
        """The bodies from that of the link to the first one."""
        body, above = self._bodies[link]
        return [body] if above is None else [body] + self._way_to_root(above)


def rigid_bodies(links):
    """For each link its body, named by the link nearest to the root, and the body above that."""
    bodies = {}
    for link in links:
        if link.parent is None:
            bodies[link.name] = (link.name, None)
        elif link.is_fixed:
            bodies[link.name] = bodies[link.parent]
        else:
            bodies[link.name] = (link.name, bodies[link.parent][0])
    return bodies
