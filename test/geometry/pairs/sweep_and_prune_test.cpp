// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs and distances are those of comparing every two boxes, to the bit.
#include "link_bounds/geometry/pairs/sweep_and_prune.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/pairs/sweep.h"
#include "link_bounds/geometry/box/length.h"
#include "testing/brute_force.h"
#include "testing/sanitized.h"

namespace link_bounds {

bool operator==(const BoxPair& a, const BoxPair& b) {
  return a.first == b.first && a.second == b.second && a.distance == b.distance;
}

std::ostream& operator<<(std::ostream& out, const BoxPair& overlap) {
  return out << overlap.first << " " << overlap.second << " at " << overlap.distance;
}

namespace {

using brute_force::Random;
using Boxes = std::vector<Aabb>;
using Overlaps = std::vector<BoxPair>;

constexpr std::array<double, 4> kMargins{0, 0.01, 0.1, 2.5};

/// signedDistance() by its formula, axis by axis.
double distance(const Aabb& a, const Aabb& b) {
  double inside = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d outside = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max(a.min()[k] - b.max()[k], b.min()[k] - a.max()[k]);
    inside = std::max(inside, gap);
    outside[k] = std::max(gap, 0.0);
  }
  return inside <= 0 ? inside : length(outside.x(), outside.y(), outside.z());
}

/// Compares every two boxes.
Overlaps allOverlaps(const Boxes& boxes, double margin) {
  Overlaps pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const double distance = signedDistance(boxes[i], boxes[j]);
      if (distance <= margin) pairs.push_back({i, j, distance});
    }
  }
  return pairs;
}

/// Returns how many pairs there are.
std::size_t expectExact(SweepAndPrune& search, const Boxes& boxes, double margin) {
  const Overlaps expected = allOverlaps(boxes, margin);
  EXPECT_EQ(search.find(boxes, margin), expected) << boxes.size() << " boxes, margin " << margin;
  return expected.size();
}

std::size_t expectExact(const Boxes& boxes, double margin) {
  SweepAndPrune search;
  const std::size_t count = expectExact(search, boxes, margin);
  expectExact(search, boxes, margin);  // again, from the candidates of the first search
  return count;
}

Aabb boxAround(const Eigen::Vector3d& center, const Eigen::Vector3d& half) {
  return {center - half, center + half};
}

/// With sides from 0.1 to 0.3 m in a cube of half width `size`.
Boxes clutter(Random& random, std::size_t count, double size) {
  Boxes boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.1) + random.vector(0.05);
    boxes.push_back(boxAround(random.vector(size), half));
  }
  return boxes;
}

TEST(SweepAndPrune, NoBoxAndOneBox) {
  EXPECT_EQ(expectExact({}, 0), 0u);
  EXPECT_EQ(expectExact({Aabb(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones())}, 1), 0u);
}

TEST(SweepAndPrune, RandomScenes) {
  Random random(1);
  for (const double size : {0.05, 0.5, 1.0, 5.0}) {
    for (const std::size_t count : {2u, 9u, 40u, 300u}) {
      for (const double margin : kMargins)
        expectExact(clutter(random, count, size), margin);
    }
  }
}

TEST(SweepAndPrune, SizesOfAllMagnitudes) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    Boxes boxes;
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3d center = random.vector(random.magnitude(-3, 3));
      boxes.push_back(boxAround(center, random.vector(random.magnitude(-6, 3)).cwiseAbs()));
    }
    for (const double margin : kMargins)
      expectExact(boxes, margin);
  }
}

TEST(SweepAndPrune, TouchingBoxesCount) {
  Boxes boxes;
  for (int i = 0; i < 4 * 4 * 4; ++i) {
    const Eigen::Vector3d min(i % 4, i / 4 % 4, i / 16);
    boxes.emplace_back(min, min + Eigen::Vector3d::Ones());
  }
  SweepAndPrune search;
  EXPECT_EQ(expectExact(search, boxes, 0), (10u * 10 * 10 - 64) / 2);
  for (const BoxPair& overlap : search.find(boxes, 0))
    EXPECT_EQ(overlap.distance, 0);
}

TEST(SweepAndPrune, GapsAsWideAsTheMargin) {
  Random random(3);
  for (const double gap : {0.1, 0.3, 1e-9, 1e-300, 3.0, 1e7}) {
    Boxes boxes;
    for (int i = 0; i < 100; ++i) {
      const double min = std::floor(random.uniform(-20, 20)) * 2 * gap;
      boxes.emplace_back(Eigen::Vector3d(min, 0, 0), Eigen::Vector3d(min + gap, 1, 1));
    }
    expectExact(boxes, gap);
    expectExact(boxes, std::nextafter(gap, 0));
  }
}

