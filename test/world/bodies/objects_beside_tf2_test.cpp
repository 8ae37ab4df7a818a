// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects that follow their frame, or wait for the transform at their stamp, are where tf2 puts
// them.
#include <iostream>

#include "testing/beside_tf2.h"
#include "testing/live_objects_testing.h"

namespace link_bounds {
namespace {

constexpr int kHistories = 60;
constexpr int kMessages = 150;
constexpr int kObjects = 8;
constexpr double kSameBox = 1e-9;  // m; poses are a few hundred metres away

class ObjectsBesideTf2 {
 public:
  explicit ObjectsBesideTf2(std::uint64_t seed)
      : random_tf_(seed, seed % 3 == 0 ? Oddity::kLoops : Oddity::kNone), random_(seed) {
    fixed_frame_ = random_tf_.pick(random_tf_.frames());
    frames_.setTarget(frameName(fixed_frame_), 0, now_);
    objects_.adopt(now_);
  }

  void step() {
    const RandomMessage message = random_tf_.next();
    for (const auto& transform : message.transforms)
      newest_ = std::max(newest_, transform.header.stamp.toSec());
    both_.add(message);
    frames_.update(now_);
    objects_.update(now_);
    for (int i = 0; i < kObjects; ++i)
      expectSame(i);
    if (pick(3) == 0) put(pick(kObjects));
    if (pick(20) == 0) remove(pick(kObjects));
  }

  long following() const { return following_; }
  long placed() const { return placed_; }
  long placed_after_waiting() const { return placed_after_waiting_; }

 private:
  /// What an object should be.
  struct Expected {
    bool is_there = false;
    std::string frame;
    ros::Time stamp;
    std::optional<geometry_msgs::TransformStamped> placement;
  };

  static ObjectKey key(int i) { return {"scene", i}; }
  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  void put(int i) {
    int frame = pick(random_tf_.frames());
    if (frame == fixed_frame_) return;
    const double stamp = pick(2) == 0 ? 0 : newest_ + random_.uniform(-1, 0.3);
    expected_[i] = {true, frameName(frame), ros::Time(stamp), std::nullopt};
    objects_.put(key(i), boxIn(frameName(frame), stamp), now_);
    // As its content has it, whose stamp was rounded.
    expected_[i].stamp.fromNSec(
        static_cast<std::uint64_t>(objects_.objects().at(key(i)).content->stamp));
    expectSame(i);
  }

  void remove(int i) {
    EXPECT_EQ(objects_.remove(key(i)), expected_[i].is_there);
    expected_[i].is_there = false;
  }

  void expectSame(int i) {
    Expected& expected = expected_[i];
    if (!expected.is_there) return;
    SCOPED_TRACE(frameName(fixed_frame_) + " from " + expected.frame);
    const LiveObject& object = objects_.objects().at(key(i));
    if (expected.stamp.isZero()) {
      const auto transform = lookUp(expected);
      expectBox(object, transform, TransformProblem::kNoTransform);
      following_ += transform.has_value();
    } else {
      const bool is_waiting = object.problem == TransformProblem::kWaiting;
      if (!expected.placement) {
        expected.placement = lookUp(expected);
        placed_ += expected.placement.has_value();
        placed_after_waiting_ += expected.placement && has_waited_[i];
        has_waited_[i] = !expected.placement;
      }
      EXPECT_EQ(is_waiting, !expected.placement);
      if (expected.placement)
        expectBox(object, expected.placement, TransformProblem::kNone);
      else
        EXPECT_TRUE(object.state.incomplete);
    }
  }

  std::optional<geometry_msgs::TransformStamped> lookUp(const Expected& expected) const {
    return both_.lookUp(frameName(fixed_frame_), expected.frame, expected.stamp);
  }

  static void expectBox(const LiveObject& object,
                        const std::optional<geometry_msgs::TransformStamped>& transform,
                        TransformProblem problem_without) {
    EXPECT_EQ(object.problem, transform ? TransformProblem::kNone : problem_without);
    ASSERT_EQ(object.state.box.has_value(), transform.has_value());
    if (!transform) return;
    const auto expected = linkBox(object.content->bounded, Eigen::Affine3d(toIsometry(*transform)));
    EXPECT_LT((object.state.box->min() - expected->min()).norm(), kSameBox);
    EXPECT_LT((object.state.box->max() - expected->max()).norm(), kSameBox);
    EXPECT_EQ(object.state.stamp, static_cast<std::int64_t>(transform->header.stamp.toNSec()));
  }

  RandomTf random_tf_;
  brute_force::Random random_;
  BesideTf2 both_;
  FrameTracker frames_{both_.ours};
  LiveObjects objects_{frames_};
  const ros::Time now_{1};
  int fixed_frame_ = 0;
  double newest_ = 1;
  Expected expected_[kObjects];
  bool has_waited_[kObjects] = {};
  long following_ = 0;
  long placed_ = 0;
  long placed_after_waiting_ = 0;
};

TEST(ObjectsBesideTf2, AreWhereTf2PutsThem) {
  long following = 0, placed = 0, waited = 0;
  for (std::uint64_t seed = 1; seed <= kHistories && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    ObjectsBesideTf2 both(seed);
    for (int i = 0; i < kMessages && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE(i);
      both.step();
    }
    following += both.following();
    placed += both.placed();
    waited += both.placed_after_waiting();
  }
  std::cout << following << " poses followed; " << placed << " objects were placed, " << waited
            << " of them after waiting\n";
  EXPECT_GT(following, 10 * kHistories);
  EXPECT_GT(placed, 5 * kHistories);
  EXPECT_GT(waited, kHistories);
}

}  // namespace
}  // namespace link_bounds
