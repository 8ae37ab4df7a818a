// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses composed once per message are those that tf2 looks up one by one.
#include "node/tf/pose_tree.h"

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <set>

#include "node/tf/followed_frame.h"
#include "testing/random_tf.h"

namespace link_bounds {
namespace {

constexpr double kSame = 1e-12;  // of 1 m or the distance, and of the entries of a rotation
constexpr int kHistories = 250;
constexpr int kMessages = 120;
constexpr int kFollowed = 6;

using Expected = geometry_msgs::TransformStamped;

/// The target if it is above the source at that time, else the nearest frame above both, which may
/// be the source.
std::string meetingPoint(const tf2::BufferCore& buffer, const std::string& target,
                         const std::string& source, ros::Time time) {
  std::set<std::string> way{source};
  std::string frame = source;
  while (frame != target && buffer._getParent(frame, time, frame))
    way.insert(frame);
  frame = target;
  while (way.count(frame) == 0 && buffer._getParent(frame, time, frame)) {
  }
  return frame;
}

Tf2Pose poseOf(const Expected& transform) {
  return TransformView(transform).parent_from_child;
}

/// As tf2 would look it up if nothing were above the nearest frame above both.
Expected lookUp(const tf2::BufferCore& buffer, const std::string& target,
                const std::string& source) {
  Expected result = buffer.lookupTransform(target, source, ros::Time(0));
  const ros::Time time = result.header.stamp;
  const std::string top = meetingPoint(buffer, target, source, time);
  if (top == target || top == source) return result;
  const Tf2Pose pose = inverse(poseOf(buffer.lookupTransform(top, target, time))) *
                       poseOf(buffer.lookupTransform(top, source, time));
  std::memcpy(static_cast<void*>(&result.transform), pose.numbers.data(), sizeof(pose.numbers));
  return result;
}

/// A fixed frame with frames that are followed in it, as those of links and as those of objects,
/// beside tf2.
class FollowedBesideTf2 {
 public:
  FollowedBesideTf2(int fixed_frame, RandomTf& random, TransformSource& tf)
      : fixed_frame_(fixed_frame), target_{tf.tree().frame(frameName(fixed_frame)), 0} {
    std::vector<FrameTree::Frame> frames;
    for (int i = 0; i < kFollowed; ++i) {
      followed_.push_back(i == 0   ? fixed_frame
                          : i == 1 ? random.depth()
                                   : random.pick(random.frames()));
      frames.push_back(tf.tree().frame(frameName(followed_.back())));
      objects_.emplace_back(frames.back());
      objects_.back().refresh(target_, tf, ros::Time(1));
    }
    poses_.follow(target_.fixed_frame, frames);
    poses_.updateAll(tf);
  }

  /// Returns how many of the frames have a pose.
  int expectSame(const TransformSource& tf, const tf2::BufferCore& buffer) {
    poses_.update(tf);
    int known = 0;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
      objects_[i].update(target_, tf, ros::Time(1), true);
      known += expectSame(i, buffer);
    }
    return known;
  }

 private:
  bool expectSame(std::size_t i, const tf2::BufferCore& buffer) {
    const std::string target = frameName(fixed_frame_), source = frameName(followed_[i]);
    SCOPED_TRACE(target + " from " + source);
    const PoseTree::Node* node = poses_.node(i);
    const bool is_known = node && node->has_pose;
    const FollowedFrame& object = objects_[i];
    EXPECT_EQ(object.trouble() == FollowedFrame::Trouble::kNone, is_known);
    try {
      const Expected expected = lookUp(buffer, target, source);
      EXPECT_TRUE(is_known);
      if (is_known) {
        SCOPED_TRACE("as a link");
        expectSame(node->stamp, node->fixed_from_frame.affine, expected);
        SCOPED_TRACE("as an object's frame");
        expectSame(object.pose().stamp, object.pose().world_from_link, expected);
      }
    } catch (const tf2::TransformException& error) {
      // Of a frame in itself nothing has to be known.
      EXPECT_FALSE(is_known && followed_[i] != fixed_frame_) << error.what();
      return false;
    }
    return is_known;
  }

