// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths, news and ages of tf edges.
#include "node/tf/frame_tree.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

using Frames = std::vector<FrameTree::Frame>;

class FrameTreeTest : public testing::Test {
 protected:
  void hear(const std::string& parent, const std::string& child, std::int64_t stamp = 1,
            bool is_static = false) {
    tree.heard(tree.frame(child), tree.frame(parent), is_static, stamp, now);
  }
  std::optional<Frames> path(const std::string& from, const std::string& to) {
    return tree.path(tree.frame(from), tree.frame(to));
  }

  FrameTree tree;
  std::int64_t now = 100;
};

TEST_F(FrameTreeTest, PathRunsThroughTheLowestCommonAncestor) {
  hear("map", "odom");
  hear("odom", "base");
  hear("base", "left");
  hear("base", "right");
  EXPECT_EQ(path("left", "right"), (Frames{tree.frame("left"), tree.frame("right")}));
  EXPECT_EQ(path("left", "map"),
            (Frames{tree.frame("left"), tree.frame("base"), tree.frame("odom")}));
  EXPECT_EQ(path("odom", "left"), (Frames{tree.frame("left"), tree.frame("base")}));
  EXPECT_EQ(path("left", "left"), Frames{});
}

TEST_F(FrameTreeTest, SeparateTreesHaveNoPath) {
  hear("a", "b");
  hear("c", "d");
  EXPECT_FALSE(path("b", "d"));
  EXPECT_FALSE(path("b", "never_heard_of"));
}

TEST_F(FrameTreeTest, LoopsEnd) {
  hear("a", "b");
  hear("b", "a");
  hear("x", "y");
  EXPECT_FALSE(path("a", "y"));
}

// As in tf2, which climbs from the source until it meets the target.
TEST_F(FrameTreeTest, AWayUpMayMeetTheTargetButNotALoop) {
  hear("a", "b");
  hear("b", "a");
  hear("a", "x");
  hear("a", "y");
  EXPECT_EQ(path("x", "b"), (Frames{tree.frame("x"), tree.frame("a")}));
  EXPECT_EQ(path("x", "a"), (Frames{tree.frame("x")}));
  EXPECT_EQ(path("b", "a"), (Frames{tree.frame("b")}));
  EXPECT_FALSE(path("a", "x"));
  EXPECT_FALSE(path("b", "x"));
  EXPECT_FALSE(path("y", "x"));
  hear("base", "z");
  EXPECT_FALSE(path("z", "x"));
  EXPECT_FALSE(path("x", "z"));
}

TEST_F(FrameTreeTest, TheNewestParentCounts) {
  hear("old", "child", 10);
  hear("new", "child", 20);
  hear("old", "child", 15);
  EXPECT_TRUE(path("child", "new"));
  EXPECT_FALSE(path("child", "old"));
}

TEST_F(FrameTreeTest, StructureChangesOnlyWithParents) {
  hear("a", "b", 1);
  const auto before = tree.structure();
  hear("a", "b", 2);
  EXPECT_EQ(tree.structure(), before);
  hear("c", "b", 3);
  EXPECT_NE(tree.structure(), before);
}

TEST_F(FrameTreeTest, NewsLastsForOneMessage) {
  tree.beginMessage();
  hear("a", "b");
  EXPECT_TRUE(tree.isNews(tree.frame("b")));
  EXPECT_FALSE(tree.isNews(tree.frame("a")));
  tree.beginMessage();
  EXPECT_FALSE(tree.isNews(tree.frame("b")));
}

TEST_F(FrameTreeTest, ForgettingKeepsStaticEdges) {
  hear("map", "base", 0, true);
  hear("base", "arm", 5);
  tree.forgetDynamic();
  EXPECT_TRUE(path("base", "map"));
  EXPECT_FALSE(path("arm", "map"));
  hear("base", "arm", 1);
  EXPECT_TRUE(path("arm", "map"));
}

TEST_F(FrameTreeTest, TheFirstTransformDecidesWhatIsStatic) {
  hear("a", "b", 0, true);
  hear("a", "b", 5, false);
  EXPECT_TRUE(tree.isStatic(tree.frame("b")));
  hear("a", "c", 5, false);
  hear("a", "c", 0, true);
  EXPECT_FALSE(tree.isStatic(tree.frame("c")));
}

TEST_F(FrameTreeTest, AgesCountFromTheStartOfTheClock) {
  now = 0;
  hear("a", "b");
  tree.clockStarted(500);
  EXPECT_EQ(tree.lastHeard(tree.frame("b")), 500);
}

}  // namespace
}  // namespace link_bounds
