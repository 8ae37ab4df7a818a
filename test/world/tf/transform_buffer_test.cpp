// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses at any time are those of tf2; what is refused, and how an edge begins again.
#include "world/tf/transform_buffer.h"

#include <cmath>
#include <iostream>
#include <limits>

#include "testing/beside_tf2.h"
#include "testing/numbers.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

constexpr int kHistories = 100;
constexpr int kMessages = 120;

const Eigen::Quaterniond kNoTurn = Eigen::Quaterniond::Identity();

/// True if both know the pose.
bool expectSamePose(BesideTf2& both, const std::string& target, const std::string& source,
                    ros::Time time) {
  SCOPED_TRACE(target + " from " + source);
  const auto pose = both.ours.pose(both.ours.frame(target), both.ours.frame(source),
                                   static_cast<std::int64_t>(time.toNSec()));
  const auto expected = both.lookUp(target, source, time);
  EXPECT_EQ(pose.has_value(), expected.has_value());
  if (!pose || !expected) return false;
  expectSame(MatrixPose(*pose).affine, *expected);
  return true;
}

TEST(TransformBuffer, PosesAtAnyTimeAreThoseOfTf2) {
  int known = 0;
  for (std::uint64_t seed = 1; seed <= kHistories && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomTf random(seed, seed % 3 == 0 ? Oddity::kLoops : Oddity::kUneven);
    brute_force::Random times(seed);
    BesideTf2 both;
    double newest = 1700000000;
    for (int i = 0; i < kMessages; ++i) {
      if (i == kMessages / 2) {
        both.tf2.clear();
        both.ours.clear();
      }
      const RandomMessage message = random.next();
      both.add(message);
      for (const auto& transform : message.transforms)
        newest = std::max(newest, transform.header.stamp.toSec());
      for (int k = 0; k < 4; ++k) {
        const int target = random.pick(random.frames());
        const int source = random.pick(random.frames());
        const ros::Time time(newest - times.uniform(-0.01, k < 2 ? 0.2 : 11));
        if (target != source)
          known += expectSamePose(both, frameName(target), frameName(source), time);
      }
    }
  }
  std::cout << known << " poses were known\n";
  EXPECT_GT(known, kHistories * kMessages / 2);
}

/// One edge, whose child has one of two parents.
class EdgeBesideTf2 {
 public:
  explicit EdgeBesideTf2(std::uint64_t seed) : random_(seed) {}

  /// Mostly new, sometimes late or far too late; some are infinite, some have another parent.
  void insertOne() {
    newest_ += pick(3) * kStep;
    const double stamp = newest_ - (pick(3) == 0 ? pick(26) * kStep : 0);
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(random_.uniform(-3, 3), Eigen::Vector3d::UnitZ()));
    const auto transform = edge(pick(10) == 0 ? "b" : "a", "child", stamp, turn,
                                {pick(4) == 0 ? kInfinity : random_.uniform(-1, 1), 1, 2});
    const std::uint64_t accepted = both_.ours.intake().accepted;
    both_.ours.add({transform}, false, ros::Time(1));
    EXPECT_EQ(both_.tf2.setTransform(transform, "test"), both_.ours.intake().accepted > accepted);
  }

  /// At every step of the last twelve seconds, and between; returns how many were known.
  int expectSame() {
    int known = 0;
    for (int i = 0; i < 48; ++i) {
      for (const char* parent : {"a", "b"})
        known += expectSame(parent, ros::Time(newest_ - i * kStep / 2));
    }
    return known;
  }

 private:
  static constexpr double kStep = 0.5;  // s; so coarse that many stamps are the oldest one

  /// Looking up infinity, tf2 gives NaN.
  static bool isSame(double a, double b) {
    return (!std::isfinite(a) && !std::isfinite(b)) || std::abs(a - b) < kSame;
  }

  bool expectSame(const std::string& parent, ros::Time time) {
    const auto pose = both_.ours.pose(both_.ours.frame(parent), both_.ours.frame("child"),
                                      static_cast<std::int64_t>(time.toNSec()));
    const auto expected = both_.lookUp(parent, "child", time);
    EXPECT_EQ(pose.has_value(), expected.has_value()) << newest_ - time.toSec();
    if (!pose || !expected) return false;
    const auto& q = expected->transform.rotation;
    EXPECT_TRUE(isSame(pose->translation().x(), expected->transform.translation.x))
        << pose->translation().x() << ", not " << expected->transform.translation.x << ", "
        << newest_ - time.toSec() << " s before the newest";
    EXPECT_TRUE(isSame(pose->rotation().z(), q.z) && isSame(pose->rotation().w(), q.w));
    return true;
  }

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  brute_force::Random random_;
  BesideTf2 both_;
  double newest_ = 1700000000;
};

