// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses composed once per message are those that tf2 looks up one by one.
#include "pose_tree.h"

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <iostream>

#include "random_tf.h"

namespace link_bounds {
namespace {

constexpr double kSame = 1e-12;  // of 1 m or the distance, and of the entries of a rotation
constexpr int kHistories = 250;
constexpr int kMessages = 120;
constexpr int kFollowed = 6;

/// A fixed frame with frames that are followed in it, beside tf2.
class FollowedBesideTf2 {
 public:
  FollowedBesideTf2(int fixed_frame, RandomTf& random, TransformSource& tf)
      : fixed_frame_(fixed_frame) {
    std::vector<FrameTree::Frame> frames;
    for (int i = 0; i < kFollowed; ++i) {
      followed_.push_back(i == 0   ? fixed_frame
                          : i == 1 ? random.depth()
                                   : random.pick(random.frames()));
      frames.push_back(tf.tree().frame(frameName(followed_.back())));
    }
    poses_.follow(tf.tree().frame(frameName(fixed_frame)), frames);
    poses_.updateAll(tf);
  }

  /// Returns how many of the frames have a pose.
  int expectSame(const TransformSource& tf, const tf2::BufferCore& buffer) {
    poses_.update(tf);
    int known = 0;
    for (std::size_t i = 0; i < followed_.size(); ++i)
      known += expectSame(i, buffer);
    return known;
  }

 private:
  bool expectSame(std::size_t i, const tf2::BufferCore& buffer) {
    const std::string target = frameName(fixed_frame_), source = frameName(followed_[i]);
    const PoseTree::Node* node = poses_.node(i);
    const bool is_known = node && node->has_pose;
    try {
      const auto expected = buffer.lookupTransform(target, source, ros::Time(0));
      EXPECT_TRUE(is_known) << target << " from " << source;
      if (is_known) expectSame(*node, expected);
    } catch (const tf2::TransformException& error) {
      // Of a frame in itself nothing has to be known.
      EXPECT_FALSE(is_known && followed_[i] != fixed_frame_) << error.what();
      return false;
    }
    return is_known;
  }

  static void expectSame(const PoseTree::Node& node,
                         const geometry_msgs::TransformStamped& expected) {
    const auto& q = expected.transform.rotation;
    const auto& t = expected.transform.translation;
    const Eigen::Vector3d translation(t.x, t.y, t.z);
    const Eigen::Affine3d pose = node.fixed_from_frame.affine;
    EXPECT_EQ(node.stamp, static_cast<std::int64_t>(expected.header.stamp.toNSec()));
    EXPECT_LT((pose.translation() - translation).norm(), kSame * std::max(1.0, translation.norm()));
    EXPECT_LT(
        (pose.linear() - Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix())
            .norm(),
        kSame);
  }

