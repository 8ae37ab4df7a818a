// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The three representations of a box contain each other, and hardly more.
#include <gtest/gtest.h>

#include <tuple>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/box/rounding.h"
#include "testing/brute_force.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

constexpr int kBoxesPerKind = 20000;
constexpr double kLargestWideningInUlp = 4;

/// What makes an interval hard to represent by a centre or a width.
enum class Kind { kOrdinary, kTiny, kHuge, kFarFromZero, kFlat, kLopsided, kSubnormal };
constexpr std::array<Kind, 7> kKinds{Kind::kOrdinary,    Kind::kTiny, Kind::kHuge,
                                     Kind::kFarFromZero, Kind::kFlat, Kind::kLopsided,
                                     Kind::kSubnormal};

std::pair<double, double> randomInterval(brute_force::Random& random, Kind kind) {
  double a = random.uniform(-1, 1);
  double b = random.uniform(-1, 1);
  switch (kind) {
    case Kind::kOrdinary:
      break;
    case Kind::kTiny:
      a *= 1e-290;
      b *= 1e-290;
      break;
    case Kind::kHuge:
      a *= 1e290;
      b *= 1e290;
      break;
    case Kind::kFarFromZero:
      a = random.sign() * 1e9 + a * 1e-3;
      b = a + std::abs(b) * random.magnitude(-7, 0);
      break;
    case Kind::kFlat:
      b = a;
      break;
    case Kind::kLopsided:
      b *= random.magnitude(-40, 0);
      break;
    case Kind::kSubnormal:
      a = std::floor(a * 100) * std::numeric_limits<double>::denorm_min();
      b = std::floor(b * 100) * std::numeric_limits<double>::denorm_min();
      break;
  }
  return {std::min(a, b), std::max(a, b)};
}

Aabb randomBox(brute_force::Random& random, Kind kind) {
  Aabb box;
  for (int k = 0; k < 3; ++k) {
    std::tie(box.min()[k], box.max()[k]) = randomInterval(random, kind);
  }
  return box;
}

/// Calls check(box) for many boxes of every kind.
template <class Check>
void forManyBoxes(std::uint64_t seed, const Check& check) {
  brute_force::Random random(seed);
  for (const Kind kind : kKinds) {
    for (int i = 0; i < kBoxesPerKind && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)));
      check(randomBox(random, kind));
    }
  }
}

/// Sharper than the header's promise, which measures by the largest coordinate of all axes.
void expectBarelyWider(const Aabb& wider, const Aabb& box) {
  EXPECT_TRUE(wider.contains(box));
  for (int k = 0; k < 3; ++k) {
    const double largest = std::max(std::abs(box.min()[k]), std::abs(box.max()[k]));
    const double limit = kLargestWideningInUlp * (nextUp(largest) - largest);
    EXPECT_LE(wider.max()[k] - box.max()[k], limit);
    EXPECT_LE(box.min()[k] - wider.min()[k], limit);
  }
}

TEST(Representations, MinWidthContainsTheBoxInRealNumbers) {
  forManyBoxes(1, [](const Aabb& box) {
    const MinWidth result = toMinWidth(box);
    EXPECT_EQ(result.min, box.min());
    for (int k = 0; k < 3; ++k) {
      const Quad max = static_cast<Quad>(result.min[k]) + static_cast<Quad>(result.width[k]);
      EXPECT_TRUE(max >= static_cast<Quad>(box.max()[k]));
    }
  });
}

TEST(Representations, MinWidthContainsTheBoxWhenTheReaderAdds) {
  forManyBoxes(2, [](const Aabb& box) {
    const MinWidth result = toMinWidth(box);
    EXPECT_TRUE(((result.min + result.width).array() >= box.max().array()).all());
    EXPECT_TRUE((result.width.array() >= 0).all());
  });
}

TEST(Representations, CenterRadiusContainsTheBoxInRealNumbers) {
  forManyBoxes(3, [](const Aabb& box) {
    const CenterRadius result = toCenterRadius(box);
    for (int k = 0; k < 3; ++k) {
      const Quad center = result.center[k];
      const Quad radius = result.radius[k];
      EXPECT_TRUE(center - radius <= static_cast<Quad>(box.min()[k]));
      EXPECT_TRUE(center + radius >= static_cast<Quad>(box.max()[k]));
    }
  });
}

TEST(Representations, CenterRadiusContainsTheBoxWhenTheReaderAdds) {
  forManyBoxes(4, [](const Aabb& box) {
    const CenterRadius result = toCenterRadius(box);
    EXPECT_TRUE(((result.center - result.radius).array() <= box.min().array()).all());
    EXPECT_TRUE(((result.center + result.radius).array() >= box.max().array()).all());
    EXPECT_TRUE((result.radius.array() >= 0).all());
  });
}

TEST(Representations, ThereAndBackWidensByAFewUlp) {
  forManyBoxes(5, [](const Aabb& box) {
    expectBarelyWider(toAabb(toMinWidth(box)), box);
    expectBarelyWider(toAabb(toCenterRadius(box)), box);
  });
}

TEST(Representations, ConversionToMinMaxContainsAnyMinWidth) {
  forManyBoxes(6, [](const Aabb& box) {
    const MinWidth source{box.min(), box.max().cwiseAbs()};
    const Aabb result = toAabb(source);
    EXPECT_EQ(result.min(), source.min);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(static_cast<Quad>(result.max()[k]) >=
                  static_cast<Quad>(source.min[k]) + static_cast<Quad>(source.width[k]));
    }
  });
}

TEST(Representations, ConversionToMinMaxContainsAnyCenterRadius) {
  forManyBoxes(7, [](const Aabb& box) {
    const CenterRadius source{box.min(), box.max().cwiseAbs()};
    const Aabb result = toAabb(source);
    for (int k = 0; k < 3; ++k) {
      const Quad center = source.center[k];
      const Quad radius = source.radius[k];
      EXPECT_TRUE(static_cast<Quad>(result.min()[k]) <= center - radius);
      EXPECT_TRUE(static_cast<Quad>(result.max()[k]) >= center + radius);
    }
  });
}

TEST(Representations, RepresentableNumbersStayExact) {
  const Aabb box(Eigen::Vector3d(-1, 2, 5), Eigen::Vector3d(0, 4, 8));
  EXPECT_EQ(toMinWidth(box).width, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(toCenterRadius(box).center, Eigen::Vector3d(-0.5, 3, 6.5));
  EXPECT_EQ(toCenterRadius(box).radius, Eigen::Vector3d(0.5, 1, 1.5));
  EXPECT_EQ(toAabb(toCenterRadius(box)).min(), box.min());
  EXPECT_EQ(toAabb(toMinWidth(box)).max(), box.max());
}

TEST(Representations, TheCentreOfAHugeBoxDoesNotOverflow) {
  const Eigen::Vector3d low = Eigen::Vector3d::Constant(1.5e308);
  const Eigen::Vector3d high = Eigen::Vector3d::Constant(1.7e308);
  EXPECT_DOUBLE_EQ(toCenterRadius(Aabb(low, high)).center.x(), 1.6e308);
}

}  // namespace
}  // namespace link_bounds