TEST(TransformBuffer, AnEdgeIsThatOfTf2AtEveryStamp) {
  constexpr int kEdges = 200;
  constexpr int kSamples = 200;
  constexpr int kCompared = kSamples / 10;
  long known = 0;
  for (std::uint64_t seed = 1; seed <= kEdges && !testing::Test::HasFailure(); ++seed) {
    EdgeBesideTf2 both(seed);
    for (int i = 0; i < kSamples; ++i) {
      both.insertOne();
      if (i % (kSamples / kCompared) == 0) known += both.expectSame();
    }
  }
  std::cout << known << " poses were known\n";
  EXPECT_GT(known, 10L * kEdges * kCompared);
}

TEST(TransformBuffer, QuaternionsThatAreNearlyUnitAreAcceptedAsTf2AcceptsThem) {
  BesideTf2 both;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond longer(turn.coeffs() * 1.004);
  both.add({{edge("a", "b", 1, longer, {1, 2, 3})}, false});
  both.add({{edge("b", "c", 1, longer, {0.5, 0, 0})}, false});
  for (const auto& [target, source] : {std::pair("a", "b"), {"a", "c"}, {"c", "a"}})
    EXPECT_TRUE(expectSamePose(both, target, source, ros::Time(0)));
}

class EdgesTest : public testing::Test {
 protected:
  TransformBuffer::Frame send(const std::string& parent, const std::string& child, double stamp,
                              bool is_static = false) {
    tf_.add({edge(parent, child, stamp, kNoTurn, {1, 2, 3})}, is_static, now_);
    return tf_.frame(child);
  }

  TransformBuffer tf_;
  ros::Time now_{100};
};

TEST_F(EdgesTest, StructureChangesOnlyWithParentsOfWatchedEdges) {
  tf_.watch(send("a", "b", 1));
  const auto before = tf_.structure();
  send("a", "b", 2);
  send("a", "other", 2);
  send("c", "other", 3);
  EXPECT_EQ(tf_.structure(), before);
  send("c", "b", 3);
  EXPECT_NE(tf_.structure(), before);
}

TEST_F(EdgesTest, TellsWhichEdgesAreNewSinceAVersion) {
  const auto before = tf_.version();
  const auto child = send("a", "b", 1);
  const auto between = tf_.version();
  const auto other = send("a", "c", 1);
  EXPECT_TRUE(tf_.isNewerThan(before, child));
  EXPECT_TRUE(tf_.isNewerThan(before, other));
  EXPECT_FALSE(tf_.isNewerThan(before, tf_.frame("a")));
  EXPECT_FALSE(tf_.isNewerThan(between, child));
  EXPECT_TRUE(tf_.isNewerThan(between, other));
  EXPECT_FALSE(tf_.isNewerThan(tf_.version(), other));
}

TEST_F(EdgesTest, TheFirstTransformDecidesWhatIsStatic) {
  send("a", "b", 0, true);
  EXPECT_TRUE(tf_.isStatic(send("a", "b", 5, false)));
  send("a", "c", 5, false);
  EXPECT_FALSE(tf_.isStatic(send("a", "c", 6, true)));
}

