// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses composed once per message are those that tf2 looks up one by one.
#include "world/tf/frame_tracker.h"

#include <cmath>
#include <iostream>
#include <memory>

#include "testing/beside_tf2.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr int kTrackedHistories = repetitions(250);
constexpr int kTrackedMessages = 120;
constexpr std::size_t kFollowed = 6;
constexpr std::size_t kKept = 3;

/// A fixed frame beside tf2. Some frames are followed all the time, as those of links; others come
/// and go, as those of objects.
class TrackerBesideTf2 {
 public:
  TrackerBesideTf2(int fixed_frame, RandomTf& random, BesideTf2& both)
      : both_(both), tracker_(both.ours), fixed_frame_(frameName(fixed_frame)) {
    tracker_.setTarget(fixed_frame_, 0, ros::Time(1));
    for (std::size_t i = 0; i < kFollowed; ++i) {
      follow(i, i == 0 ? fixed_frame : i == 1 ? random.depth() : random.pick(random.frames()));
    }
  }

  /// Returns how many of the frames have a pose.
  int expectSame() {
    tracker_.update(ros::Time(1));
    int known = 0;
    for (std::size_t i = 0; i < kFollowed; ++i)
      known += expectSame(i);
    return known;
  }

  /// Another frame takes the place of one that is not kept; its pose must be there at once.
  void exchange(int frame) {
    last_ = kKept + (last_ + 1) % (kFollowed - kKept);
    follow(last_, frame);
    expectSame(last_);
  }

 private:
  void follow(std::size_t i, int frame) {
    names_[i] = frameName(frame);
    handles_[i] = tracker_.follow(names_[i]);
  }

  bool expectSame(std::size_t i) {
    SCOPED_TRACE(fixed_frame_ + " from " + names_[i]);
    const FramePose& pose = handles_[i].pose();
    const bool is_known = pose.problem == TransformProblem::kNone;
    const auto expected = both_.lookUp(fixed_frame_, names_[i], ros::Time(0));
    // Of a frame in itself nothing has to be known.
    EXPECT_TRUE(is_known == expected.has_value() || (is_known && names_[i] == fixed_frame_));
    if (!is_known || !expected) return false;
    EXPECT_EQ(pose.stamp, static_cast<std::int64_t>(expected->header.stamp.toNSec()));
    link_bounds::expectSame(pose.fixed_from_frame.affine, *expected);
    return true;
  }

  BesideTf2& both_;
  FrameTracker tracker_;
  std::string fixed_frame_;
  std::string names_[kFollowed];
  FrameTracker::Handle handles_[kFollowed];
  std::size_t last_ = 0;
};

/// Returns how many poses were known.
int compareHistory(std::uint64_t seed, Oddity oddity) {
  RandomTf random(seed, oddity);
  brute_force::Random others(seed);
  BesideTf2 both;
  std::vector<std::unique_ptr<TrackerBesideTf2>> trackers;
  for (const int frame : {0, random.depth() / 2, random.depth(), random.frames() - 1})
    trackers.push_back(std::make_unique<TrackerBesideTf2>(frame, random, both));
  int known = 0;
  for (int i = 0; i < kTrackedMessages && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    both.add(random.next());
    for (const auto& tracker : trackers) {
      known += tracker->expectSame();
      const double other = others.uniform(0, 3);
      if (other < 1) tracker->exchange(static_cast<int>(other * random.frames()));
    }
  }
  return known;
}

/// Returns the share of poses that were known.
double compareHistories(int histories, Oddity oddity) {
  double known = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(histories); ++seed) {
    SCOPED_TRACE(seed);
    known += compareHistory(seed, oddity);
    if (testing::Test::HasFailure()) break;
  }
  const double all = 4.0 * histories * kTrackedMessages * kFollowed;
  std::cout << known << " of " << all << " poses were known\n";
  return known / all;
}

