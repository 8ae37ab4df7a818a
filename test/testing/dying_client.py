# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A client of ~get_boxes, or of another service, that is gone before the answer comes."""
import socket
import struct

import rosgraph
from bounds_testing import DEADLINE
from link_bounds.srv import GetBoxes
from raw_messages import serialized


def sent(request):
    data = serialized(request)
    return struct.pack("<I", len(data)) + data


class DyingClient:
    """Sends a request and is gone before the answer comes."""

    def __init__(self, service, request, kind=GetBoxes):
        uri = rosgraph.Master("/dying").lookupService(service)
        host, port = rosgraph.network.parse_http_host_and_port(uri.replace("rosrpc", "http"))
        header = {"callerid": "/dying", "service": service, "md5sum": kind._md5sum}
        with socket.create_connection((host, port), DEADLINE) as connection:
            connection.sendall(rosgraph.network.encode_ros_handshake_header(header))
            connection.sendall(sent(request))