TEST_F(EdgesTest, TheLagIsThatOfNeededEdges) {
  const auto child = send("a", "b", 95);
  EXPECT_FALSE(tf_.takeMaxLag());
  tf_.need(child);
  send("a", "b", 97);
  send("a", "other", 90);
  EXPECT_EQ(tf_.takeMaxLag(), 3'000'000'000);
  EXPECT_FALSE(tf_.takeMaxLag());
  tf_.release(child);
  send("a", "b", 98);
  EXPECT_FALSE(tf_.takeMaxLag());
}

/// Who followed a pose before a jump of the clock wants to know what was left out after it.
TEST_F(EdgesTest, AnEdgeIsNeededAfterAClearUntilItHasATransform) {
  const auto needed = send("a", "b", 1);
  send("a", "c", 1);
  tf_.need(needed);
  tf_.clear();
  tf_.release(needed);
  const auto drop = [this](const char* child) {
    tf_.countDropped(TransformView("a", child, "", ros::Time(2)));
    return tf_.neededIntake().dropped;
  };
  EXPECT_EQ(drop("b"), 1u);
  EXPECT_EQ(drop("c"), 1u);
  EXPECT_EQ(drop("unknown"), 1u);
  send("a", "b", 3);
  EXPECT_EQ(drop("b"), 1u) << "nobody needs it any more";
}

/// As tf2: only one slash goes, so "//b" is the frame "/b", which nobody needs.
TEST_F(EdgesTest, AFrameWithASlashMoreIsAnotherOne) {
  tf_.need(send("a", "b", 1));
  const auto refuse = [this](const char* child) {
    tf_.add({edge("a", child, 2, kNoTurn, {std::nan(""), 0, 0})}, false, now_);
    return tf_.neededIntake().unusable;
  };
  EXPECT_EQ(refuse("//b"), 0u);
  EXPECT_EQ(refuse("/b"), 1u);
  EXPECT_EQ(refuse("b"), 2u);
  EXPECT_EQ(tf_.intake().unusable, 3u);
}

TEST_F(EdgesTest, AgesCountFromTheStartOfTheClock) {
  now_ = ros::Time(0);
  const auto child = send("a", "b", 1);
  tf_.startClock(ros::Time(5));
  EXPECT_EQ(tf_.received(child), 5000000000);
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

  TransformBuffer tf_;
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
  EXPECT_EQ(tf_.newest(tf_.frame("b")), 1000000000000);
}

TEST_F(RefusalTest, InfinityIsTf2sToTake) {
  auto infinite = good_;
  infinite.transform.translation.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason(infinite), "");
}

TEST_F(RefusalTest, RepeatedStampsAreRefusedWithoutAWord) {
  reason(good_);
  EXPECT_EQ(tf_.received(tf_.frame("b")), 1000000000);
  EXPECT_TRUE(tf_.add({good_}, false, ros::Time(2)).empty());
  EXPECT_EQ(tf_.received(tf_.frame("b")), 1000000000);
}

class LateTest : public testing::Test {
 protected:
  LateTest() { send(100, 100); }

  /// What is reported.
  std::optional<Refusal> send(double now, double stamp) {
    const auto refusals =
        tf_.add({edge("a", "b", stamp, kNoTurn, {1, 2, 3})}, false, ros::Time(now));
    return refusals.empty() ? std::nullopt : std::optional(refusals.front());
  }

  std::int64_t received() { return tf_.received(tf_.frame("b")) / 1000000000; }

  TransformBuffer tf_;
};

TEST_F(LateTest, OnlyANewerStampCountsAsReceived) {
  EXPECT_FALSE(send(101, 99));
  EXPECT_FALSE(send(101, 100));
  EXPECT_TRUE(send(101, 80));
  EXPECT_EQ(received(), 100);
  EXPECT_FALSE(send(101, 100.5));
  EXPECT_EQ(received(), 101);
}

