#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""What README.md, doc and link_bounds.launch name of a robot is there in the demo's robot: snippets
work beside the demo as they are."""
import pathlib
import re
import subprocess
import unittest
from xml.etree import ElementTree

import rosgraph
import rospkg
import rospy
import rostest
import yaml
from bounds_testing import DEADLINE, Recorder, box_of, load
from node_testing import NODE

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("link_bounds"))
PAGES = [PACKAGE / "README.md"] + sorted((PACKAGE / "doc").glob("*.md"))
PUBLICATION = re.compile(r"^rostopic pub [^'\n]*/object [^'\n]*'[^']*'$", re.MULTILINE)
FOOTPRINT = re.compile(r"rosparam set /move_base/footprint_topic [^`\n]*")
OBJECT = re.compile(r"ns: (\w+), id: (\d+)")
FRAME = re.compile(r"{frame_id: (\w+)}|rviz .*-f (\w+)")
GROUPS = re.compile(r'groups(?:: |" value=")(\{.+?\})')
EXAMPLE = re.compile(r"such as (\[.*?\]|\{.*?\})")


def found(expression, paths=PAGES):
    """Every match in some files."""
    return [match for path in paths for match in expression.findall(path.read_text("utf-8"))]


def names_in(value):
    """The links of an example, which may be a list, a map, or pairs."""
    if isinstance(value, dict):
        lists = [v for v in value.values() if isinstance(v, list)]
        return names_in(sum(lists, []) or list(value))
    return [name for entry in value for name in entry.split() if "/" not in name]


class DemoSnippets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        urdf = ElementTree.parse(str(PACKAGE / "launch/demo/demo.urdf"))
        cls.links = {link.get("name") for link in urdf.getroot().findall("link")}
        cls.boxes = Recorder(NODE + "/boxes")
        cls.groups = Recorder(NODE + "/groups")

    def test_frames_are_links(self):
        frames = ["".join(names) for names in found(FRAME)]
        self.assertGreater(len(frames), 2)
        self.assertEqual(set(frames) - self.links, set())

    def test_examples_of_the_launch_file_are_links(self):
        examples = found(EXAMPLE, [PACKAGE / "launch/link_bounds.launch"])
        self.assertGreater(len(examples), 4)
        names = [name for example in examples for name in names_in(yaml.safe_load(example))]
        self.assertEqual(set(names) - self.links, set())

    def test_each_published_object_gets_its_box(self):
        commands = found(PUBLICATION)
        self.assertGreater(len(commands), 2)
        for command in commands:
            subprocess.run(["bash", "-c", command], check=True, timeout=3 * DEADLINE,
                           stdout=subprocess.DEVNULL)
            name = "%s/%s" % OBJECT.search(command).groups()
            self.boxes.wait(lambda m, n=name: box_of(m, n) and n not in m.incomplete, name)

    def test_footprint_for_both_costmaps(self):
        (command,) = found(FOOTPRINT)
        subprocess.run(["bash", "-c", command], check=True, timeout=3 * DEADLINE)
        master = rosgraph.Master(rospy.get_name())
        topics = {topic for topic, kind in master.getTopicTypes() if kind == "geometry_msgs/Polygon"}
        for costmap in ("local_costmap", "global_costmap"):
            # As costmap_2d does.
            caller = rosgraph.Master("/move_base/" + costmap)
            self.assertIn(rospy.get_param(caller.searchParam("footprint_topic")), topics)

    def test_groups_are_complete(self):
        examples = found(GROUPS)
        self.assertGreater(len(examples), 2)
        for example in examples:
            self.groups.clear()
            groups = yaml.safe_load(example)
            load(NODE, groups=groups)
            self.groups.wait(lambda m, names=groups: not m.incomplete and
                             all(box_of(m, name) for name in names), example)


if __name__ == "__main__":
    rospy.init_node("demo_snippets_test")
    rostest.rosrun("link_bounds", "demo_snippets", DemoSnippets)
