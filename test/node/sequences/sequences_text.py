# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Describes a step in a few lines, for the report of a failure."""
from visualization_msgs.msg import Marker

ACTIONS = {Marker.ADD: "ADD", Marker.DELETE: "DELETE", Marker.DELETEALL: "DELETEALL"}
TYPES = {getattr(Marker, name): name for name in (
    "ARROW", "CUBE", "SPHERE", "CYLINDER", "LINE_STRIP", "LINE_LIST", "CUBE_LIST", "SPHERE_LIST",
    "POINTS", "TEXT_VIEW_FACING", "MESH_RESOURCE", "TRIANGLE_LIST")}


def describe(kind, *data):
    return {"tf": describe_tf, "objects": describe_objects, "reload": describe_reload}.get(
        kind, lambda now: "%s to %d ns" % (kind, now))(*data)


def describe_tf(transforms, is_static):
    lines = []
    for sent in transforms:
        t, q = sent.transform.translation, sent.transform.rotation
        lines.append("%s in %r at %d: %r %r" % (
            sent.child_frame_id, sent.header.frame_id, sent.header.stamp.to_nsec(),
            (t.x, t.y, t.z), (q.x, q.y, q.z, q.w)))
    return "\n    ".join(["tf_static" if is_static else "tf", *lines])


def describe_objects(markers, topic):
    lines = []
    for m in markers:
        lines.append("%s %s %s/%d in %r at %d%s for %d ns, %d points %s" % (
            ACTIONS.get(m.action, m.action), TYPES.get(m.type, m.type), m.ns, m.id,
            m.header.frame_id, m.header.stamp.to_nsec(), " locked" if m.frame_locked else "",
            m.lifetime.to_nsec(), len(m.points), m.mesh_resource.rpartition("/")[2]))
    return "\n    ".join(["~" + topic[1:], *lines])


def describe_reload(model, texts, files, keeps_time):
    description, parameters = texts
    return "reload of %s\n    with %s%s" % (
        "a robot of %d characters" % len(description) if model else repr(description), parameters,
        "".join("\n    and %s %s%s" % (name, "broken" if points is None else
                                       "of %d points" % len(points),
                                       ", its time kept" if keeps_time else "")
                for name, points in files.items()))
