// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing disable_collisions.
#include "robot/pairs/srdf.h"

#include <gtest/gtest.h>

#include "testing/refusal.h"

namespace link_bounds {
namespace {

Robot robot() {
  Robot result;
  result.name = "r";
  for (const char* name : {"a", "b", "c & \"d\""})
    result.links.push_back({name, {}, {}});
  return result;
}

/// The error, or "" if there is none.
std::string errorOf(const std::string& text) {
  return refusalOf<SrdfError>([&] { parseSrdf(text, robot(), "r.srdf"); });
}

void expectError(const std::string& text, const std::string& words) {
  EXPECT_NE(errorOf(text).find(words), std::string::npos) << text << "\n" << errorOf(text);
}

TEST(Srdf, ReadsDisabledPairsAndNothingElse) {
  const auto pairs = parseSrdf(
      "<?xml version='1.0'?><robot name='r'><group name='arm'><link name='elsewhere'/></group>"
      "<disable_collisions link1='b' link2='a' reason='Never'/>\n"
      "<disable_collisions link1='a' link2='c &amp; \"d\"'/></robot>",
      robot(), "r.srdf");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].first, "b");
  EXPECT_EQ(pairs[0].second, "a");
  EXPECT_EQ(pairs[0].reason, "Never");
  EXPECT_EQ(pairs[1].second, "c & \"d\"");
  EXPECT_EQ(pairs[1].reason, "");
}

TEST(Srdf, ErrorsNameTheFileTheLineAndTheRemedy) {
  expectError("<robot>\n<disable", "the SRDF \"r.srdf\", line 2: it is not well-formed XML");
  expectError("", "the SRDF \"r.srdf\"");
  expectError("<sdf/>", "the root element is sdf, not <robot>; give a SRDF");
  expectError("<robot>\n\n<disable_collisions link1='a' link2='z'/></robot>",
              "line 3: \"z\" is no link of the robot \"r\"; give the SRDF of this robot");
  expectError("<robot><disable_collisions link1='a'/></robot>",
              "<disable_collisions> has no link2; name a link there");
  expectError("<robot><xacro:include filename='x'/></robot>",
              "it is a xacro file, with an element <xacro:include>; expand it");
}

TEST(Srdf, WhatWouldDisableNothingIsRefused) {
  const std::string good = "<disable_collisions link1='a' link2='b'/>";
  expectError("<robot>\n<disable_collision link1='a' link2='b'/></robot>",
              "line 2: <disable_collision> is no element of a SRDF; write <disable_collisions>");
  expectError("<robot name='r'/>\n<robot>" + good + "</robot>", "line 2: a second root, <robot>");
  expectError("<robot><link name='a'/>\n<link name='b'><visual/></link></robot>",
              "line 2: it is a URDF, with a <link> that has a shape or a parent; give the SRDF");
  expectError("<robot><joint name='j'><parent link='a'/></joint></robot>", "it is a URDF");
  EXPECT_EQ(errorOf("<?xml version='1.0'?><!-- a --><robot><virtual_joint name='v' child_link='a' "
                    "parent_frame='world'/>" +
                    good + "</robot><!-- z -->"),
            "");
}

TEST(Srdf, WhatIsWrittenIsReadBack) {
  const std::string line = toSrdf({DisabledPair{"a", "c & \"d\"", "Always"}, ""});
  EXPECT_EQ(line,
            "<disable_collisions link1=\"a\" link2=\"c &amp; &quot;d&quot;\" reason=\"Always\"/>");
  const auto pairs = parseSrdf("<robot>" + line + "</robot>", robot(), "r.srdf");
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].second, "c & \"d\"");
}

/// Two hyphens are no part of a XML comment.
TEST(Srdf, ACommentStandsBeforeItsElement) {
  EXPECT_EQ(toSrdf({std::nullopt, "a--->b-"}), "<!-- a- - ->b- -->");
  EXPECT_EQ(toSrdf({DisabledPair{"a", "b", ""}, "why"}),
            "<!-- why -->\n<disable_collisions link1=\"a\" link2=\"b\"/>");
}

TEST(Srdf, AMergedOneHasOnlyOtherPairs) {
  const std::string old =
      "<?xml version=\"1.0\"?>\n<!--top-->\n<robot name=\"r\">\n    <group name=\"arm\">\n"
      "        <link name=\"a\"/>\n    </group>\n    <!--pairs-->\n"
      "    <disable_collisions link1=\"b\" link2=\"a\" reason=\"Never\"/>\n"
      "    <virtual_joint name=\"v\" type=\"fixed\"/>\n"
      "    <disable_collisions link1=\"b\" link2=\"b\"/>\n</robot>\n";
  const std::string merged =
      mergedSrdf(old, {{DisabledPair{"a", "c & \"d\"", "Always"}, ""}, {std::nullopt, "open"}});
  EXPECT_EQ(merged,
            "<?xml version=\"1.0\"?>\n<!--top-->\n<robot name=\"r\">\n    <group name=\"arm\">\n"
            "        <link name=\"a\"/>\n    </group>\n    <!--pairs-->\n"
            "    <disable_collisions link1=\"a\" link2=\"c &amp; &quot;d&quot;\" "
            "reason=\"Always\"/>\n    <!-- open -->\n"
            "    <virtual_joint name=\"v\" type=\"fixed\"/>\n</robot>\n");
  const std::string into_empty = mergedSrdf("<robot/>", {{DisabledPair{"a", "b", "Never"}, ""}});
  EXPECT_EQ(parseSrdf(into_empty, robot(), "r.srdf").size(), 1U);
}

/// A link without checks by default has none with any other link, but for pairs that are enabled.
TEST(Srdf, DefaultsOfLinksAreDisabledPairs) {
  for (const char* enabled : {"link1='a' link2='b'", "link1='b' link2='a'"}) {
    const std::string text = std::string("<robot name='r'><enable_collisions ") + enabled +
                             "/><disable_default_collisions link='b'/></robot>";
    const auto pairs = parseSrdf(text, robot(), "r.srdf");
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].first, "b");
    EXPECT_EQ(pairs[0].second, "c & \"d\"");
    EXPECT_EQ(pairs[0].reason, kByDefault);
    EXPECT_EQ(mergedSrdf(text, {}).find("collisions"), std::string::npos);
  }
  expectError("<robot><disable_default_collisions link='z'/></robot>", "\"z\" is no link");
  expectError("<robot><enable_collisions link1='a'/></robot>", "<enable_collisions> has no link2");
}

}  // namespace
}  // namespace link_bounds
