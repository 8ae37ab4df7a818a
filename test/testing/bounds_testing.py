# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the node: waiting, recorded topics, small robots, poses, joints and tf."""
import itertools
import math
import threading
import time

import roslib.packages
import rospy
import told_failures  # noqa: F401
from geometry_msgs.msg import TransformStamped
from link_bounds.msg import AxisAlignedBoxArray
from patience import PATIENCE
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_msgs.msg import Header
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

DEADLINE = 60.0 * PATIENCE  # wall seconds; what never comes fails then


def wait_for(condition, what, deadline=DEADLINE):
    """Returns the first true value of condition(); fails the test after the deadline."""
    end = time.monotonic() + deadline
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError("deadline of %g s passed, still not true: %s" % (deadline, what))
        time.sleep(0.005)  # polls a condition


class Recorder:
    """Keeps every message of a topic."""

    def __init__(self, topic, message_type=AxisAlignedBoxArray):
        self._lock = threading.Lock()
        self._messages = []
        self._newest = None
        self.topic = topic
        self.subscriber = rospy.Subscriber(
            topic, message_type, self._add, queue_size=10000, tcp_nodelay=True)

    def _add(self, message):
        with self._lock:
            self._messages.append(message)
            self._newest = message

    @property
    def messages(self):
        with self._lock:
            return list(self._messages)

    def clear(self):
        """To be called before what causes the next message; else that message may be lost."""
        with self._lock:
            self._messages = []

    def wait(self, condition, what, deadline=DEADLINE):
        """The first message since clear() that satisfies the condition; it may be there already."""
        return wait_for(
            lambda: next((m for m in self.messages if condition(m)), None),
            "%s on %s" % (what, self.topic), deadline)

    def wait_newest(self, condition, what):
        """Waits until the newest message, also one from before clear(), satisfies the condition."""
        def newest():
            with self._lock:
                message = self._newest
            return message if message is not None and condition(message) else None
        return wait_for(newest, "%s on %s" % (what, self.topic))


def latched(topic, message_type=AxisAlignedBoxArray):
    """What the node sends to a new subscriber. There must be no Recorder of the topic, with which
    rospy would share the connection."""
    return rospy.wait_for_message(topic, message_type, DEADLINE)


def box_of(message, name):
    """The box of that name, or None."""
    return next((box for box in message.boxes if box.name == name), None)


def corners_of(box):
    return [box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z]


def at(seconds):
    """A stamp; fractions are rounded to nanoseconds."""
    return rospy.Time.from_sec(seconds)


def transform(parent, child, stamp, xyz=(0, 0, 0), xyzw=(0, 0, 0, 1)):
    result = TransformStamped()
    result.header.frame_id = parent
    result.header.stamp = stamp
    result.child_frame_id = child
    t, q = result.transform.translation, result.transform.rotation
    t.x, t.y, t.z = xyz
    q.x, q.y, q.z, q.w = xyzw
    return result


class TfSender:
    """Publishes /tf or /tf_static and has at least one listener before it sends."""

    def __init__(self, is_static=False, namespace=""):
        self._publisher = rospy.Publisher(
            namespace + ("/tf_static" if is_static else "/tf"), TFMessage, queue_size=10000,
            latch=is_static, tcp_nodelay=True)

    def listeners(self):
        return self._publisher.get_num_connections()

    def wait_for_listener(self):
        wait_for(lambda: self.listeners() > 0, "somebody listens to tf")

    def send(self, *transforms):
        self.publish(TFMessage(list(transforms)))

    def publish(self, message):
        self._publisher.publish(message)

    def end(self):
        """Lets the next sender of this process register again, maybe with another master."""
        self._publisher.unregister()


def names_of(message):
    return [box.name for box in message.boxes]


def union(boxes):
    """The six coordinates around boxes that are given by six coordinates."""
    lows, highs = [box[:3] for box in boxes], [box[3:] for box in boxes]
    return [min(values) for values in zip(*lows)] + [max(values) for values in zip(*highs)]


def difference(box, other):
    """The largest difference of two lists of coordinates [m]."""
    return max(abs(a - b) for a, b in zip(box, other))


def turn(axis, degrees):
    """The quaternion x, y, z, w of a rotation."""
    half = math.radians(degrees) / 2
    length = math.sqrt(sum(a * a for a in axis))
    return tuple(math.sin(half) * a / length for a in axis) + (math.cos(half),)


