# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computes what README.md and doc/scene.md say the node publishes after events. Times in ns."""
from sequences_objects import Objects
from sequences_state import Entry, State, bounds_of
from sequences_tf import SECOND, TfOracle


class Oracle:
    """Gets the events that the node gets; state() is what the node must then publish."""

    def __init__(self, model, now):
        self.now = now
        self.model = model
        self.tf = TfOracle()
        self.objects = Objects(self)

    def on_transforms(self, transforms, is_static):
        self.tf.add(transforms, is_static, self.now)
        self.objects.settle()

    def on_markers(self, markers):
        for marker in markers:
            self.objects.take(marker)

    def on_time(self, now):
        self.now = now
        self.objects.expire()

    def on_jump_back(self, now):
        past, self.now = self.now, now
        self.tf.clear()
        self.objects.on_jump_back(past)

    def on_reload(self, model, files):
        """After `files` were replaced."""
        old, self.model = self.model, model
        self.tf.distrust_stamps_ahead(self.now)
        self.objects.on_reload(old, files)

    def is_stale(self, frame):
        heard = self.tf.oldest_receipt(self.model.fixed_frame, frame)
        return (self.model.timeout > 0 and heard is not None and
                heard < self.now - round(self.model.timeout * SECOND))

    def pose(self, frame):
        """The pose of a frame in the fixed frame; None if there is none or it is stale."""
        if self.is_stale(frame):
            return None
        return self.tf.latest(self.model.fixed_frame, frame)

    def state(self):
        return State(self.model, [self._link_entry(link) for link in self.model.links] +
                     self.objects.entries())

    def _link_entry(self, link):
        if not link.shapes:
            return Entry(link.name)
        pose = self.pose(link.frame)
        bounds = bounds_of(link.shapes, pose, link.padding)
        if bounds is None:
            return Entry(link.name)
        return Entry(link.name, link.is_complete, bounds, pose, pose.stamp)
