# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""For tests of cloud_filter: clouds and its status."""
import struct

from sensor_msgs.msg import PointCloud2, PointField


def cloud(stamp, points, times=()):
    """Points x, y, z in the frame sensor, each with its time [ns] after the stamp if there are any.
    """
    step = 16 if times else 12
    message = PointCloud2(height=1, width=len(points), point_step=step, row_step=step * len(points))
    message.header.stamp, message.header.frame_id = stamp, "sensor"
    message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
    if times:
        message.fields.append(PointField("t", 12, PointField.UINT32, 1))
    ends = [struct.pack("<I", time) for time in times] or [b""] * len(points)
    message.data = b"".join(struct.pack("<fff", *point) + end for point, end in zip(points, ends))
    return message


def wait_status(diagnostics, node, condition, is_new=True):
    """The values of the first status of that cloud_filter that fulfils the condition."""
    def found(message):
        return [{value.key: value.value for value in status.values} for status in message.status
                if status.name == node + ": cloud filter" and condition(status)]
    if is_new:
        diagnostics.clear()
    return found(diagnostics.wait(found, "a status of " + node))[-1]
