# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random steps for Driver.do() as plain data, the same for the same seed. Times in ns."""
import math
import os
import random
from functools import partial

from bounds_testing import transform
from object_testing import Pose, marker
from sequences_model import Model, description
from sequences_objects import COUNTS
from sequences_robot import (MESHES, random_parameters, random_points, random_robot, random_xyz)
from sequences_tf import SECOND, to_time
from visualization_msgs.msg import Marker

START = 1000 * SECOND
LAST_STAMP = (2 ** 32 - 1) * SECOND  # refused; tf2 itself aborts where stamps are far apart
PARENTS = {"base": "odom", "a": "base", "b": "a", "c": "b", "d": "base", "e": "d", "g": "base",
           "cam": "base", "thing": "cam", "part": "thing"}
STATIC = ["d", "cam"]
MOVING = [name for name in PARENTS if name not in STATIC]
FRAMES = ["odom", *PARENTS]
OBJECTS = [("o", 0), ("o", 1), ("p", 0), ("p", 1), ("p", -3), ("link_bounds/q", 0)]


def random_turn(rng):
    """A quaternion x, y, z, w of length 1."""
    if rng.random() < 0.3:
        half = math.sqrt(0.5)
        return rng.choice([(0, 0, 0, 1), (0, 0, 1, 0), (half, 0, 0, half), (0, -half, 0, half)])
    while True:
        q = [rng.uniform(-1, 1) for _ in range(4)]
        length = math.sqrt(sum(c * c for c in q))
        if 0.1 < length < 1:
            return tuple(c / length for c in q)


