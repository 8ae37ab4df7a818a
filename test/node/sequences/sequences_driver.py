# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does the same steps with a node and an oracle, and judges each message of the node.

After each step comes a fence: something sent on the same topic that the node must show. When it is
shown, the node has handled all that was sent before it, and each message of the node belongs to one
of the states since the last step."""
import time

import rospy
import sequences_judge as judge
from bounds_testing import transform, wait_for
from object_testing import Pose, marker
from sequences_inbox import Inbox, center_x
from sequences_path import Path
from sequences_tf import SECOND, to_time
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

DOUBT_AFTER_JUMP = 0.6  # wall s; the node drops stamps from before a jump for 0.5 s
FENCE_MESH = "zz_fence.stl"


class Driver:
    """Needs a running node that has the model and the time of the oracle."""

    def __init__(self, node, oracle, meshes, diagnostics, publish_time):
        self._node, self._oracle, self._meshes = node, oracle, meshes
        self._diagnostics, self._publish_time = diagnostics, publish_time
        self._inbox = Inbox(node)
        self._senders = {
            topic: rospy.Publisher(topic, kind, queue_size=1000, tcp_nodelay=True)
            for topic, kind in (("/tf", TFMessage), ("/tf_static", TFMessage),
                                (node + "/objects", MarkerArray), (node + "/object", Marker))}
        self._fences = 0
        self._judged = {}  # by topic: the last ~boxes for which a message came
        self._fence_stamp = 0
        self._path = Path(oracle.state())

    def connect(self):
        """To be called first: waits until all topics are connected and no message is on its way."""
        wait_for(lambda: self._inbox.is_connected() and all(
            sender.get_num_connections() for sender in self._senders.values()), "connections")
        self._inbox.wait(lambda m: m["boxes"] and m["groups"] and m["overlaps"], "a welcome")
        self._fence_objects("/objects")
        self._inbox.wait_for_silence()
        self._inbox.take()
        self._path = Path(self._path.states[-1])
        self._fence_objects("/objects")
        self._judge()

    def close(self):
        self._inbox.close()
        for sender in self._senders.values():
            sender.unregister()

    def do(self, kind, *data):
        getattr(self, "_" + kind)(*data)
        self._judge()

    # Steps

    def _tf(self, transforms, is_static):
        topic = "/tf_static" if is_static else "/tf"
        self._senders[topic].publish(TFMessage(transforms))
        self._oracle.on_transforms(transforms, is_static)
        self._arrive()
        self._fence_tf(topic, is_static)

    def _objects(self, markers, topic):
        uris = [m.mesh_resource for m in markers if m.type == Marker.MESH_RESOURCE]
        if uris:
            return self._mesh_objects(markers)
        self._send_markers(markers, topic)
        self._fence_objects(topic)

    def _clock_forward(self, now):
        """The end of a fence's lifetime shows that a timer of the node has seen the new time."""
        self._fences += 1
        fence = self._fence_marker("fence/1")
        fence.lifetime = rospy.Duration(0, min(now - self._oracle.now, SECOND))
        self._send_markers([fence], "/objects")
        self._wait_for_box("fence/1")
        self._publish_time(now)
        self._oracle.on_time(now)
        self._arrive()
        self._inbox.wait(
            lambda m: m["boxes"] and center_x(m["boxes"][-1], "fence/1") is None, "time %d" % now)

    def _clock_back(self, now):
        """Waits until the node no longer drops transforms whose stamps are from before the jump."""
        start = time.monotonic()
        self._publish_time(now)
        self._oracle.on_jump_back(now)
        self._fence_stamp = 0
        self._arrive()
        self._diagnostics.wait_for_new(lambda stamp, _: stamp == to_time(now), "the jump")
        wait_for(lambda: time.monotonic() - start > DOUBT_AFTER_JUMP, "end of doubt")
        self._clock_forward(now + 10 ** 6)

    def _reload(self, model, description, files, keeps_time):
        """Without a model the reload must fail."""
        for name, points in files.items():
            self._meshes.write(name, points, keeps_time)
        model = model and model(self._meshes)
        self._set_parameters(description)
        answer = rospy.ServiceProxy(self._node + "/reload", Trigger)()
        if answer.success != bool(model):
            raise AssertionError("~reload answers %s" % answer)
        if model:
            self._oracle.on_reload(model, files)
            self._arrive()
            self._reread_meshes()
        self._fence_objects("/objects")

    def _set_parameters(self, description):
        text, parameters = description
        for name, value in ((self._node, parameters), ("/robot_description", text)):
            if rospy.has_param(name):
                rospy.delete_param(name)
            if value or value == "":
                rospy.set_param(name, value)

    # Meshes

    def _mesh_objects(self, markers):
        """Sends all in one message, so that the mesh of the fence is read last."""
        fence = self._mesh_fence()
        self._send_markers(markers + [fence], "/objects", is_must=False)
        for uri in self._uris(markers) + [fence.mesh_resource]:
            self._oracle.objects.on_mesh(uri, self._meshes.of_uri(uri))
            self._arrive(is_must=False)
        self._wait_for_box("zz/0")
        self._send_markers([self._deletion(fence)], "/objects")
        self._fence_objects("/objects")

    def _reread_meshes(self):
        """A reload reads the meshes one by one; the fence's marker may come meanwhile."""
        first = len(self._path.states) - 1
        for uri in self._oracle.objects.meshes():
            self._oracle.objects.on_mesh(uri, self._meshes.of_uri(uri))
            self._arrive(is_must=False)
        for state in self._path.states[first:]:
            self._path.arrive(state.with_incomplete("zz/0"), is_must=False)
        fence = self._mesh_fence()
        self._send_markers([fence], "/objects", is_must=False)
        self._oracle.objects.on_mesh(fence.mesh_resource, self._meshes.of_uri(FENCE_MESH))
        self._arrive(is_must=False)
        self._wait_for_box("zz/0")
        self._send_markers([self._deletion(fence)], "/objects")

    @staticmethod
    def _uris(markers):
        return [m.mesh_resource for m in markers if m.type == Marker.MESH_RESOURCE]

    def _mesh_fence(self):
        """The last of all objects; each time another name of the same file."""
        self._fences += 1
        name = "/./" * (self._fences % 50 + 1) + "/" * (self._fences // 50) + FENCE_MESH
        return marker("zz/0", Marker.MESH_RESOURCE, pose=Pose((1000 + self._fences, 0, 0)),
                      frame=self._oracle.model.fixed_frame,
                      mesh_resource="file://" + self._meshes.folder + name)

    @staticmethod
    def _deletion(of):
        return Marker(ns=of.ns, id=of.id, action=Marker.DELETE)

    # Fences

    def _fence_tf(self, topic, is_static):
        self._fences += 1
        self._fence_stamp = max(self._fence_stamp + 1, self._oracle.now)
        link = "still_fence" if is_static else "fence"
        fence = transform(self._oracle.model.fixed_frame, link, to_time(self._fence_stamp),
                          (1000 + self._fences, 0, 0))
        self._senders[topic].publish(TFMessage([fence]))
        self._oracle.on_transforms([fence], is_static)
        self._arrive()
        self._wait_for_box(link)

    def _fence_objects(self, topic):
        self._fences += 1
        self._send_markers([self._fence_marker("fence/0")], topic)
        self._wait_for_box("fence/0")

    def _fence_marker(self, name):
        return marker(name, scale=(0.01, 0.01, 0.01), pose=Pose((1000 + self._fences, 0, 0)),
                      frame=self._oracle.model.fixed_frame)

    def _send_markers(self, markers, topic, is_must=True):
        """On ~object each marker is a message."""
        if topic == "/objects":
            self._senders[self._node + topic].publish(MarkerArray(markers))
            self._oracle.on_markers(markers)
            return self._arrive(is_must)
        for one in markers:
            self._senders[self._node + topic].publish(one)
            self._oracle.on_markers([one])
            self._arrive(is_must)

    def _wait_for_box(self, name):
        x = 1000 + self._fences
        self._inbox.wait(
            lambda m: any(abs((center_x(message, name) or 0) - x) < 0.4 for message in m["boxes"]),
            "the fence %s at x %d" % (name, x))

    # Judging

    def _arrive(self, is_must=True):
        self._path.arrive(self._oracle.state(), is_must)

    def _judge(self):
        """~groups has a message for each one on ~boxes; ~overlaps and ~parts for the last one, and for
        others in their order."""
        self._inbox.wait(lambda m: len(m["groups"]) >= len(m["boxes"]), "~groups of ~boxes")
        taken = self._inbox.take()
        states = self._path.match(taken["boxes"])
        for boxes, groups, state in zip(taken["boxes"], taken["groups"], states):
            complain(judge.wrong_groups(groups, boxes, state.model))
        self._judge_derived("overlaps", taken, states, lambda message, boxes, state:
                            judge.wrong_overlaps(message, boxes, state.model))
        self._judge_derived("parts", taken, [
            state if state.model.parameters["parts_per_link"] > 1 else None for state in states],
                            lambda message, boxes, _: judge.wrong_parts(message, boxes))
        self._judge_footprint(taken)
        self._path = Path(self._path.states[-1])

    def _judge_derived(self, topic, taken, states, fault_of):
        """Each message belongs to one of ~boxes, none to an older one than the message before it. The
        first may still belong to the last ~boxes of an earlier step."""
        wanted = [(boxes, state) for boxes, state in zip(taken["boxes"], states) if state]
        if not wanted:
            return
        candidates = self._judged.get(topic, []) + wanted
        is_done = False
        while not is_done:
            for message in taken[topic]:
                faults = [fault_of(message, *pair) for pair in candidates]
                complain(faults[-1] if all(faults) else None)
                candidates = candidates[faults.index(""):]
                is_done = not fault_of(message, *wanted[-1])
            taken[topic] = [] if is_done else self._more(topic)
        self._judged[topic] = wanted[-1:]

    def _more(self, topic):
        """What comes next on the topic; waits for it."""
        more = []

        def take(messages):
            more.extend(messages[topic])
            messages[topic].clear()
            return more
        self._inbox.wait(take, "~%s of the last ~boxes" % topic)
        return more

    def _judge_footprint(self, taken):
        outlines = [g for g in taken["groups"] if judge.footprint(g) is not None]
        while len(taken["footprint"]) < len(outlines):
            taken["footprint"] += self._more("footprint")
        for polygon, groups in zip(taken["footprint"], outlines):
            complain(judge.wrong_footprint(polygon, groups))


def complain(fault):
    if fault:
        raise AssertionError(fault)