TEST_F(LateTest, IsReportedWithItsLagWhenNoneNewerComes) {
  const auto late = send(102, 95);
  ASSERT_TRUE(late && late->behind);
  EXPECT_TRUE(late->is_accepted);
  EXPECT_DOUBLE_EQ(*late->behind, 5);
  const auto too_old = send(102, 80);
  ASSERT_TRUE(too_old && too_old->behind);
  EXPECT_FALSE(too_old->is_accepted);
  EXPECT_DOUBLE_EQ(*too_old->behind, 20);
  EXPECT_EQ(tf_.intake().late, 1u);
  EXPECT_EQ(tf_.intake().too_old, 1u);
}

TEST_F(LateTest, BesideNewerStampsIsOrdinary) {
  for (int i = 1; i < 100; ++i) {
    EXPECT_FALSE(send(100 + i, 100 + i));
    EXPECT_FALSE(send(100.5 + i, 99.9 + i));
  }
}

TEST_F(LateTest, BesideAHealthyPublisherIsReportedWithItsLag) {
  for (int i = 1; i < 100; ++i) {
    EXPECT_FALSE(send(100 + 0.02 * i, 100 + 0.02 * i));
    EXPECT_FALSE(send(100 + 0.02 * i, 100 + 0.02 * i)) << "repeated";
    const auto late = send(100.01 + 0.02 * i, 95.01 + 0.02 * i);
    ASSERT_TRUE(late && late->behind);
    EXPECT_TRUE(late->is_accepted);
    EXPECT_NEAR(*late->behind, 4.99, 1e-6);
    const auto too_old = send(100.01 + 0.02 * i, 80 + 0.02 * i);
    ASSERT_TRUE(too_old && too_old->behind);
    EXPECT_NEAR(*too_old->behind, 20, 1e-6);
  }
}

/// What contradicts /tf_static is told, and remembered until something ends it.
TEST(StaticInDoubt, EndsTenSecondsLaterWithAReloadOrAJump) {
  TransformBuffer tf;
  const auto send = [&tf](double x, bool is_static, double now) {
    return !tf.add({edge("base", "arm", now, kNoTurn, {x, 0, 0})}, is_static, ros::Time(now))
                .empty();
  };
  const auto is_in_doubt = [&tf] { return tf.isStaticInDoubt(tf.frame("arm")); };
  EXPECT_FALSE(send(1, true, 100));
  EXPECT_FALSE(send(1, false, 101)) << "the same pose";
  EXPECT_FALSE(is_in_doubt());
  EXPECT_FALSE(send(2, true, 102)) << "/tf_static may have another one";
  EXPECT_FALSE(is_in_doubt());
  EXPECT_TRUE(send(3, false, 103));
  EXPECT_FALSE(send(2, true, 104));
  EXPECT_TRUE(is_in_doubt()) << "/tf may go on";
  EXPECT_FALSE(send(2, true, 114));
  EXPECT_FALSE(is_in_doubt());
  EXPECT_TRUE(send(3, false, 115));
  tf.distrustStampsAhead(ros::Time(116));
  EXPECT_FALSE(is_in_doubt()) << "~reload";
  EXPECT_TRUE(send(4, false, 117));
  EXPECT_TRUE(is_in_doubt());
  tf.clear();
  EXPECT_FALSE(is_in_doubt()) << "a jump of the clock back";
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
    return tf_.pose(tf_.frame("base"), tf_.frame(child), 0)->translation().x();
  }

  TransformBuffer tf_;
};

TEST_F(AheadTest, BlocksItsEdgeAlone) {
  send("arm", kYear2100, 2);
  send("arm", kNow + 1, 3);
  EXPECT_EQ(x("arm"), 2);
  send("leg", kNow + 1, 3);
  EXPECT_EQ(x("leg"), 3);
}

TEST_F(AheadTest, IsToldWithTheNextTransform) {
  EXPECT_FALSE(send("arm", kYear2100, 2));
  EXPECT_TRUE(send("arm", kNow + 0.5, 3, kNow + 0.5));
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
