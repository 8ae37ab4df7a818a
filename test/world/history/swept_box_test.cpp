// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Swept boxes of motions whose box is known, and why there is none.
#include "world/history/swept_box.h"

#include <gtest/gtest.h>

#include <limits>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

constexpr double kNever = 0;
constexpr double kTight = 1e-3;  // m; all links here are points

class SweptBoxTest : public testing::Test {
 protected:
  void send(const std::string& parent, const std::string& child, double stamp, double degrees,
            const Eigen::Vector3d& place, bool is_static = false) {
    const double angle = degrees * M_PI / 180;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    sendQuaternion(parent, child, stamp, turn, place, is_static);
  }

  void sendQuaternion(const std::string& parent, const std::string& child, double stamp,
                      const Eigen::Quaterniond& turn, const Eigen::Vector3d& place,
                      bool is_static = false) {
    tf_.add({edge(parent, child, stamp, turn, place)}, is_static, ros::Time(1));
  }

  /// An edge with two samples.
  void move(const std::string& parent, const std::string& child, double degrees,
            const Eigen::Vector3d& step) {
    send(parent, child, 10, 0, {0, 0, 0});
    send(parent, child, 11, degrees, step);
  }

  SweptBox sweep(double begin, double end, double timeout = kNever,
                 const std::string& target = "base", const std::string& source = "tip") {
    return sweptBox(tf_, tf_.frame(target), tf_.frame(source),
                    {nanoseconds(begin), nanoseconds(end)}, link_, timeout);
  }

  static std::int64_t nanoseconds(double seconds) {
    return static_cast<std::int64_t>(ros::Time(seconds).toNSec());
  }

  /// Contained, and not larger than kTight on each side.
  static void expectBox(const SweptBox& swept, const Eigen::Vector3d& min,
                        const Eigen::Vector3d& max) {
    ASSERT_TRUE(swept.box) << swept.problem;
    EXPECT_EQ(swept.problem, "");
    const Aabb& box = *swept.box;
    EXPECT_TRUE(box.contains(Aabb(min, max)))
        << box.min().transpose() << ", " << box.max().transpose();
    EXPECT_TRUE(padded(Aabb(min, max), kTight).contains(box))
        << box.min().transpose() << ", " << box.max().transpose();
  }

  static void expectProblem(const SweptBox& swept, const std::vector<std::string>& parts) {
    EXPECT_FALSE(swept.box);
    for (const std::string& part : parts)
      EXPECT_NE(swept.problem.find(part), std::string::npos) << swept.problem;
  }

  static BoundedLink pointAt(const Eigen::Vector3f& place) {
    Shape shape;
    shape.points = std::make_shared<const PointSet>(std::vector<Eigen::Vector3f>{place});
    return {"tip", {shape}, 0, ""};
  }

  TransformBuffer tf_;
  BoundedLink link_ = pointAt({1, 0, 0});
};

TEST_F(SweptBoxTest, AQuarterTurnBulges) {
  send("base", "tip", 10, -45, {0, 0, 2});
  send("base", "tip", 11, 45, {0, 0, 2});
  const double end = std::sqrt(0.5);
  expectBox(sweep(10, 11), {end, -end, 2}, {1, end, 2});
  expectBox(sweep(10.5, 11), {end, 0, 2}, {1, end, 2});
}

TEST_F(SweptBoxTest, AScrewIsBoundedWithTheStepAlongItsAxis) {
  move("base", "tip", 179, {0, 0, 3});
  const double end = std::cos(179 * M_PI / 180);
  expectBox(sweep(10, 11), {end, 0, 0}, {1, 1, 3});
}

// While the base turns forwards the arm turns backwards, so the tip goes straight on.
TEST_F(SweptBoxTest, EdgesAreComposed) {
  link_ = pointAt({0, 0, 0});
  move("base", "arm", 90, {0, 0, 0});
  send("arm", "tip", 10, 0, {1, 0, 0});
  send("arm", "tip", 11, -90, {1, 0, 0});
  expectBox(sweep(10, 11), {0, 0, 0}, {1, 1, 0});
}

TEST_F(SweptBoxTest, ASampleOfOneEdgeInsideTheSpanCounts) {
  link_ = pointAt({0, 0, 0});
  move("base", "arm", 0, {1, 0, 0});
  for (const auto& [stamp, y] :
       {std::pair(9.9, 0.0), {10.45, 0.0}, {10.5, 5.0}, {10.55, 0.0}, {12.0, 0.0}})
    send("arm", "tip", stamp, 0, {0, y, 0});
  expectBox(sweep(10, 11), {0, 0, 0}, {1, 5, 0});
}