// Several publishers with different clocks, static and dynamic, repeated and late stamps, new
// parents, gaps, fixed frames above, below and beside, up to a hundred frames deep.
TEST(FrameTracker, PosesAndStampsAreThoseOfTf2) {
  EXPECT_GT(compareHistories(kTrackedHistories, Oddity::kNone), 0.25);
}

TEST(FrameTracker, WhatALoopCutsOffIsWhatTf2Refuses) {
  EXPECT_GT(compareHistories(kTrackedHistories / 2, Oddity::kLoops), 0.25);
}

// tf2 would scale by what is above both frames, too.
TEST(FrameTracker, UnevenQuaternionsCountAsInTf2FromTheNearestFrameAboveBoth) {
  EXPECT_GT(compareHistories(kTrackedHistories, Oddity::kUneven), 0.25);
}

// A quaternion that is not quite of length 1, as tf2 takes it, scales what it turns.
TEST(FrameTracker, UnevenQuaternionsCountAsInTf2) {
  TransformBuffer tf;
  tf2::BufferCore buffer;
  FrameTracker poses(tf);
  poses.setTarget("map", 0, ros::Time(1));
  const FrameTracker::Handle c = poses.follow("c");
  for (const auto& [parent, child] : {std::pair("map", "a"), {"a", "b"}, {"b", "c"}}) {
    auto transform = edge(parent, child, 1, Eigen::Quaterniond(0.8, 0.6, 0.05, 0), {1, 2, 3});
    buffer.setTransform(transform, "test");
    tf.add({transform}, false, ros::Time(1));
  }
  poses.update(ros::Time(1));
  const auto expected = buffer.lookupTransform("map", "c", ros::Time(0)).transform.translation;
  EXPECT_LT((c.pose().fixed_from_frame.affine.translation() -
             Eigen::Vector3d(expected.x, expected.y, expected.z))
                .norm(),
            kSame);
}

TEST(FrameTracker, AnUnevenQuaternionAboveBothScalesInTf2Alone) {
  TransformBuffer tf;
  tf2::BufferCore buffer;
  FrameTracker poses(tf);
  poses.setTarget("left", 0, ros::Time(1));
  const FrameTracker::Handle right = poses.follow("right");
  const Eigen::Quaterniond even = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond uneven(1.0045, 0, 0, 0);
  for (const auto& transform :
       {edge("map", "base", 1, uneven, {1, 2, 3}), edge("base", "left", 1, even, {10, 0, 0}),
        edge("base", "right", 1, even, {-10, 0, 0})}) {
    buffer.setTransform(transform, "test");
    tf.add({transform}, false, ros::Time(1));
  }
  poses.update(ros::Time(1));
  EXPECT_EQ(right.pose().fixed_from_frame.affine.translation(), Eigen::Vector3d(-20, 0, 0));
  const double theirs =
      buffer.lookupTransform("left", "right", ros::Time(0)).transform.translation.x;
  EXPECT_NEAR(theirs, -20 * std::pow(1.0045, 4), kSame * 20);
}

const Eigen::Quaterniond kBaseTurn(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()));

/// Two arms on a base that moves, in a fixed frame above it.
class ArmsTest : public testing::Test {
 protected:
  ArmsTest() {
    poses_.setTarget("map", kTimeout, ros::Time(1));
    left_ = poses_.follow("left");
    right_ = poses_.follow("right");
    send({edge("map", "base", 1, kBaseTurn, {1, 0, 0}), left(1, 0.1), right(1, 0.2)});
  }

  static geometry_msgs::TransformStamped left(double stamp, double x) {
    return edge("base", "left", stamp, kBaseTurn, {x, 0, 0});
  }

  static geometry_msgs::TransformStamped right(double stamp, double x) {
    return edge("base", "right", stamp, kBaseTurn, {x, 0, 0});
  }

  void send(const std::vector<geometry_msgs::TransformStamped>& transforms) {
    tf_.add({transforms.begin(), transforms.end()}, false, transforms.back().header.stamp);
    poses_.update(transforms.back().header.stamp);
  }

