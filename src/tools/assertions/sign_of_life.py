# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the publisher of a topic still lives: silence is no success."""
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock

MAX_AGE = 1.0  # s, the default
STATUS_PERIOD = 1.0  # wall s between two statuses of a link_bounds_publisher in /diagnostics
STATUS_NAME = ': boxes'  # end of the name of its status, after the name of the node
PUBLICATIONS = 'publications'  # the number of ~boxes since the start, a key of its status
DISTANCE_LAG = 'distances behind boxes [s]'  # a key of its status


def publisher_of(message):
    """The name of the node that sent the message; '' if it is unknown."""
    return (getattr(message, '_connection_header', None) or {}).get('callerid', '')


def number_of(status, key):
    """The number under `key` in a status; 0 if there is no such key."""
    return next((float(entry.value) for entry in status.values if entry.key == key), 0.0)


class SignOfLife:
    """How long the last message of a topic counts. Times are seconds of a steady clock.

    A message counts for max_age, by the clock of the wall and by that of ROS. A node whose robot
    stands still sends no boxes, but a status in /diagnostics each second of wall time, on the
    thread that makes the boxes. The status confirms the last message. It counts until max_age after
    the next status was due, by the clock of the wall alone. So does the first message of a node,
    whose first status may come a second later. With lag_key, a status does not count if its number
    under that key, by which messages are behind, is above max_age. Without lag_key, a status does
    not count if the node has published ~boxes since the first status after the last message:
    that message no longer holds.
    """

    def __init__(self, max_age, lag_key=None, topic=''):
        self._max_age = max_age
        self._lag_key = lag_key
        self._topic = topic  # its full name
        self._names = set()  # of the statuses that the publisher of the topic has sent
        self._strangers = set()  # nodes of its statuses, while none was of the topic's node
        self._publications = None  # in the first status since the last message
        self._has_missed = False  # a status did not count, because ~boxes were published since
        self._lag = 0.0  # s, max of the lags that were too long; 0 if none was
        self._ros_time = 0.0  # s, of the last /clock; 0 if there was none
        self._publisher = None  # of the last message
        self._message = None  # when the last message came, by both clocks
        self._status_until = 0.0  # when the last status ceases to count
        self._last_sign = 0.0  # when the last message or the last status that counts came
        self._silence = 0.0  # s, the longest silence that was too long; 0 if none was

    def is_of_node(self):
        """Whether the publisher is a link_bounds node, or a player of one: its status has come.
        Other publishers may not number all messages: rospy does not if it sends the latched one
        again."""
        return bool(self._names)

    def topics(self, topic_type, is_time_simulated):
        """The topics that it listens to."""
        clock = [topic_type('/clock', Clock, self.see_clock, is_needed=False)]
        return [topic_type('/diagnostics', DiagnosticArray, self.see_status, is_needed=False)] + (
            clock if is_time_simulated else [])

    def see(self, message, now):
        """Takes a message of the topic."""
        is_first = publisher_of(message) != self._publisher
        if is_first:
            self._names = set()
        self._publisher = publisher_of(message)
        self._message = now, self._ros_time
        self._publications = None
        self._see_sign(now, is_status=is_first)

    def see_status(self, message, now):
        if publisher_of(message) != self._publisher:
            return
        of_nodes = [status for status in message.status if status.name.endswith(STATUS_NAME)]
        self._names.update(status.name for status in of_nodes)
        for status in of_nodes:
            if self._is_of_topic(status.name):
                if self._lag_key:
                    self._see_lag(number_of(status, self._lag_key), now)
                else:
                    self._see_publications(number_of(status, PUBLICATIONS), now)

    def see_clock(self, message, _now):
        self._ros_time = message.clock.to_sec()

    def silent_since(self, now):
        """When the last sign of life ceased to count; None while it counts or before the first."""
        if self._message is None or now <= self._status_until:
            return None
        if max(now - self._message[0], self._ros_time - self._message[1]) <= self._max_age:
            return None
        self._silence = max(self._silence, now - self._last_sign)
        return min(now, max(self._status_until, self._message[0] + self._max_age))

    def told(self):
        """For the report of a failure: the longest silence, if one was too long."""
        if not self._silence:
            return []
        lines = [f'for {self._silence:.3g} s no message came, and no status of '
                 f'{self._publisher or "its publisher"} in /diagnostics: silence is no success '
                 f'(max_age {self._max_age:.3g} s)']
        if self._lag:
            lines.append(f'its status said that they were {self._lag:.3g} s behind')
        if self._strangers:
            lines.append(f'{self._publisher} sent statuses of {", ".join(sorted(self._strangers))}, '
                         f'which tell nothing of {self._topic}')
        if self._has_missed:
            lines.append('its status said that it published ~boxes meanwhile')
        return lines

    def _is_of_topic(self, name):
        """Whether a status is of the topic's node: a player, or a manager of nodelets, may send the
        statuses of several nodes."""
        fitting = [known for known in self._names
                   if self._topic.startswith('/' + known[:-len(STATUS_NAME)] + '/')]
        is_its = name == max(fitting, key=len, default=self._publisher[1:] + STATUS_NAME)
        if not fitting and not is_its:
            self._strangers.add(name[:-len(STATUS_NAME)])
        return is_its

    def _see_publications(self, count, now):
        if self._publications is None:
            self._publications = count
        if count > self._publications:
            self._has_missed = True
        else:
            self._see_sign(now, is_status=True)

    def _see_lag(self, lag, now):
        if lag > self._max_age:
            self._lag = max(self._lag, lag)
        else:
            self._see_sign(now, is_status=True)

    def _see_sign(self, now, is_status):
        self._last_sign = now
        if is_status:
            self._status_until = now + STATUS_PERIOD + self._max_age