TEST_F(SweptBoxTest, TheTargetMayMove) {
  send("base", "lidar", 10, 0, {0, 0, 0});
  send("base", "lidar", 11, 90, {0, 0, 0});
  send("base", "tip", 10, 0, {0, 0, 0}, true);
  expectBox(sweep(10, 11, kNever, "lidar"), {0, -1, 0}, {1, 0, 0});
}

// Coordinates of a map can be large, the way of an object in the robot's frame is short.
TEST_F(SweptBoxTest, IsTightFarFromTheOriginOfTheMap) {
  const Eigen::Vector3d far(500000, 5000000, 0);
  send("map", "base", 10, 0, far);
  send("map", "base", 11, 60, far);
  send("map", "tip", 10, 0, far, true);
  const double y = std::sqrt(0.75);
  expectBox(sweep(10, 11), {0.5, -y, 0}, {1, 0, 0});
}

TEST_F(SweptBoxTest, HasTheBoxOfTheLinkAtOneMomentAndAtRest) {
  link_ = meshLink("tip", 1);
  link_.padding = 0.1;
  move("base", "arm", 90, {1, 2, 3});
  send("arm", "tip", 10, 30, {1, 0, 0}, true);
  const auto box_at = [&](const std::string& target, double stamp) {
    return *linkBox(
        link_,
        MatrixPose(*tf_.pose(tf_.frame(target), tf_.frame("tip"), nanoseconds(stamp))).affine);
  };
  for (const auto& [swept, box] : {std::pair(sweep(10.3, 10.3), box_at("base", 10.3)),
                                   {sweep(11, 11), box_at("base", 11)},
                                   {sweep(5, 20, kNever, "arm"), box_at("arm", 5)}}) {
    ASSERT_TRUE(swept.box) << swept.problem;
    EXPECT_EQ(swept.box->min(), box.min());
    EXPECT_EQ(swept.box->max(), box.max());
  }
}

// A link 1 km away that turns by 170 degrees from sample to sample, for five seconds.
TEST_F(SweptBoxTest, IsGivenUpAtOnce) {
  link_ = pointAt({1000, 0, 0});
  for (int i = 0; i <= 100; ++i)
    send("base", "tip", 10 + 0.05 * i, 170.0 * i, {0, 0, 0});
  const auto sweep_until = [&](const std::function<bool()>& gives_up) {
    return sweptBox(tf_, tf_.frame("base"), tf_.frame("tip"), {nanoseconds(10), nanoseconds(15)},
                    link_, kNever, gives_up);
  };
  int looks = 0;
  EXPECT_TRUE(sweep_until([&looks] { return ++looks < 0; }).box);
  const int all_looks = looks;
  EXPECT_GT(all_looks, 100);  // so the time between two of them is short beside the whole
  for (const int last : {1, 2, all_looks / 2, all_looks}) {
    looks = 0;
    const SweptBox swept = sweep_until([&] { return ++looks == last; });
    EXPECT_FALSE(swept.box);
    EXPECT_EQ(swept.problem, kNotInTime);
    EXPECT_EQ(looks, last);
  }
}

// tf2 does not interpolate between quaternions of one direction, but their lengths scale what they
// carry: the tip jumps at the second sample.
TEST_F(SweptBoxTest, ContainsBothSidesOfAJump) {
  link_ = pointAt({0, 0, 0});
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  sendQuaternion("base", "arm", 10, turn, {0, 0, 0});
  turn.coeffs() *= 1.004;
  sendQuaternion("base", "arm", 11, turn, {1, 0, 0});
  send("arm", "tip", 10, 0, {100, 0, 0}, true);
  const SweptBox swept = sweep(10, 11);
  ASSERT_TRUE(swept.box);
  for (const std::int64_t stamp : {nanoseconds(11) - 1, nanoseconds(11)}) {
    const auto pose = tf_.pose(tf_.frame("base"), tf_.frame("tip"), stamp);
    const tf2::Vector3 t = pose->translation();
    EXPECT_TRUE(swept.box->contains(Eigen::Vector3d(t.x(), t.y(), t.z()))) << t.x();
  }
}

// As tf2 may do for so small an angle, depending on its compiler. Here it interpolates.
TEST_F(SweptBoxTest, ContainsATinyTurnThatJumps) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-4.2e-8, Eigen::Vector3d::UnitZ()));
  sendQuaternion("base", "tip", 10, Eigen::Quaterniond::Identity(), {0, 0, 0});
  sendQuaternion("base", "tip", 11, turn, {1, 1, 0});
  const SweptBox swept = sweep(10, 11);
  ASSERT_TRUE(swept.box);
  EXPECT_TRUE(swept.box->contains(Eigen::Vector3d(2, 1 - 4.2e-8, 0)));
  EXPECT_TRUE(swept.box->contains(Eigen::Vector3d(2, 1, 0)));
}

