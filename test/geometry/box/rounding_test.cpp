// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Directed sums against quadruple precision.
#include "link_bounds/geometry/box/rounding.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

constexpr int kPairs = 200000;
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

/// Two numbers whose sum quadruple precision holds exactly: 53 + 53 bits and 7 in between.
std::pair<double, double> randomPair(brute_force::Random& random) {
  const int exponent = static_cast<int>(random.uniform(-900, 900));
  const int distance = static_cast<int>(random.uniform(-55, 55));
  return {std::ldexp(random.uniform(-1, 1), exponent),
          std::ldexp(random.uniform(-1, 1), exponent + distance)};
}

Quad exactSum(double a, double b) {
  return static_cast<Quad>(a) + static_cast<Quad>(b);
}

TEST(Rounding, AddUpIsTheSmallestDoubleNotBelowTheSum) {
  brute_force::Random random(1);
  for (int i = 0; i < kPairs; ++i) {
    const auto [a, b] = randomPair(random);
    const double sum = addUp(a, b);
    ASSERT_TRUE(static_cast<Quad>(sum) >= exactSum(a, b)) << a << " + " << b;
    ASSERT_TRUE(static_cast<Quad>(nextDown(sum)) < exactSum(a, b)) << a << " + " << b;
  }
}

TEST(Rounding, AddDownIsTheLargestDoubleNotAboveTheSum) {
  brute_force::Random random(2);
  for (int i = 0; i < kPairs; ++i) {
    const auto [a, b] = randomPair(random);
    const double sum = addDown(a, b);
    ASSERT_TRUE(static_cast<Quad>(sum) <= exactSum(a, b)) << a << " + " << b;
    ASSERT_TRUE(static_cast<Quad>(nextUp(sum)) > exactSum(a, b)) << a << " + " << b;
  }
}

TEST(Rounding, RepresentableSumsAreLeftAlone) {
  EXPECT_EQ(addUp(0.5, 0.25), 0.75);
  EXPECT_EQ(addDown(0.5, 0.25), 0.75);
  EXPECT_EQ(addUp(0.1, 0), 0.1);
  EXPECT_EQ(addDown(0.1, -0.1), 0);
  EXPECT_EQ(addUp(kSmallest, kSmallest), 2 * kSmallest);
}

TEST(Rounding, SummandsFarBelowOneUlpStillCount) {
  EXPECT_EQ(addUp(1, kSmallest), nextUp(1));
  EXPECT_EQ(addUp(1, -kSmallest), 1);
  EXPECT_EQ(addDown(1, -kSmallest), nextDown(1));
  EXPECT_EQ(addDown(1, kSmallest), 1);
  EXPECT_EQ(addUp(kSmallest, 1), nextUp(1));
}

TEST(Rounding, OverflowGoesOutward) {
  EXPECT_EQ(addUp(kLargest, kLargest), kInfinity);
  EXPECT_EQ(addDown(-kLargest, -kLargest), -kInfinity);
  EXPECT_EQ(addUp(kLargest, 1), kInfinity);
}

TEST(Rounding, FloatUpIsTheSmallestFloatNotBelow) {
  brute_force::Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const double value = random.sign() * random.magnitude(-50, 40);
    const float up = floatUp(value);
    EXPECT_GE(up, value);
    EXPECT_LT(std::nextafter(up, -HUGE_VALF), value);
    EXPECT_EQ(floatDown(-value), -up);
  }
}

TEST(Rounding, FloatsStayAsTheyAre) {
  for (const float value : {0.0f, 1.0f, -0.1f, 1e-45f, 3.4e38f, -3.4e38f}) {
    EXPECT_EQ(floatUp(value), value);
    EXPECT_EQ(floatDown(value), value);
  }
}

TEST(Rounding, BeyondFloatIsInfinite) {
  EXPECT_EQ(floatUp(1e39), HUGE_VALF);
  EXPECT_EQ(floatDown(-1e39), -HUGE_VALF);
  EXPECT_EQ(floatUp(-1e39), -std::numeric_limits<float>::max());
  EXPECT_EQ(floatDown(1e39), std::numeric_limits<float>::max());
}

TEST(Rounding, UnitRoundoffIsHalfTheStepAboveOne) {
  EXPECT_EQ(1 + 2 * kUnitRoundoff, nextUp(1));
  EXPECT_EQ(1 - kUnitRoundoff, nextDown(1));
}

}  // namespace
}  // namespace link_bounds
