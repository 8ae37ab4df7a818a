// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links are one body, which bodies are neighbours, and how pairs of names are written.
#include "link_bounds/robot/urdf/overlap_filter.h"

#include <gtest/gtest.h>

#include <algorithm>

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
std::string joined(const Robot& robot, int joints = 1) {
  const RigidBodies bodies = rigidBodies(robot);
  std::string result;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    for (std::size_t j = i + 1; j < robot.links.size(); ++j) {
      EXPECT_EQ(areJoined(bodies, i, j, joints), areJoined(bodies, j, i, joints));
      if (areJoined(bodies, i, j, joints))
        result += robot.links[i].name + robot.links[j].name + " ";
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

TEST(RigidBodies, JointsOnTheWayAreCounted) {
  const Robot robot = chain({"revolute", "fixed", "revolute", "revolute"});
  EXPECT_EQ(joined(robot, 0), "bc ");
  EXPECT_EQ(joined(robot, 1), "ab ac bc bd cd de ");
  EXPECT_EQ(joined(robot, 2), "ab ac ad bc bd be cd ce de ");
  EXPECT_EQ(joined(robot, 1000), "ab ac ad ae bc bd be cd ce de ");
}

TEST(RigidBodies, TheWayMayGoUpAndDown) {
  std::string urdf = "<robot name=\"tree\"><link name=\"a\"/>";
  for (const std::string names : {"ab", "bc", "ad", "de", "df"}) {  // parent and child
    urdf += std::string("<link name=\"") + names[1] + "\"/><joint name=\"" + names +
            "\" type=\"continuous\"><parent link=\"" + names[0] + "\"/><child link=\"" + names[1] +
            "\"/></joint>";
  }
  const Robot robot = parseRobot(urdf + "</robot>");
  EXPECT_EQ(joined(robot, 2), "ab ac ad ae af bc bd de df ef ");
  EXPECT_EQ(joined(robot, 3), "ab ac ad ae af bc bd be bf cd de df ef ");
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

TEST(NamePairs, PatternsContainWhatFitsInEitherOrder) {
  const NamePairs pairs({{"right/*/*", "right/*/*"}, {"arm", "held/*"}, {"b", "a"}});
  EXPECT_TRUE(pairs.contains("right/arm/0", "right/hand/1"));
  EXPECT_FALSE(pairs.contains("right/arm/0", "left/hand/1"));
  EXPECT_TRUE(pairs.contains("arm", "held/1"));
  EXPECT_TRUE(pairs.contains("held/-2", "arm"));
  EXPECT_FALSE(pairs.contains("held/1", "held/2"));
  EXPECT_FALSE(pairs.contains("armature", "held/1"));
  EXPECT_TRUE(pairs.contains("a", "b"));
}

TEST(NamePairs, PartnersAreTheOtherEndsOfPairsThatFit) {
  using Names = std::vector<std::string>;
  const NamePairs pairs({{"held/*", "held/*"}, {"arm", "held/*"}, {"b", "a"}});
  EXPECT_EQ(pairs.partnersOf("a"), Names({"b"}));
  EXPECT_EQ(pairs.partnersOf("b"), Names({"a"}));
  EXPECT_EQ(pairs.partnersOf("arm"), Names({"held/*"}));
  Names partners = pairs.partnersOf("held/1");
  std::sort(partners.begin(), partners.end());
  EXPECT_EQ(partners, Names({"arm", "held/*", "held/*"}));
  EXPECT_EQ(pairs.partnersOf("c"), Names());
}

TEST(Pattern, AWildcardStandsForAnyTextWithoutASlash) {
  for (const char* name : {"ns/1", "ns/-12", "ns/"})
    EXPECT_TRUE(fitsPattern(name, "ns/*")) << name;
  for (const char* name : {"ns", "ns/a/1", "other/1", "/ns/1", "ns1", ""})
    EXPECT_FALSE(fitsPattern(name, "ns/*")) << name;
  EXPECT_TRUE(fitsPattern("", "*"));
  EXPECT_TRUE(fitsPattern("arm", "arm"));
  EXPECT_FALSE(fitsPattern("arm", ""));
}

/// What a pattern means, by trying each length of the text that its first wildcard stands for.
bool fitsByTrial(const std::string& name, const std::string& pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*')
    return !name.empty() && name[0] == pattern[0] && fitsByTrial(name.substr(1), pattern.substr(1));
  for (std::size_t n = 0; n <= name.size() && (n == 0 || name[n - 1] != '/'); ++n) {
    if (fitsByTrial(name.substr(n), pattern.substr(1))) return true;
  }
  return false;
}

/// The text of `length` letters whose number is `number`.
std::string textOf(const std::string& letters, std::size_t length, std::size_t number) {
  std::string text;
  for (; length > 0; --length, number /= letters.size())
    text += letters[number % letters.size()];
  return text;
}

TEST(Pattern, AllShortOnesFitWhatTheyStandFor) {
  std::size_t fitting = 0;
  for (std::size_t i = 0; i < 1024; ++i) {  // 4^5 patterns, 3^5 names
    const std::string pattern = textOf("ab/*", i % 6, i);
    for (std::size_t k = 0; k < 243; ++k) {
      const std::string name = textOf("ab/", k % 6, k);
      ASSERT_EQ(fitsPattern(name, pattern), fitsByTrial(name, pattern)) << name << " " << pattern;
      fitting += fitsPattern(name, pattern) ? 1 : 0;
    }
  }
  EXPECT_GT(fitting, 1000u);
}

}  // namespace
}  // namespace link_bounds
