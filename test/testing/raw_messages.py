# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages as the bytes that are sent."""
import io


def serialized(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def as_bytes(message, data):
    """A message of that type that is sent as these bytes."""
    class Raw(type(message)):
        __slots__ = ()

        def serialize(self, buff):
            buff.write(data)
    return Raw()