class Pose:
    """A rotation followed by a translation: base_from_hand = base_from_arm * arm_from_hand."""

    def __init__(self, xyz=(0, 0, 0), xyzw=(0, 0, 0, 1)):
        self.xyz, self.xyzw = tuple(xyz), tuple(xyzw)

    def rotated(self, p):
        x, y, z, w = self.xyzw
        u = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])]
        return [p[0] + w * u[0] + y * u[2] - z * u[1],
                p[1] + w * u[1] + z * u[0] - x * u[2],
                p[2] + w * u[2] + x * u[1] - y * u[0]]

    def moved(self, p):
        return [a + b for a, b in zip(self.rotated(p), self.xyz)]

    def __mul__(self, other):
        a, b, c, d = self.xyzw
        x, y, z, w = other.xyzw
        return Pose(self.moved(other.xyz), (d * x + a * w + b * z - c * y,
                                            d * y - a * z + b * w + c * x,
                                            d * z + a * y - b * x + c * w,
                                            d * w - a * x - b * y - c * z))

    def inverse(self):
        x, y, z, w = self.xyzw
        back = Pose(xyzw=(-x, -y, -z, w))
        return Pose([-c for c in back.rotated(self.xyz)], back.xyzw)

    def bounds(self, points):
        """The six coordinates around moved points."""
        moved = [self.moved(p) for p in points]
        return union([p + p for p in moved])

    def box_bounds(self, size):
        """The same for the corners of a box around the origin: exact."""
        return self.bounds(itertools.product(*((-s / 2, s / 2) for s in size)))


def visual(geometry, xyz=(0, 0, 0), rpy=(0, 0, 0)):
    """A <visual>; %r keeps every digit."""
    return '<visual><origin xyz="%r %r %r" rpy="%r %r %r"/><geometry>%s</geometry></visual>' % (
        *xyz, *rpy, geometry)


def box_link(name, size, xyz=(0, 0, 0)):
    return '<link name="%s">%s</link>' % (name, visual('<box size="%r %r %r"/>' % size, xyz))


def robot(links, joints):
    """A description; joints are (parent, child) and their poses come from tf alone."""
    return '<robot name="test">%s%s</robot>' % ("".join(links), "".join(
        '<joint name="to_%s" type="floating"><parent link="%s"/><child link="%s"/></joint>' % (
            child, parent, child) for parent, child in joints))


def load(node, description=None, timeout=0.0, **parameters):
    """Replaces all parameters of the node, the description if given, and reloads."""
    if rospy.has_param(node):
        rospy.delete_param(node)
    for name, value in parameters.items():
        rospy.set_param(node + "/" + name, value)
    rospy.set_param(node + "/timeout", timeout)
    if description is not None:
        rospy.set_param(rospy.names.namespace(node) + "robot_description", description)
    rospy.wait_for_service(node + "/reload", DEADLINE)
    answer = rospy.ServiceProxy(node + "/reload", Trigger)()
    if not answer.success:
        raise AssertionError("reload failed: " + answer.message)


def executable(package, name):
    """The path of a program."""
    return roslib.packages.find_node(package, name)[0]


class JointSender:
    """Publishes joint states for a robot_state_publisher."""

    def __init__(self, topic="/joint_states"):
        self._publisher = rospy.Publisher(topic, JointState, queue_size=1)

    def move(self, joints, boxes):
        """The first message of the Recorder with everything at these joint positions."""
        start = rospy.Time.now()

        def arrived():
            self._publisher.publish(JointState(
                header=Header(stamp=rospy.Time.now()), name=list(joints),
                position=list(joints.values())))
            return next((m for m in boxes.messages
                         if m.header.stamp >= start and not m.incomplete), None)
        return wait_for(arrived, "%s shows new joint positions" % boxes.topic)


class NodeLog:
    """The lines of a node on /rosout, in order."""

    def __init__(self, node):
        self._node = node
        self._recorder = Recorder("/rosout", Log)
        self._faults = itertools.count()

    @property
    def messages(self):
        return [m for m in self._recorder.messages if m.name == self._node]

    def wait(self, condition, what):
        """The first of the messages that satisfies the condition."""
        return self._recorder.wait(lambda m: m.name == self._node and condition(m), what)

    def lines(self, level, begin, end):
        """The lines of a level among messages[begin:end], but of a master that a busy machine holds
        up."""
        return [m.msg for m in self.messages[begin:end]
                if m.level == level and "lost the ROS master" not in m.msg]

    def connect(self):
        """Reloads until a line arrives; rospy does not say when /rosout is connected."""
        def has_arrived():
            load(self._node)
            return self.messages
        wait_for(has_arrived, "%s says something" % self._node)

    def settle(self):
        """Reloads with a new fault; returns the index of its line. It comes after all earlier lines
        and before all other lines of this reload."""
        fault = "no_such_parameter_%d" % next(self._faults)
        load(self._node, **{fault: 1})
        return wait_for(lambda: [i for i, m in enumerate(self.messages) if fault in m.msg],
                        "%s warns about %s" % (self._node, fault))[0]
