// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lengths, and the boxes made of them, have the same bits on every machine.
#include "link_bounds/geometry/box/length.h"

#include <gtest/gtest.h>

#include "geometry/shape/shape_extents.h"
#include "link_bounds/geometry/box/rounding.h"
#include "testing/brute_force.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

constexpr int kVectors = 200'000;

double plainLength(double x, double y, double z) {
  return std::sqrt((x * x + y * y) + z * z);
}

TEST(Length, IsTheRootOfTheSumOfSquaresToTheBit) {
  brute_force::Random random(1);
  for (int i = 0; i < kVectors; ++i) {
    const Eigen::Vector3d v = random.magnitude(-9, 9) * random.vector(1);
    ASSERT_EQ(length(v.x(), v.y(), v.z()), plainLength(v.x(), v.y(), v.z()));
    ASSERT_EQ(length(v.x(), v.y()), plainLength(v.x(), v.y(), 0));
  }
}

TEST(Length, OfNumbersOfAnyMagnitude) {
  brute_force::Random random(2);
  for (const int exponent : {-1000, -700, -400, 450, 600, 1000}) {
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector3d v = random.vector(1);
      const double scale = std::ldexp(1.0, exponent);
      const double expected = scale * plainLength(v.x(), v.y(), v.z());
      EXPECT_EQ(length(scale * v.x(), scale * v.y(), scale * v.z()), expected);
    }
  }
  EXPECT_EQ(length(0, -0.0), 0);
  EXPECT_EQ(length(3e-310, 4e-310), 5e-310);
  EXPECT_EQ(length(-HUGE_VAL, 1, 2), HUGE_VAL);
  EXPECT_TRUE(std::isnan(length(std::nan(""), 1, 2)));
  EXPECT_EQ(length(1.7e308, 1.7e308, 1.7e308), HUGE_VAL);
}

TEST(Length, IsWithinThreeRoundings) {
  brute_force::Random random(3);
  for (int i = 0; i < kVectors; ++i) {
    const Eigen::Vector3d v = random.vector(1);
    const Quad found = length(v.x(), v.y(), v.z());
    Quad square = 0;
    for (int k = 0; k < 3; ++k)
      square += static_cast<Quad>(v[k]) * static_cast<Quad>(v[k]);
    const Quad low = found * (1 - 3 * kUnitRoundoff);
    const Quad high = found * (1 + 3 * kUnitRoundoff);
    ASSERT_TRUE(low * low <= square && square <= high * high);
  }
}

/// Half the extent of a solid along one row, as shape.cpp pads it.
double expectedHalf(Solid solid, const Eigen::Vector3d& row, const Eigen::Vector3d& size,
                    double pad_per_entry) {
  const double x = row.x() * size.x();
  const double y = row.y() * size.y();
  const double z = row.z() * size.z();
  const double half =
      solid == Solid::kCylinder
          ? (plainLength(x, y, 0) + std::abs(z)) / 2
          : (solid == Solid::kEllipsoid ? plainLength(x, y, z)
                                        : (std::abs(x) + std::abs(y)) + std::abs(z)) /
                2;
  const double entries = std::abs(row.x()) + std::abs(row.y()) + std::abs(row.z());
  return half + (entries * pad_per_entry + std::numeric_limits<double>::min());
}

TEST(Length, BoxesOfSolidsHaveTheBitsOfPlainArithmetic) {
  brute_force::Random random(4);
  for (const Solid solid : {Solid::kBox, Solid::kEllipsoid, Solid::kCylinder}) {
    int different = 0;
    for (int i = 0; i < 10'000; ++i) {
      const Shape shape{nullptr, solid, random.vector(1).cwiseAbs(), Eigen::Affine3d::Identity()};
      const Eigen::Affine3d pose = random.affine(0);
      const double pad_per_entry = ShapeExtents(shape).pad_per_entry;
      const Aabb box = worldBox(shape, pose).value();
      for (int k = 0; k < 3; ++k) {
        const double half = expectedHalf(solid, pose.linear().row(k), shape.size, pad_per_entry);
        different += box.max()[k] == half && box.min()[k] == -half ? 0 : 1;
      }
    }
    EXPECT_EQ(different, 0) << "of 30000 faces of solid " << static_cast<int>(solid);
  }
}

}  // namespace
}  // namespace link_bounds
