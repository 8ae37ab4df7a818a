# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Subscribers that read from their connection as much as a test wants. No master knows of them."""
import socket
import struct
import threading
import time
import xmlrpc.client

import rosgraph
from bounds_testing import DEADLINE

CALLER = "/raw_subscriber"
RECEIVE_BUFFER = 65536  # bytes of the kernel, so that a stopped subscriber takes little
PAUSE = 0.1  # s, of a slow reader


def publisher_uri(node, topic):
    """(host, port) where the node sends the topic; the topic must be advertised."""
    with xmlrpc.client.ServerProxy(rosgraph.Master(CALLER).lookupNode(node)) as slave:
        code, text, protocol = slave.requestTopic(CALLER, topic, [["TCPROS"]])
    if code != 1:
        raise AssertionError("%s does not send %s: %s" % (node, topic, text))
    return protocol[1], protocol[2]


class RawSubscriber:
    """Connected, and reads nothing unless it is asked to."""

    def __init__(self, node, topic):
        self._socket = socket.socket()
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
        self._socket.settimeout(DEADLINE)
        self._socket.connect(publisher_uri(node, topic))
        fields = {"callerid": CALLER, "topic": topic, "type": "*", "md5sum": "*",
                  "tcp_nodelay": "1"}
        lines = [("%s=%s" % field).encode() for field in fields.items()]
        header = b"".join(struct.pack("<I", len(line)) + line for line in lines)
        self._socket.sendall(struct.pack("<I", len(header)) + header)
        if b"error=" in self.read_message():  # the header of the publisher
            raise AssertionError("%s refuses a subscriber" % topic)

    def read(self, count):
        """That many bytes."""
        result = bytearray(count)
        view = memoryview(result)
        while view:
            got = self._socket.recv_into(view)
            if not got:
                raise EOFError("the node has closed the connection")
            view = view[got:]
        return bytes(result)

    def read_message(self):
        return self.read(struct.unpack("<I", self.read(4))[0])

    def read_some(self, limit):
        """Up to that number of bytes of what is there; fails if nothing comes for DEADLINE."""
        return self._socket.recv(limit)

    def end(self):
        """Also wakes up a thread that reads, which would keep the connection open."""
        try:
            self._socket.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass  # the node has closed it
        self._socket.close()


def stamp_of(message):
    """The stamp of a message that begins with a header: seconds and nanoseconds."""
    return struct.unpack_from("<II", message, 4)


class Reader:
    """Reads whole messages on a thread of its own; keeps the newest, and counts messages and
    bytes."""

    def __init__(self, node, topic):
        self.count, self.bytes, self.newest = 0, 0, None
        self._subscriber = RawSubscriber(node, topic)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        try:
            while True:
                self.newest = self._subscriber.read_message()
                self.bytes += len(self.newest)
                self.count += 1
        except (OSError, EOFError):
            pass  # end(), nothing for DEADLINE, or the end of the node

    def end(self):
        self._subscriber.end()


class SlowReader:
    """Reads from several subscribers, with a limit of bytes per second for each."""

    def __init__(self, subscribers, bytes_per_second):
        self._end = threading.Event()
        self._subscribers, self._portion = subscribers, int(bytes_per_second * PAUSE)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        for subscriber in self._subscribers:
            subscriber._socket.setblocking(False)
        while not self._end.is_set():
            for subscriber in self._subscribers:
                try:
                    subscriber.read_some(self._portion)
                except OSError:
                    pass  # nothing is there
            time.sleep(PAUSE)

    def end(self):
        self._end.set()
        self._thread.join()