TEST(SweepAndPrune, AGapThatIsRoundedDownToTheMargin) {
  const double tiny = std::ldexp(0.9, -53);
  ASSERT_EQ(1 + tiny, 1);
  ASSERT_LT(1 - tiny, 1);
  const Eigen::Vector3d side(1, 0, 0);
  const Boxes boxes{{side, 2 * side}, {-side, -tiny * side}};
  EXPECT_EQ(expectExact(boxes, 1), 1u);
}

TEST(SweepAndPrune, IdenticalBoxes) {
  const Boxes boxes(50, Aabb(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()));
  EXPECT_EQ(expectExact(boxes, 0), 50u * 49 / 2);
}

TEST(SweepAndPrune, FlatBoxes) {
  Random random(4);
  Boxes boxes;
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d half = random.vector(0.5).cwiseAbs();
    half[i % 3] = 0;
    if (i % 7 == 0) half.setZero();
    boxes.push_back(boxAround((4 * random.vector(1)).array().round().matrix() / 4, half));
  }
  EXPECT_GT(expectExact(boxes, 0), 0u);
  EXPECT_GT(expectExact(boxes, 0.25), 0u);
}

TEST(SweepAndPrune, HugeBoxes) {
  Random random(5);
  Boxes boxes = clutter(random, 100, 1);
  boxes[17] = boxAround({0, 0, 0}, Eigen::Vector3d::Constant(2));  // covers all
  boxes[40] = boxAround({0, 0, 0}, Eigen::Vector3d::Constant(1e30));
  boxes[41] = boxAround({1e30, 0, 0}, {1e29, 1, 1e39});
  boxes[42] = boxAround({-1e200, 0, 1e200}, {1, 1e201, 1e200});
  boxes[99] = boxAround({3e38, 0, 0}, {1, 1, 1});
  for (const double margin : kMargins)
    EXPECT_GT(expectExact(boxes, margin), 2 * 96u);
  expectExact(boxes, 1e38);
}

// Boxes are finite. One that is not leaves all memory as it is, and others are found.
TEST(SweepAndPrune, ABoxThatIsNotANumber) {
  Random random(7);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (int corner = 0; corner < 6; ++corner) {
    SweepAndPrune search;
    Boxes boxes = clutter(random, 100, 0.5);
    (corner < 3 ? boxes[40].min() : boxes[40].max())[corner % 3] = kNan;
    for (int round = 0; round < 2; ++round) {
      std::size_t found = 0;
      for (const auto& pair : search.find(boxes, 0))
        found += pair.first != 40 && pair.second != 40;
      boxes.erase(boxes.begin() + 40);
      EXPECT_EQ(found, SweepAndPrune().find(boxes, 0).size());
      boxes.insert(boxes.begin() + 40, boxAround({kNan, kNan, kNan}, Eigen::Vector3d::Ones()));
    }
  }
}

TEST(SweepAndPrune, FarFromTheOrigin) {
  Random random(6);
  for (const double away : {1e6, -1e12, 1e15}) {
    Boxes boxes = clutter(random, 200, 1);
    for (Aabb& box : boxes)
      box.translate(Eigen::Vector3d(away, 1, -away));
    for (const double margin : kMargins)
      EXPECT_GT(expectExact(boxes, margin), 0u);
  }
}

TEST(SweepAndPrune, AlongEachAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    Boxes boxes;
    for (int i = 0; i < 500; ++i)
      boxes.push_back(boxAround(0.14 * i * Eigen::Vector3d::Unit(axis), {0.1, 0.1, 0.1}));
    EXPECT_EQ(expectExact(boxes, 0), 499u);
    for (int i = 0; i < 2; ++i)
      boxes.push_back(boxAround({0, 0, 0}, Eigen::Vector3d::Constant(1e300)));
    EXPECT_EQ(expectExact(boxes, 0), 499u + 2 * 500 + 1);
  }
}

/// A step in a random direction.
Eigen::Vector3d step(Random& random, double length) {
  return random.rotation() * Eigen::Vector3d(length, 0, 0);
}

TEST(SweepAndPrune, MovingBoxes) {
  for (const double length : {1e-5, 0.001, 0.002, 0.004, 0.02, 0.1, 0.5}) {
    for (const double margin : {0.0, 0.05}) {
      Random random(7);
      SweepAndPrune search;
      Boxes boxes = clutter(random, kIsSanitized ? 60 : 120, 0.6);
      std::vector<Eigen::Vector3d> velocities;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        velocities.push_back(step(random, length));
      std::size_t found = 0;
      for (int i = 0; i < 100; ++i) {
        const double sign = i / 20 % 2 == 0 ? 1 : -1;
        for (std::size_t k = 0; k < boxes.size(); ++k)
          boxes[k].translate(sign * velocities[k]);
        found += expectExact(search, boxes, margin);
      }
      EXPECT_GT(found, 100u);
    }
  }
}

