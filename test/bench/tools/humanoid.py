# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A humanoid of 29 joints from public robots: the arms are those of a Panda, the legs those of a
UR5e, between them a waist of three joints; and rows of its joint values."""
import copy
import math
import random
import xml.etree.ElementTree as ElementTree

from robots import public

BODY = """<robot name="humanoid">
<link name="pelvis"><collision><geometry><box size="0.25 0.36 0.16"/></geometry></collision></link>
<link name="waist1"/><link name="waist2"/>
<link name="torso"><collision><origin xyz="0 0 0.25"/>
  <geometry><box size="0.22 0.4 0.5"/></geometry></collision>
  <collision><origin xyz="0 0 0.65"/><geometry><sphere radius="0.12"/></geometry></collision></link>
%s</robot>"""
JOINT = """<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>
  <origin xyz="%s" rpy="%s"/><axis xyz="%s"/>
  <limit lower="-0.5" upper="0.5" effort="1" velocity="1"/></joint>
"""


def limb(robot, prefix):
    """The links and joints of a robot, without fingers and without the coarse shapes beside its
    meshes."""
    root = ElementTree.parse(public(robot)[robot]).getroot()
    for element in root:
        name = element.get("name", "")
        if element.tag not in ("link", "joint") or "finger" in name or "_sc" in name:
            continue
        element = copy.deepcopy(element)
        element.set("name", prefix + name)
        for end in ("parent", "child"):
            if element.find(end) is not None:
                element.find(end).set("link", prefix + element.find(end).get("link"))
        yield element


def humanoid():
    """The text of a URDF."""
    joints = JOINT % ("waist_yaw", "revolute", "pelvis", "waist1", "0 0 0.15", "0 0 0", "0 0 1")
    joints += JOINT % ("waist_roll", "revolute", "waist1", "waist2", "0 0 0", "0 0 0", "1 0 0")
    joints += JOINT % ("waist_pitch", "revolute", "waist2", "torso", "0 0 0", "0 0 0", "0 1 0")
    for side, sign in (("left", 1), ("right", -1)):
        joints += JOINT % (side + "_arm", "fixed", "torso", side + "_arm_panda_link0",
                           "0 %g 0.42" % (0.3 * sign), "%g 0 0" % (-1.57 * sign), "0 0 1")
        joints += JOINT % (side + "_leg", "fixed", "pelvis", side + "_leg_base_link",
                           "0 %g -0.2" % (0.22 * sign), "3.1416 0 0", "0 0 1")
    root = ElementTree.fromstring(BODY % joints)
    for side in ("left", "right"):
        root.extend(limb("panda", side + "_arm_"))
        root.extend(limb("ur5e", side + "_leg_"))
    return ElementTree.tostring(root, encoding="unicode")


def arm():
    """The text of a URDF: one arm alone."""
    root = ElementTree.fromstring('<robot name="panda"/>')
    root.extend(limb("panda", ""))
    return ElementTree.tostring(root, encoding="unicode")


def joints_of(urdf):
    """The name and the limits of each joint that can be set."""
    for joint in ElementTree.fromstring(urdf).findall("joint"):
        if joint.get("type") == "fixed" or joint.find("mimic") is not None:
            continue
        lower, upper = -math.pi, math.pi
        if joint.get("type") != "continuous":
            lower, upper = (float(joint.find("limit").get(end)) for end in ("lower", "upper"))
        yield joint.get("name"), lower, upper


def rows(urdf, count, step):
    """A csv table: each joint swings around the middle of its range, by at most `step` a row."""
    joints = list(joints_of(urdf))
    chance = random.Random(1)
    phases = [(chance.uniform(0, 6.28), chance.uniform(0.3, 1)) for _ in joints]
    lines = [",".join(name for name, _, _ in joints)]
    for row in range(count):
        values = []
        for (_, lower, upper), (phase, speed) in zip(joints, phases):
            middle, swing = (lower + upper) / 2, min(0.45 * (upper - lower), 0.8)
            values.append("%.6f" % (middle + swing * math.sin(phase + speed * step * row / swing)))
        lines.append(",".join(values))
    return "\n".join(lines) + "\n"
