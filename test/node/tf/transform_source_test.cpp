// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses and their times are tf2's; what is refused, and how an edge begins anew.
#include "node/tf/transform_source.h"

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <limits>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

constexpr double kSame = 1e-12;  // m, and of the entries of a rotation
constexpr int kFrames = 12;
constexpr int kMessages = 400;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const Eigen::Quaterniond kNoTurn = Eigen::Quaterniond::Identity();

std::string name(int i) {
  return "frame_" + std::to_string(i);
}

/// The same transforms in tf2 and in ours.
class BesideTf2 {
 public:
  void add(const geometry_msgs::TransformStamped& transform, bool is_static) {
    buffer_.setTransform(transform, "test", is_static);
    ours_.add({transform}, is_static, ros::Time(1));
  }

  void clear() {
    buffer_.clear();
    ours_.clear();
  }

  /// True if both know the pose.
  bool expectSame(const std::string& target, const std::string& source) {
    const std::optional<StampedPose> pose = latest(target, source);
    try {
      const auto expected = buffer_.lookupTransform(target, source, ros::Time(0));
      EXPECT_TRUE(pose) << target << " from " << source;
      if (pose) expectSame(*pose, expected);
      return pose.has_value();
    } catch (const tf2::TransformException& error) {
      EXPECT_FALSE(pose) << error.what();
      return false;
    }
  }

 private:
  std::optional<StampedPose> latest(const std::string& target, const std::string& source) {
    const auto to = ours_.tree().frame(target);
    const auto from = ours_.tree().frame(source);
    const auto path = ours_.tree().path(from, to);
    return path ? ours_.latest(to, from, *path) : std::nullopt;
  }

  static void expectSame(const StampedPose& pose, const geometry_msgs::TransformStamped& expected) {
    const auto& q = expected.transform.rotation;
    const auto& t = expected.transform.translation;
    EXPECT_EQ(pose.stamp, static_cast<std::int64_t>(expected.header.stamp.toNSec()));
    EXPECT_LT((pose.world_from_link.translation() - Eigen::Vector3d(t.x, t.y, t.z)).norm(), kSame);
    EXPECT_LT((pose.world_from_link.linear() -
               Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix())
                  .norm(),
              kSame);
  }

  tf2::BufferCore buffer_;
  TransformSource ours_;
};

/// Every frame hangs on one before it; some change to another, some come late, some are repeated,
/// one is static, one has a static and a dynamic publisher.
class RandomTf {
 public:
  explicit RandomTf(std::uint64_t seed) : random_(seed) {}

  geometry_msgs::TransformStamped next() {
    const int child = 1 + pick(kFrames - 1);
    if (pick(10) > 0) now_ += 0.01 * pick(10);
    const double age = pick(5) == 0 ? 0.1 * pick(120) : 0.0;
    const int parent = isSteady(child) ? child / 2 : pick(child);
    const Eigen::Vector3d axis(random_.uniform(-1, 1), random_.uniform(-1, 1), 1.5);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(random_.uniform(-3, 3), axis.normalized()));
    const Eigen::Vector3d place(random_.uniform(-2, 2), random_.uniform(-2, 2), 0.3);
    return edge(name(parent), name(child), now_ - age, turn, place);
  }

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

 private:
  static bool isSteady(int child) { return child % 4 != 0; }

  brute_force::Random random_;
  double now_ = 1000;
};

TEST(TransformSource, PosesAndStampsAreThoseOfTf2) {
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  int known = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomTf random(seed);
    BesideTf2 both;
    for (int i = 0; i < kMessages; ++i) {
      const auto transform = random.next();
      both.add(transform, transform.child_frame_id == name(5) ||
                              (transform.child_frame_id == name(6) && random.pick(2) == 0));
      known += both.expectSame(name(random.pick(kFrames)), name(random.pick(kFrames)));
      if (i == kMessages / 2) both.clear();
    }
  }
  EXPECT_GT(known, 10 * kMessages / 4);
}

TEST(TransformSource, QuaternionsThatAreNearlyUnitAreTakenAsTf2TakesThem) {
  BesideTf2 both;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond longer(turn.coeffs() * 1.004);
  both.add(edge("a", "b", 1, longer, {1, 2, 3}), false);
  both.add(edge("b", "c", 1, longer, {0.5, 0, 0}), false);
  EXPECT_TRUE(both.expectSame("a", "b"));
  EXPECT_TRUE(both.expectSame("a", "c"));
  EXPECT_TRUE(both.expectSame("c", "a"));
}

// A double beyond int64 must not be cast to it, as a build with -fsanitize=float-cast-overflow
// shows.
TEST(StaleBefore, ATimeoutBeyondAllTimesIsNever) {
  volatile double timeout = 2;  // else the compiler does the cast
  EXPECT_EQ(staleBefore(timeout, ros::Time(1000)), 998000000000);
  for (const double huge : {2e10, 1e300, std::numeric_limits<double>::infinity()}) {
    timeout = huge;
    EXPECT_EQ(staleBefore(timeout, ros::Time(1700000000)),
              std::numeric_limits<std::int64_t>::min());
  }
}

