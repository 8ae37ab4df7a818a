// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which frames tf connects, and which edges a pose depends on.
#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

using Names = std::vector<std::string>;

class PathsTest : public testing::Test {
 protected:
  void send(const std::string& parent, const std::string& child, double stamp = 1,
            bool is_static = false) {
    tf_.add({edge(parent, child, stamp, Eigen::Quaterniond::Identity(), {stamp, 0, 0})}, is_static,
            now_);
  }

  bool isConnected(const std::string& source, const std::string& target) {
    FrameTracker tracker(tf_);
    tracker.setTarget(target, 0, now_);
    return tracker.follow(source).pose().problem == TransformProblem::kNone;
  }

  /// Those of the edges whose news reaches the pose of the source in the target.
  Names edgesBetween(const std::string& source, const std::string& target,
                     const std::vector<std::pair<std::string, std::string>>& edges) {
    FrameTracker tracker(tf_);
    tracker.setTarget(target, 0, now_);
    const FrameTracker::Handle handle = tracker.follow(source);
    Names result;
    for (const auto& [parent, child] : edges) {
      tracker.updateAll(now_);
      send(parent, child, 0, true);
      send(parent, child, 1 + ++stamp_, true);
      tracker.update(now_);
      if (handle.pose().is_changed) result.push_back(child);
    }
    return result;
  }

  TransformBuffer tf_;
  ros::Time now_{100};
  int stamp_ = 0;
};

TEST_F(PathsTest, RunThroughTheLowestCommonAncestor) {
  const std::vector<std::pair<std::string, std::string>> edges{
      {"map", "odom"}, {"odom", "base"}, {"base", "left"}, {"base", "right"}};
  for (const auto& [parent, child] : edges)
    send(parent, child, 1, true);
  EXPECT_EQ(edgesBetween("left", "right", edges), (Names{"left", "right"}));
  EXPECT_EQ(edgesBetween("left", "map", edges), (Names{"odom", "base", "left"}));
  EXPECT_EQ(edgesBetween("odom", "left", edges), (Names{"base", "left"}));
  EXPECT_EQ(edgesBetween("left", "left", edges), Names{});
}

TEST_F(PathsTest, SeparateTreesHaveNone) {
  send("a", "b");
  send("c", "d");
  EXPECT_FALSE(isConnected("b", "d"));
  EXPECT_FALSE(isConnected("b", "never_received"));
}

TEST_F(PathsTest, LoopsEnd) {
  send("a", "b");
  send("b", "a");
  send("x", "y");
  EXPECT_FALSE(isConnected("a", "y"));
}

// As in tf2, which climbs from the source until it meets the target.
TEST_F(PathsTest, AWayUpMayMeetTheTargetButNotALoop) {
  send("a", "b");
  send("b", "a");
  send("a", "x");
  send("a", "y");
  EXPECT_TRUE(isConnected("x", "b"));
  EXPECT_TRUE(isConnected("x", "a"));
  EXPECT_TRUE(isConnected("b", "a"));
  EXPECT_FALSE(isConnected("a", "x"));
  EXPECT_FALSE(isConnected("b", "x"));
  EXPECT_FALSE(isConnected("y", "x"));
  send("base", "z");
  EXPECT_FALSE(isConnected("z", "x"));
  EXPECT_FALSE(isConnected("x", "z"));
}

TEST_F(PathsTest, TheNewestParentCounts) {
  send("old", "child", 10);
  send("new", "child", 20);
  send("old", "child", 15);
  EXPECT_TRUE(isConnected("child", "new"));
  EXPECT_FALSE(isConnected("child", "old"));
}

TEST_F(PathsTest, ClearingKeepsStaticEdges) {
  send("map", "base", 0, true);
  send("base", "arm", 5);
  tf_.clear();
  EXPECT_TRUE(isConnected("base", "map"));
  EXPECT_FALSE(isConnected("arm", "map"));
  send("base", "arm", 1);
  EXPECT_TRUE(isConnected("arm", "map"));
}

}  // namespace
}  // namespace link_bounds
