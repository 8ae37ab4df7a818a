// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The bound of a circle is that of the circle, and large coordinates cost nothing.
#include "world/history/deviation_bound.h"

#include <gtest/gtest.h>

#include <cmath>

namespace link_bounds {
namespace {

Tf2Pose turnedBy(double angle, const tf2::Vector3& place) {
  return {{0, 0, std::sin(angle / 2), std::cos(angle / 2)}, place};
}

TEST(DeviationBound, OfACircleIsItsAcceleration) {
  constexpr double kRadius = 2;
  const tf2::Vector3 origin(0, 0, 0);
  for (const double angle : {0.01, 0.5, 3.0}) {
    const EdgeStep step = stepBetween(turnedBy(0.3, origin), turnedBy(0.3 + angle, origin));
    const double expected = angle * angle * kRadius / 8;
    EXPECT_NEAR(bulge({{step}, {}}, kRadius, 0).smooth, expected, 1e-6);
    EXPECT_GE(bulge({{step}, {}}, kRadius, 0).smooth, kRadius * (1 - std::cos(angle / 2)));
    EXPECT_NEAR(bulge({{step.in(0.1)}, {}}, kRadius, 0).smooth, expected / 100, 1e-6);
  }
}

TEST(DeviationBound, OfAPartOfTheTimeHoldsThatOfItsSteps) {
  const tf2::Quaternion longer = turnedBy(0.4, {0, 0, 0}).rotation() * (1 + 1e-4);
  const EdgeStep turn = stepBetween(turnedBy(0.3, {1, 0, 0}), {longer, {1, 0.1, 0}});
  const EdgeStep tiny = stepBetween(turnedBy(0, {0, 0, 0}), turnedBy(6e-8, {0, 0, 0}));
  const Bulge whole = bulge({{turn, tiny}, {turn}}, 2, 3);
  for (const double part : {1.0, 0.5, 0.1, 1e-3, 1e-9, 0.0}) {
    const Bulge expected = bulge({{turn.in(part), tiny.in(part)}, {turn.in(part)}}, 2, 3);
    EXPECT_GE(whole.in(part), (expected.smooth + expected.jump) * (1 - 1e-12)) << part;
    EXPECT_NEAR(whole.in(part), expected.smooth + expected.jump, 0.01 * part * part) << part;
  }
  // What rounding adds does not become smaller.
  const EdgeStep straight = stepBetween(turnedBy(1, {0, 0, 0}), turnedBy(1, {1e6, 0, 0}));
  const Bulge rounding = bulge({{straight}, {}}, 1, 1e6);
  EXPECT_EQ(rounding.in(1e-3), rounding.smooth);
}

TEST(DeviationBound, OfAStraightWayIsRounding) {
  const EdgeStep step = stepBetween(turnedBy(1, {0, 0, 0}), turnedBy(1, {10, 20, 30}));
  EXPECT_LT(bulge({{step, step}, {step}}, 1, 100).smooth, 1e-10);
}

TEST(DeviationBound, ATinyTurnMayBeAJump) {
  const tf2::Vector3 origin(0, 0, 0);
  const EdgeStep large = stepBetween(turnedBy(0, origin), turnedBy(1e-6, origin));
  EXPECT_EQ(bulge({{large}, {large}}, 2, 0).jump, 0);
  const EdgeStep tiny = stepBetween(turnedBy(0, origin), turnedBy(6e-8, origin));
  EXPECT_GE(bulge({{tiny}, {}}, 2, 0).jump, 6e-8 * 2);
  EXPECT_GE(bulge({{}, {tiny}}, 2, 0).jump, 6e-8 * 2);
  EXPECT_EQ(bulge({{tiny.in(0.5)}, {}}, 2, 0).jump, bulge({{tiny}, {}}, 2, 0).jump);
  const tf2::Quaternion longer = turnedBy(6e-8, origin).rotation() * (1 + 1e-6);
  const EdgeStep stretched = stepBetween(turnedBy(0, origin), {longer, origin});
  EXPECT_GE(bulge({{stretched}, {}}, 2, 0).jump, 2e-6 * 2);
}

// Both the robot and an object are far from the origin of the map, but near each other.
TEST(DeviationBound, DoesNotGrowWithTheCoordinatesOfTheMap) {
  const tf2::Vector3 place(5e6, 0, 0);
  const EdgeStep robot = stepBetween(turnedBy(0, place), turnedBy(0.1, place));
  const EdgeStep object = stepBetween(turnedBy(0, place), turnedBy(0, place));
  EXPECT_LT(bulge({{object}, {robot}}, 1, 1).smooth, 0.1 * 0.1 * 2.1 / 8);
}

}  // namespace
}  // namespace link_bounds