  static constexpr double kTimeout = 10;

  TransformBuffer tf_;
  FrameTracker poses_{tf_};
  FrameTracker::Handle left_, right_;
};

TEST_F(ArmsTest, WhatStandsStillHasAnotherStampButDoesNotMove) {
  send({edge("map", "base", 2, kBaseTurn, {1, 0, 0}), left(2, 0.1), right(2, 0.3)});
  EXPECT_TRUE(left_.pose().is_changed);
  EXPECT_FALSE(left_.pose().has_moved);
  EXPECT_EQ(left_.pose().stamp, 2000000000);
  EXPECT_TRUE(right_.pose().has_moved);
}

TEST_F(ArmsTest, EverythingOnABaseMovesWithIt) {
  send({edge("map", "base", 2, kBaseTurn, {1.5, 0, 0}), left(2, 0.1), right(2, 0.2)});
  EXPECT_TRUE(left_.pose().has_moved);
  EXPECT_TRUE(right_.pose().has_moved);
}

TEST_F(ArmsTest, AnArmWhoseBaseIsSilentKeepsItsPose) {
  send({left(2, 0.5)});
  EXPECT_FALSE(left_.pose().is_changed);
  EXPECT_FALSE(right_.pose().is_changed);
  EXPECT_EQ(left_.pose().stamp, 1000000000);
  send({edge("map", "base", 2, kBaseTurn, {1, 0, 0})});
  EXPECT_TRUE(left_.pose().has_moved);
  EXPECT_EQ(left_.pose().stamp, 2000000000);
  EXPECT_EQ(right_.pose().stamp, 1000000000);
}

TEST_F(ArmsTest, TheOldestEdgeDecidesWhatIsStale) {
  const auto expire = [this](double now) { poses_.expire(ros::Time(now)); };
  send({left(5, 0.5)});
  send({edge("map", "base", 9, kBaseTurn, {1, 0, 0})});
  expire(11);
  EXPECT_FALSE(right_.pose().is_changed);
  expire(11.5);
  EXPECT_EQ(right_.pose().problem, TransformProblem::kStale);
  EXPECT_TRUE(right_.pose().is_changed);
  EXPECT_EQ(left_.pose().problem, TransformProblem::kNone);
  expire(15.5);
  EXPECT_FALSE(right_.pose().is_changed) << "it was stale before";
  EXPECT_EQ(left_.pose().problem, TransformProblem::kStale);
  send({edge("map", "base", 16, kBaseTurn, {1, 0, 0}), right(16, 0.2)});
  EXPECT_EQ(right_.pose().problem, TransformProblem::kNone);
}

TEST_F(ArmsTest, WhatIsStaleIsNewsAlsoWhenManyFramesLeave) {
  for (int i = 0; i < 100; ++i)
    poses_.follow("frame_" + std::to_string(i));
  poses_.expire(ros::Time(11.5));
  EXPECT_EQ(left_.pose().problem, TransformProblem::kStale);
  EXPECT_TRUE(left_.pose().is_changed);
}

TEST_F(ArmsTest, AFrameIsFollowedAsLongAsOneOfItsHandlesLives) {
  FrameTracker::Handle second = poses_.follow("left");
  left_ = FrameTracker::Handle();
  EXPECT_FALSE(left_);
  for (int i = 0; i < 100; ++i)
    poses_.follow("frame_" + std::to_string(i));
  send({edge("map", "base", 2, kBaseTurn, {1, 0, 0}), left(2, 0.5), right(2, 0.2)});
  EXPECT_TRUE(second.pose().has_moved);
  FrameTracker::Handle third = std::move(second);
  send({edge("map", "base", 3, kBaseTurn, {1, 0, 0}), left(3, 0.7), right(3, 0.2)});
  EXPECT_EQ(third.pose().stamp, 3000000000);
}

}  // namespace
}  // namespace link_bounds