class Steps:
    """Makes one step after another from a seed."""

    def __init__(self, seed, folder):
        self._rng = random.Random(seed)
        self._folder = folder
        self._now = START
        self._turns = {child: [random_turn(self._rng) for _ in range(3)] for child in PARENTS}
        self._stamps = {child: START for child in PARENTS}  # last ones sent
        self._last_markers = []
        self._last_mesh = None  # the file that a marker has named just now
        self.links = random_robot(self._rng)
        self.parameters = {}
        self.files = {name: random_points(self._rng, name) for name in MESHES[:-1]}
        self.files[MESHES[-1]] = None

    def begin(self):
        """Steps that give all links their poses."""
        yield "tf", [self._transform(child, "usual") for child in STATIC], True
        yield "tf", [self._transform(child, "usual") for child in MOVING], False

    def next(self):
        if self._now > 2 ** 31 * SECOND:
            return self._clock_back()
        if self._last_mesh and self._rng.random() < 0.3:
            return self._reload_with([self._last_mesh])
        kinds = {"usual_tf": 26, "odd_tf": 26, "static_tf": 6, "unusable_pose": 6, "objects": 24,
                 "clock_forward": 11, "clock_back": 1.2, "reload": 4}
        kind = self._rng.choices(list(kinds), list(kinds.values()))[0]
        return getattr(self, "_" + kind)()

    # tf

    def _usual_tf(self):
        children = self._rng.sample(MOVING, self._rng.choice([1, 2, len(MOVING), len(MOVING)]))
        return "tf", [self._transform(child, "usual") for child in children], False

    def _odd_tf(self):
        children = [self._rng.choice(list(PARENTS)) for _ in range(self._rng.choice([1, 1, 2, 5]))]
        return "tf", [self._transform(child, "odd") for child in children], False

    def _static_tf(self):
        children = [self._rng.choice(STATIC + STATIC + list(PARENTS))
                    for _ in range(self._rng.choice([1, 2]))]
        return "tf", [self._transform(child, "odd" if self._rng.random() < 0.2 else "usual")
                      for child in children], True

    def _unusable_pose(self):
        """Only the translation is infinite: the node must keep nothing of the rotation."""
        child = self._rng.choice(["a", "b", "e"])
        sent = self._transform(child, "usual")
        sent.transform.translation.x = math.inf
        return "tf", [sent], False

    def _transform(self, child, how):
        rng = self._rng
        xyz, turn = random_xyz(rng, 2), rng.choice(self._turns[child])
        parent, stamp = PARENTS[child], self._now
        if how == "odd":
            xyz, turn = self._odd_pose(xyz, turn)
            stamp = self._odd_stamp(child)
            parent = rng.choice([parent] * 6 + FRAMES + [""])
        if stamp < LAST_STAMP:
            self._stamps[child] = stamp
        return transform(parent, child, to_time(stamp), xyz, turn)

    def _odd_pose(self, xyz, turn):
        rng = self._rng
        axis = rng.randrange(3)
        fault = rng.choice(["none"] * 8 + ["number", "scaled", "short", "nan", "zero", "far"])
        if fault == "number":
            xyz[axis] = rng.choice([math.nan, math.inf, -math.inf, 1e300])
        elif fault == "far":
            xyz[axis] = rng.choice([1e4, -1e9, 1e30])
        elif fault == "scaled":
            turn = [c * rng.choice([0.997, 1.004]) for c in turn]
        elif fault == "short":
            turn = [c * rng.choice([0.9, 1.01]) for c in turn]
        elif fault == "nan":
            turn = [math.nan, *turn[1:]]
        elif fault == "zero":
            turn = [0, 0, 0, 0]
        return xyz, turn

    def _odd_stamp(self, child):
        rng = self._rng
        last = self._stamps[child]
        stamp = rng.choice([self._now, self._now, self._now + rng.randrange(SECOND // 2), last,
                            last - rng.randrange(5 * SECOND), last - 10 * SECOND,
                            last - 11 * SECOND, self._now - rng.randrange(2 * SECOND)])
        if rng.random() < 0.02:
            stamp = rng.choice([0, self._now + 100 * SECOND, LAST_STAMP])
        return max(stamp, 0)

    # Objects

    def _objects(self):
        rng = self._rng
        markers = [self._marker() for _ in range(rng.choice([1, 1, 2, 6]))]
        meshes = [m for m in markers if m.type == Marker.MESH_RESOURCE]
        if meshes:
            markers = meshes[:1]
        names = [os.path.basename(m.mesh_resource) for m in meshes[:1]]
        self._last_mesh = next((name for name in names if name in self.files), None)
        self._last_markers = markers
        return "objects", markers, rng.choice(["/objects", "/objects", "/object"])

    def _marker(self):
        rng = self._rng
        if self._last_markers and rng.random() < 0.1:
            again = rng.choice(self._last_markers)
            return self._copy(again)
        ns, number = rng.choice(OBJECTS)
        kind = rng.choice(list(range(12)))
        count = {Marker.ARROW: rng.choice([0, 2]), Marker.LINE_STRIP: 3}.get(
            kind, 6 if kind in COUNTS else 0)
        scale = [rng.choice([1, rng.uniform(0, 2)]) for _ in range(3)]
        result = marker("%s/%d" % (ns, number), kind, scale, Pose(random_xyz(rng, 2),
                        random_turn(rng)), self._frame(), [random_xyz(rng) for _ in range(count)])
        if kind == Marker.MESH_RESOURCE:
            result.mesh_resource = "file://%s/%s" % (
                self._folder, rng.choice(MESHES + ["missing.stl"]))
        self._time(result)
        return self._spoilt(result)

    def _frame(self):
        name = self._rng.choice(FRAMES + FRAMES + ["odom", "nowhere"])
        return self._rng.choice(["", "", "", "/"]) + name

    def _time(self, result):
        rng = self._rng
        result.frame_locked = rng.random() < 0.1
        if rng.random() < 0.5:
            offset = rng.choice([0, rng.randrange(-SECOND, SECOND // 2), -9 * SECOND])
            result.header.stamp = to_time(self._now + offset)
        if rng.random() < 0.3:
            result.lifetime = rng.choice([to_time(rng.randrange(2 * SECOND))]) - to_time(0)

    def _spoilt(self, result):
        rng = self._rng
        fault = rng.choice(["none"] * 30 + ["nan", "negative", "count", "action", "type", "frame",
                                            "delete", "delete", "all"])
        if fault == "nan":
            result.pose.position.y = rng.choice([math.nan, math.inf, 1e300])
        elif fault == "negative":
            result.scale.x = -1
        elif fault == "count":
            result.points = result.points[:1]
        elif fault == "action":
            result.action = rng.choice([1, 4, 99, -1])
        elif fault == "type":
            result.type = rng.choice([12, -1])
        elif fault == "frame":
            result.header.frame_id = ""
        elif fault == "delete":
            result.action = Marker.DELETE
        elif fault == "all":
            result.action = Marker.DELETEALL
        return result

    @staticmethod
    def _copy(of):
        copied = Marker(**{name: getattr(of, name) for name in of.__slots__})
        copied.color.r = 1 - copied.color.r
        return copied

    # Time

    def _clock_forward(self):
        rng = self._rng
        span = rng.choice([rng.randrange(1, SECOND // 100), rng.randrange(SECOND // 2),
                           rng.randrange(SECOND // 2), rng.randrange(3 * SECOND)])
        if rng.random() < 0.04:
            span = rng.choice([12 * SECOND, 12 * SECOND, 2 ** 31 * SECOND + 1])
        self._now += span
        return "clock_forward", self._now

    def _clock_back(self):
        """By a bit, or to the start. From a very late time always to the start: tf2 fails there."""
        span = self._rng.choice([SECOND // 5, 3 * SECOND, self._now])
        is_far = self._now > 2 ** 31 * SECOND
        self._now = START if is_far else max(self._now - span, self._now // 2)
        step = "clock_back", self._now
        self._now += 10 ** 6
        return step

    # Reloads

    def _reload(self):
        rng = self._rng
        if rng.random() < 0.25:
            broken = rng.choice([("<robot", {}), ("", {}), (None, {}),
                                 (description(self.links, self._folder), {"padding": -1.0}),
                                 ("<robot name='x'><link name='a'/><link name='b'/></robot>", {})])
            return "reload", None, broken, {}, False
        if rng.random() < 0.7:
            self.parameters = random_parameters(rng)
        if rng.random() < 0.2:
            self.links = random_robot(rng)
        return self._reload_with([rng.choice(MESHES)] if rng.random() < 0.4 else [])

    def _reload_with(self, names):
        """After files were replaced."""
        files = {name: self._other_points(name) for name in names}
        self.files.update(files)
        self._last_mesh = None
        return ("reload", partial(Model, self.links, self.parameters),
                (description(self.links, self._folder), self.parameters), files,
                self._rng.random() < 0.5)

    def _other_points(self, name):
        """Sometimes as many points as before, so that the file keeps its size."""
        rng, before = self._rng, self.files[name]
        if before and rng.random() < 0.6:
            return [[1.5 * c + 0.1 for c in point] for point in before]
        return rng.choice([None, random_points(rng, name), random_points(rng, name)])