class RefusalTest : public testing::Test {
 protected:
  std::string reason(const geometry_msgs::TransformStamped& transform) {
    const std::vector<Refusal> refusals = tf_.add({transform}, false, ros::Time(1));
    return refusals.empty() ? "" : refusals.front().reason;
  }

  TransformSource tf_;
  const geometry_msgs::TransformStamped good_ = edge("a", "b", 1000, kNoTurn, {1, 2, 3});
};

TEST_F(RefusalTest, NamesTheFault) {
  auto bad = good_;
  bad.transform.translation.z = kNan;
  EXPECT_NE(reason(bad).find("NaN"), std::string::npos);
  bad = good_;
  bad.transform.rotation.w = 0;
  EXPECT_NE(reason(bad).find("quaternion"), std::string::npos);
  bad = good_;
  bad.child_frame_id = "/";
  EXPECT_NE(reason(bad).find("child_frame_id"), std::string::npos);
  bad = good_;
  bad.header.frame_id.clear();
  EXPECT_NE(reason(bad).find("frame_id"), std::string::npos);
  bad = good_;
  bad.header.frame_id = "/b";
  EXPECT_NE(reason(bad).find("own parent"), std::string::npos);
  EXPECT_EQ(reason(good_), "");
}

// tf2 throws at such stamps and loses what comes after them in the message.
TEST_F(RefusalTest, StampsThatTf2CannotAddToAreRefused) {
  auto last = good_;
  last.header.stamp.sec = std::numeric_limits<std::uint32_t>::max();
  auto malformed = good_;
  malformed.header.stamp.nsec = 1500000000;
  const auto refusals = tf_.add({last, malformed, good_}, false, ros::Time(1));
  ASSERT_EQ(refusals.size(), 2u);
  EXPECT_NE(std::string(refusals[1].reason).find("stamp"), std::string::npos);
  EXPECT_EQ(tf_.tree().newest(tf_.tree().frame("b")), 1000000000000);
}

TEST_F(RefusalTest, InfinityIsTf2sToTake) {
  auto infinite = good_;
  infinite.transform.translation.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason(infinite), "");
}

TEST_F(RefusalTest, RepeatedStampsAreRefusedWithoutAWord) {
  reason(good_);
  EXPECT_EQ(tf_.tree().lastHeard(tf_.tree().frame("b")), 1000000000);
  EXPECT_TRUE(tf_.add({good_}, false, ros::Time(2)).empty());
  EXPECT_EQ(tf_.tree().lastHeard(tf_.tree().frame("b")), 1000000000);
}

class AheadTest : public testing::Test {
 protected:
  static constexpr double kNow = 1000;
  static constexpr double kYear2100 = 4102444800;

  AheadTest() {
    send("arm", kNow, 1);
    send("leg", kNow, 1);
  }

  /// True if it is refused aloud.
  bool send(const std::string& child, double stamp, double x, double now = kNow) {
    return !tf_.add({edge("base", child, stamp, kNoTurn, {x, 0, 0})}, false, ros::Time(now))
                .empty();
  }

  double x(const std::string& child) {
    const auto from = tf_.tree().frame(child);
    const auto to = tf_.tree().frame("base");
    return tf_.latest(to, from, *tf_.tree().path(from, to))->world_from_link.translation().x();
  }

  TransformSource tf_;
};

TEST_F(AheadTest, BlocksItsEdgeAlone) {
  send("arm", kYear2100, 2);
  send("arm", kNow + 1, 3);
  EXPECT_EQ(x("arm"), 2);
  send("leg", kNow + 1, 3);
  EXPECT_EQ(x("leg"), 3);
}

TEST_F(AheadTest, IsToldWhenNothingElseIsTaken) {
  EXPECT_FALSE(send("arm", kYear2100, 2));
  EXPECT_FALSE(send("arm", kNow + 0.5, 3, kNow + 0.5));
  EXPECT_TRUE(send("arm", kNow + 1.5, 3, kNow + 1.5));
}

TEST_F(AheadTest, DistrustedEdgeBeginsAnewWithTheNextTransform) {
  send("arm", kYear2100, 2);
  tf_.distrustStampsAhead(ros::Time(kNow));
  EXPECT_EQ(x("arm"), 2);
  send("arm", kNow + 1, 3);
  EXPECT_EQ(x("arm"), 3);
  send("arm", kNow + 2, 4);
  EXPECT_EQ(x("arm"), 4);
}

TEST_F(AheadTest, DistrustIsOverWhenTheStampsGoOn) {
  send("arm", kYear2100, 2);
  tf_.distrustStampsAhead(ros::Time(kNow));
  send("arm", kYear2100 + 1, 3);
  send("arm", kNow + 1, 4);
  EXPECT_EQ(x("arm"), 3);
}

TEST_F(AheadTest, OldDataOnAnHonestEdgeStaysRefused) {
  tf_.distrustStampsAhead(ros::Time(kNow));
  send("leg", kNow - 20, 5);
  EXPECT_EQ(x("leg"), 1);
}

TEST_F(AheadTest, ClearingHeals) {
  send("arm", kYear2100, 2);
  tf_.clear();
  send("arm", kNow - 5, 3);
  EXPECT_EQ(x("arm"), 3);
}

}  // namespace
}  // namespace link_bounds
