// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links are one body, which bodies are neighbours, and how pairs of names are written.
#include "link_bounds/robot/urdf/overlap_filter.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

/// A chain of links called a, b, c and so on, none of which has geometry, joined by `types`.
Robot chain(const std::vector<std::string>& types) {
  std::string urdf = "<robot name=\"chain\"><link name=\"a\"/>";
  char parent = 'a';
  for (const std::string& type : types) {
    const char child = static_cast<char>(parent + 1);
    urdf += std::string("<link name=\"") + child + "\"/><joint name=\"to_" + child + "\" type=\"" +
            type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
            "\"/><axis xyz=\"0 0 1\"/><limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"
            "</joint>";
    parent = child;
  }
  return parseRobot(urdf + "</robot>");
}

/// All pairs of joined links, such as "ab".
std::string joined(const Robot& robot) {
  const RigidBodies bodies = rigidBodies(robot);
  std::string result;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    for (std::size_t j = i + 1; j < robot.links.size(); ++j) {
      EXPECT_EQ(areJoined(bodies, i, j), areJoined(bodies, j, i));
      if (areJoined(bodies, i, j)) result += robot.links[i].name + robot.links[j].name + " ";
    }
  }
  return result;
}

TEST(RigidBodies, NeighboursAreJoined) {
  EXPECT_EQ(joined(chain({"revolute", "continuous", "prismatic"})), "ab bc cd ");
}

TEST(RigidBodies, FixedJointsMakeOneBody) {
  EXPECT_EQ(joined(chain({"fixed", "fixed", "revolute", "fixed"})),
            "ab ac ad ae bc bd be cd ce de ");
}

TEST(RigidBodies, AcrossABodyLinksAreFree) {
  EXPECT_EQ(joined(chain({"revolute", "fixed", "revolute"})), "ab ac bc bd cd ");
}

TEST(RigidBodies, FloatingAndPlanarJointsMove) {
  EXPECT_EQ(joined(chain({"floating", "planar", "fixed"})), "ab bc bd cd ");
}

TEST(RigidBodies, SiblingsAreFree) {
  const Robot robot = parseRobot(R"(<robot name="y"><link name="b"/><link name="c"/><link name="a"/>
    <joint name="1" type="continuous"><parent link="a"/><child link="b"/></joint>
    <joint name="2" type="continuous"><parent link="a"/><child link="c"/></joint></robot>)");
  EXPECT_EQ(joined(robot), "ba ca ");
}

bool isAnyName(const std::string&) {
  return true;
}

bool isNoName(const std::string&) {
  return false;
}

using Pairs = std::vector<NamePair>;

TEST(NamePairsOf, TwoWordsAreTwoNamesWhetherKnownOrNot) {
  EXPECT_EQ(namePairs("a b", isNoName), Pairs({{"a", "b"}}));
  EXPECT_EQ(namePairs("  a \t b ", isNoName), Pairs({{"a", "b"}}));
  EXPECT_EQ(namePairs("arm/1 /2", isNoName), Pairs({{"arm/1", "/2"}}));
}

TEST(NamePairsOf, LessThanTwoWordsAreNoPair) {
  for (const char* text : {"", " ", "a", " a "})
    EXPECT_EQ(namePairs(text, isAnyName), Pairs()) << text;
}

TEST(NamePairsOf, NamesMayHaveSpacesInThem) {
  const auto is_name = [](const std::string& name) {
    return name == "left  hand" || name == "box";
  };
  EXPECT_EQ(namePairs("left  hand box", is_name), Pairs({{"left  hand", "box"}}));
  EXPECT_EQ(namePairs("box left  hand", is_name), Pairs({{"box", "left  hand"}}));
  EXPECT_EQ(namePairs("left hand box", is_name), Pairs());
  EXPECT_EQ(namePairs("a b c", isAnyName), Pairs({{"a", "b c"}, {"a b", "c"}}));
}

TEST(NamePairs, ContainsThemInEitherOrder) {
  const NamePairs pairs({{"b", "a"}, {"c", "d"}, {"a", "x"}});
  EXPECT_TRUE(pairs.contains("a", "b"));
  EXPECT_TRUE(pairs.contains("b", "a"));
  EXPECT_TRUE(pairs.contains("d", "c"));
  EXPECT_FALSE(pairs.contains("a", "c"));
  EXPECT_FALSE(pairs.contains("a", "a"));
  EXPECT_FALSE(pairs.contains("x", "y"));
  EXPECT_FALSE(NamePairs().contains("a", "b"));
}

}  // namespace
}  // namespace link_bounds