  static void expectSame(std::int64_t stamp, const Eigen::Affine3d& pose,
                         const Expected& expected) {
    const auto& q = expected.transform.rotation;
    const auto& t = expected.transform.translation;
    const Eigen::Vector3d translation(t.x, t.y, t.z);
    EXPECT_EQ(stamp, static_cast<std::int64_t>(expected.header.stamp.toNSec()));
    EXPECT_LT((pose.translation() - translation).norm(), kSame * std::max(1.0, translation.norm()));
    EXPECT_LT(
        (pose.linear() - Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix())
            .norm(),
        kSame);
  }

  int fixed_frame_;
  FollowedFrame::Target target_;
  std::vector<int> followed_;
  PoseTree poses_;
  std::vector<FollowedFrame> objects_;
};

/// Returns how many poses were known.
int compareHistory(std::uint64_t seed, Oddity oddity) {
  RandomTf random(seed, oddity);
  TransformSource tf;
  tf2::BufferCore buffer;
  std::vector<FollowedBesideTf2> fixed_frames;
  for (const int frame : {0, random.depth() / 2, random.depth(), random.frames() - 1})
    fixed_frames.emplace_back(frame, random, tf);
  int known = 0;
  for (int i = 0; i < kMessages && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const RandomMessage message = random.next();
    for (const auto& transform : message.transforms)
      buffer.setTransform(transform, "test", message.is_static);
    tf.add({message.transforms.begin(), message.transforms.end()}, message.is_static, ros::Time(1));
    for (FollowedBesideTf2& followed : fixed_frames)
      known += followed.expectSame(tf, buffer);
  }
  return known;
}

/// Returns the share of poses that were known.
double compareHistories(int histories, Oddity oddity) {
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  double known = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(histories); ++seed) {
    SCOPED_TRACE(seed);
    known += compareHistory(seed, oddity);
    if (testing::Test::HasFailure()) break;
  }
  const double all = 1.0 * histories * kMessages * kFollowed * 4;
  std::cout << known << " of " << all << " poses were known\n";
  return known / all;
}

// Several publishers with different clocks, static and dynamic, repeated and late stamps, new
// parents, gaps, fixed frames above, below and beside, up to a hundred frames deep.
TEST(PoseTree, PosesAndStampsAreThoseOfTf2) {
  EXPECT_GT(compareHistories(kHistories, Oddity::kNone), 0.25);
}

TEST(PoseTree, WhatALoopCutsOffIsWhatTf2Refuses) {
  EXPECT_GT(compareHistories(kHistories / 2, Oddity::kLoops), 0.25);
}

// tf2 would scale by what is above both frames, too.
TEST(PoseTree, UnevenQuaternionsCountAsInTf2FromTheNearestFrameAboveBoth) {
  EXPECT_GT(compareHistories(kHistories, Oddity::kUneven), 0.25);
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

TEST(PoseTree, AnUnevenQuaternionAboveBothScalesInTf2Alone) {
  TransformSource tf;
  tf2::BufferCore buffer;
  PoseTree poses;
  poses.follow(tf.tree().frame("left"), {tf.tree().frame("right")});
  const Eigen::Quaterniond even = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond uneven(1.0045, 0, 0, 0);
  for (const auto& transform :
       {edge("map", "base", 1, uneven, {1, 2, 3}), edge("base", "left", 1, even, {10, 0, 0}),
        edge("base", "right", 1, even, {-10, 0, 0})}) {
    buffer.setTransform(transform, "test");
    tf.add({transform}, false, ros::Time(1));
  }
  poses.update(tf);
  EXPECT_EQ(poses.node(0)->fixed_from_frame.affine.translation(), Eigen::Vector3d(-20, 0, 0));
  const double theirs =
      buffer.lookupTransform("left", "right", ros::Time(0)).transform.translation.x;
  EXPECT_NEAR(theirs, -20 * std::pow(1.0045, 4), kSame * 20);
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