  int fixed_frame_;
  std::vector<int> followed_;
  PoseTree poses_;
};

/// Returns how many poses were known.
int compareHistory(std::uint64_t seed) {
  RandomTf random(seed);
  TransformSource tf;
  tf2::BufferCore buffer;
  std::vector<FollowedBesideTf2> fixed_frames;
  for (const int frame : {0, random.depth() / 2, random.depth(), random.frames() - 1})
    fixed_frames.emplace_back(frame, random, tf);
  int known = 0;
  for (int i = 0; i < kMessages && !testing::Test::HasFailure(); ++i) {
    const RandomMessage message = random.next();
    for (const auto& transform : message.transforms)
      buffer.setTransform(transform, "test", message.is_static);
    tf.add({message.transforms.begin(), message.transforms.end()}, message.is_static, ros::Time(1));
    for (FollowedBesideTf2& followed : fixed_frames)
      known += followed.expectSame(tf, buffer);
  }
  return known;
}

// Several publishers with different clocks, static and dynamic, repeated and late stamps, new
// parents, gaps, fixed frames above, below and beside, up to a hundred frames deep.
TEST(PoseTree, PosesAndStampsAreThoseOfTf2) {
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  long known = 0;
  for (std::uint64_t seed = 1; seed <= kHistories && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    known += compareHistory(seed);
  }
  const long all = static_cast<long>(kHistories) * kMessages * kFollowed * 4;
  std::cout << known << " of " << all << " poses were known\n";
  EXPECT_GT(known, all / 4);
}

// A quaternion that is not quite of length 1, as tf2 takes it, scales what it turns.
TEST(PoseTree, UnevenQuaternionsCountAsInTf2) {
  TransformSource tf;
  tf2::BufferCore buffer;
  PoseTree poses;
  poses.follow(tf.tree().frame("map"), {tf.tree().frame("c")});
  for (const auto& [parent, child] : {std::pair("map", "a"), {"a", "b"}, {"b", "c"}}) {
    auto transform = edge(parent, child, 1, Eigen::Quaterniond(0.8, 0.6, 0.05, 0), {1, 2, 3});
    buffer.setTransform(transform, "test");
    tf.add({transform}, false, ros::Time(1));
  }
  poses.update(tf);
  const auto expected = buffer.lookupTransform("map", "c", ros::Time(0)).transform.translation;
  EXPECT_LT((poses.node(0)->fixed_from_frame.affine.translation() -
             Eigen::Vector3d(expected.x, expected.y, expected.z))
                .norm(),
            kSame);
}

const Eigen::Quaterniond kTurn(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()));

/// Two arms on a base that moves, in a fixed frame above it.
class ArmsTest : public testing::Test {
 protected:
  ArmsTest() {
    FrameTree& tree = tf_.tree();
    poses_.follow(tree.frame("map"), {tree.frame("left"), tree.frame("right")});
    send({edge("map", "base", 1, kTurn, {1, 0, 0}), left(1, 0.1), right(1, 0.2)});
  }

  static geometry_msgs::TransformStamped left(double stamp, double x) {
    return edge("base", "left", stamp, kTurn, {x, 0, 0});
  }

  static geometry_msgs::TransformStamped right(double stamp, double x) {
    return edge("base", "right", stamp, kTurn, {x, 0, 0});
  }

  void send(const std::vector<geometry_msgs::TransformStamped>& transforms) {
    tf_.add({transforms.begin(), transforms.end()}, false, transforms.back().header.stamp);
    poses_.update(tf_);
  }

  const PoseTree::Node& pose(std::size_t i) const { return *poses_.node(i); }

  TransformSource tf_;
  PoseTree poses_;
};

TEST_F(ArmsTest, WhatStandsStillHasNewsButDoesNotMove) {
  send({edge("map", "base", 2, kTurn, {1, 0, 0}), left(2, 0.1), right(2, 0.3)});
  EXPECT_TRUE(pose(0).is_news);
  EXPECT_FALSE(pose(0).has_moved);
  EXPECT_EQ(pose(0).stamp, 2000000000);
  EXPECT_TRUE(pose(1).has_moved);
}

TEST_F(ArmsTest, EverythingOnABaseMovesWithIt) {
  send({edge("map", "base", 2, kTurn, {1.5, 0, 0}), left(2, 0.1), right(2, 0.2)});
  EXPECT_TRUE(pose(0).has_moved);
  EXPECT_TRUE(pose(1).has_moved);
}

TEST_F(ArmsTest, OnlyTheArmThatWasHeardHasNews) {
  send({left(2, 0.5)});
  EXPECT_TRUE(pose(0).is_news);
  EXPECT_FALSE(pose(1).is_news);
  EXPECT_EQ(pose(0).stamp, 1000000000);
  EXPECT_FALSE(pose(0).has_moved);
}

TEST_F(ArmsTest, TheOldestEdgeTellsWhenAPathWasHeard) {
  send({left(2, 0.5)});
  EXPECT_EQ(pose(0).heard, 1000000000);
  send({edge("map", "base", 3, kTurn, {1, 0, 0})});
  EXPECT_EQ(pose(0).heard, 2000000000);
  EXPECT_EQ(pose(1).heard, 1000000000);
}

}  // namespace
}  // namespace link_bounds