TEST(SweepAndPrune, OneBoxMovesAmongManyThatRest) {
  Random random(8);
  SweepAndPrune search;
  Boxes boxes = clutter(random, 100, 0.6);
  for (int i = 0; i < 300; ++i) {
    boxes[50].translate(step(random, i % 40 == 0 ? 1.0 : 0.01));
    expectExact(search, boxes, 0.01);
  }
}

TEST(SweepAndPrune, GrowingAndShrinkingBoxes) {
  Random random(9);
  const Boxes resting = clutter(random, 100, 0.6);
  for (const double low_share : {0.0, 0.5, 1.0}) {
    SweepAndPrune search;
    for (int i = 0; i < 200; ++i) {
      Boxes boxes = resting;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        const double growth = 0.1 * (1 + std::sin(0.1 * i + static_cast<double>(k)));
        boxes[k].min().array() -= low_share * growth;
        boxes[k].max().array() += (1 - low_share) * growth;
      }
      expectExact(search, boxes, 0);
    }
  }
}

/// The boxes of arms beside each other, with each joint turned by some degrees.
Boxes arms(double degrees) {
  Boxes boxes;
  for (int arm = 0; arm < 4; ++arm) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().x() = 0.5 * arm;
    for (int link = 0; link < 30; ++link) {
      pose.rotate(
          brute_force::turned(degrees * (link % 3 - arm % 2), {1.0, 0.1 * link, 1.0 * arm}));
      Aabb box;
      for (const Eigen::Vector3d& corner :
           corners(Aabb(Eigen::Vector3d(-0.03, -0.03, 0), Eigen::Vector3d(0.03, 0.03, 0.1))))
        box.extend(pose * corner);
      boxes.push_back(box);
      pose.translate(Eigen::Vector3d(0, 0, 0.1));
    }
  }
  return boxes;
}

TEST(SweepAndPrune, TurningArms) {
  for (const double degrees_per_step : {0.01, 0.2, 30.0, 45.0}) {
    SweepAndPrune search;
    for (int i = 0; i < 100; ++i)
      EXPECT_GT(expectExact(search, arms(degrees_per_step * i), 0.02), 100u);
  }
}

TEST(SweepAndPrune, BoxesComeAndGo) {
  Random random(10);
  SweepAndPrune search;
  const Boxes all = clutter(random, 150, 0.6);
  for (int i = 0; i < 200; ++i) {
    Boxes boxes;
    for (const Aabb& box : all) {
      if (i % 5 == 0 || random.uniform(0, 1) < 0.8) boxes.push_back(box);
    }
    if (i % 11 == 0) boxes.clear();
    if (i % 13 == 0) boxes.resize(std::min(boxes.size(), std::size_t{1}));
    expectExact(search, boxes, 0);
  }
}

TEST(SweepAndPrune, AnotherBoxInTheSamePlaceOfTheList) {
  Random random(11);
  SweepAndPrune search;
  Boxes boxes = clutter(random, 50, 0.4);
  for (int i = 0; i < 50; ++i) {
    std::rotate(boxes.begin(), boxes.begin() + 1, boxes.end());
    expectExact(search, boxes, 0);
  }
}

TEST(SweepAndPrune, TheMarginMayChange) {
  Random random(12);
  SweepAndPrune search;
  Boxes boxes = clutter(random, 100, 0.8);
  for (int i = 0; i < 100; ++i) {
    for (Aabb& box : boxes)
      box.translate(step(random, 0.001));
    expectExact(search, boxes, kMargins[static_cast<std::size_t>(i / 3) % kMargins.size()]);
  }
}

TEST(Sweep, SeldomFindsWhatIsNotNear) {
  Random random(14);
  Sweep sweep;
  std::vector<IndexPair> pairs;
  Boxes scene = clutter(random, 1000, 1);
  scene[500] = boxAround({1e30, 0, 0}, Eigen::Vector3d::Constant(2e30));
  for (const double away : {0.0, 1e6}) {
    for (Aabb& box : scene)
      box.translate(Eigen::Vector3d::Constant(away));
    sweep.find(scene, 0, pairs);
    const std::size_t near = allOverlaps(scene, 0).size();
    EXPECT_GE(pairs.size(), near);
    EXPECT_LE(pairs.size(), near + near / 100);
  }
}

TEST(BruteForceOverlaps, DistancesAreThoseOfTheFormula) {
  Random random(15);
  const Boxes boxes = clutter(random, 200, 1);
  std::size_t found = 0;
  for (const double margin : kMargins) {
    Overlaps expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        const double d = distance(boxes[i], boxes[j]);
        if (d <= margin) expected.push_back({i, j, d});
      }
    }
    EXPECT_EQ(allOverlaps(boxes, margin), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 1000u);
}

}  // namespace
}  // namespace link_bounds