TEST_F(SweptBoxTest, AGapLongerThanTheTimeoutIsAProblem) {
  for (const double stamp : {10.0, 11.0, 14.0, 15.0})
    send("base", "tip", stamp, 0, {stamp, 0, 0});
  const std::vector<std::string> words{"\"tip\"", "11.0 s and 14.0 s", "timeout"};
  expectProblem(sweep(10, 15, 2), words);
  expectProblem(sweep(12, 13, 2), words);
  expectProblem(sweep(10.5, 11.000000001, 2), words);
  expectBox(sweep(10, 15, 3), {11, 0, 0}, {16, 0, 0});
  expectBox(sweep(10, 15, kNever), {11, 0, 0}, {16, 0, 0});
  expectBox(sweep(10, 11, 2), {11, 0, 0}, {12, 0, 0});
  expectBox(sweep(14, 15, 2), {15, 0, 0}, {16, 0, 0});
}

TEST_F(SweptBoxTest, ANewParentIsAProblem) {
  send("base", "hand", 10, 0, {0, 0, 0}, true);
  for (const double stamp : {10.0, 11.0})
    send("base", "tip", stamp, 0, {stamp, 0, 0});
  for (const double stamp : {12.0, 13.0})
    send("hand", "tip", stamp, 0, {stamp, 0, 0});
  const std::vector<std::string> words{"\"tip\"", "parent", "\"base\" to \"hand\"",
                                       "11.0 s and 12.0 s"};
  expectProblem(sweep(10, 13), words);
  expectProblem(sweep(11.2, 11.7), words);
  expectBox(sweep(10, 11), {11, 0, 0}, {12, 0, 0});
  expectBox(sweep(12, 13), {13, 0, 0}, {14, 0, 0});
}

TEST_F(SweptBoxTest, EdgesAboveBothFramesDoNotMatter) {
  move("base", "tip", 0, {1, 0, 0});
  move("base", "lidar", 0, {0, 0, 0});
  send("odom", "base", 10.2, 0, {0, 0, 0});
  send("map", "base", 10.7, 0, {0, 0, 0});
  expectBox(sweep(10, 11, 2, "lidar"), {1, 0, 0}, {2, 0, 0});
}

TEST_F(SweptBoxTest, AHistoryThatDoesNotCoverTheSpanIsAProblem) {
  for (double stamp = 10; stamp < 25; stamp += 0.5)
    send("base", "tip", stamp, 0, {0, 0, 0});
  expectProblem(sweep(14.4, 20), {"\"tip\"", "only from 14.5 s on"});
  expectProblem(sweep(14.499999999, 20), {"only from 14.5 s on", "the span from 14.499999999 s"});
  expectProblem(sweep(20, 24.6), {"\"tip\"", "only up to 24.5 s"});
  expectProblem(sweep(30, 31), {"only up to 24.5 s"});
  expectBox(sweep(14.5, 24.5), {1, 0, 0}, {1, 0, 0});
}

TEST_F(SweptBoxTest, NothingIsKnownFromBeforeAClockJump) {
  move("base", "tip", 0, {1, 0, 0});
  tf_.clear();
  send("base", "tip", 10.5, 0, {0, 0, 0});
  send("base", "tip", 10.7, 0, {0, 0, 0});
  expectProblem(sweep(10.4, 10.6), {"from 10.5 s"});
  EXPECT_TRUE(sweep(10.5, 10.6).box);
}

TEST_F(SweptBoxTest, UnconnectedFramesAreAProblem) {
  send("base", "tip", 10, 0, {0, 0, 0}, true);
  expectProblem(sweep(10, 11, kNever, "elsewhere"), {"\"tip\"", "\"elsewhere\""});
  send("a", "b", 10, 0, {0, 0, 0}, true);
  send("b", "a", 10, 0, {0, 0, 0}, true);
  expectProblem(sweep(10, 11, kNever, "base", "a"), {"loop"});
  expectProblem(sweep(10, 11, kNever, "a", "tip"), {"loop"});
}

TEST_F(SweptBoxTest, InfinityIsAProblem) {
  for (const double bad : {std::numeric_limits<double>::infinity(), 1e300}) {
    move("base", "tip", 90, {0, 0, 0});
    send("base", "tip", 10.5, 30, {bad, 0, 0});
    expectProblem(sweep(10.1, 10.2), {"not finite"});
    tf_.clear();
  }
}

TEST_F(SweptBoxTest, ALinkWithoutShapesHasNoBox) {
  link_ = BoundedLink();
  move("base", "tip", 0, {1, 0, 0});
  expectProblem(sweep(10, 11), {"no geometry"});
}

}  // namespace
}  // namespace link_bounds
