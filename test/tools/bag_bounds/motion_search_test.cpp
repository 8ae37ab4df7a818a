// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random motions between messages beside dense samples of their poses: no point has a longer way
// than the bound, and what is proven of a zone holds.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "testing/random_motion.h"
#include "testing/sanitized.h"
#include "tools/bag_bounds/watch/zone_search.h"

namespace link_bounds {
namespace {

constexpr int kSamples = 400;

class Sampled {
 public:
  explicit Sampled(std::uint64_t seed) : motion(seed) {
    motion.send([&](const std::string& parent, const std::string& child,
                    const QuadEdge::Sample& sample, bool is_static) {
      TransformView view(parent, child, "",
                         ros::Time().fromNSec(static_cast<std::uint64_t>(sample.stamp)));
      view.parent_from_child = sample.pose;
      EXPECT_TRUE(tf.add({view}, is_static, ros::Time(1)).empty());
    });
    target = tf.frame(motion.targetName());
    source = tf.frame(RandomMotion::sourceName());
    const auto [begin, end] = motion.span;
    for (int i = 0; i <= kSamples; ++i)
      poses.push_back(
          MatrixPose(*tf.pose(target, source, begin + (end - begin) * i / kSamples)).affine);
  }

  BodyMotion body(double way) const {
    return {motion.span, *linkBox(motion.link, poses.front()), way, target, source, &motion.link,
            nullptr};
  }

  RandomMotion motion;
  TransformBuffer tf;
  TransformBuffer::Frame target;
  TransformBuffer::Frame source;
  std::vector<Eigen::Affine3d> poses;
};

double wayOf(const Eigen::Vector3d& point, const std::vector<Eigen::Affine3d>& poses) {
  double way = 0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    way += (poses[i] * point - poses[i - 1] * point).norm();
  return way;
}

TEST(MotionSearch, NoPointHasALongerWay) {
  int known = 0, tight = 0;
  for (int seed = 1; seed <= repetitions(600); ++seed) {
    const Sampled sampled(static_cast<std::uint64_t>(seed));
    EdgeWays edges(sampled.tf);
    WayBound ways(edges, sampled.target);
    const double radius = radiusOf(sampled.motion.link);
    const double bound = ways.of(sampled.source, radius, sampled.motion.span);
    EXPECT_EQ(ways.of(sampled.source, radius, sampled.motion.span), bound);
    if (!std::isfinite(bound)) continue;
    ++known;
    double longest = 0;
    for (const Eigen::Vector3f& point : sampled.motion.points)
      longest = std::max(longest, wayOf(point.cast<double>(), sampled.poses));
    EXPECT_LE(longest, bound * (1 + 1e-9) + 1e-12) << seed;
    if (longest > bound / 10) ++tight;
  }
  std::cout << known << " bounds, " << tight << " at most ten times the way\n";
  EXPECT_GT(known, repetitions(600) / 2);
  EXPECT_GT(tight, known / 4);
}

/// One that is near the middle of the motion.
Aabb zoneNear(const Sampled& sampled, brute_force::Random& random) {
  const Aabb box = *linkBox(sampled.motion.link, sampled.poses[sampled.poses.size() / 2]);
  const double size = box.diagonal().norm();
  const Eigen::Vector3d corner = box.center() + random.vector(size);
  return {corner, corner + (random.vector(size / 10).array().abs()).matrix()};
}

TEST(MotionSearch, WhatIsProvenOfAZoneHolds) {
  std::map<std::string, int> reasons;
  int free = 0, entered = 0, undecided = 0, between = 0, coarse = 0;
  for (int seed = 1; seed <= repetitions(3000) && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const Sampled sampled(static_cast<std::uint64_t>(seed));
    if (sampled.motion.isAtRest()) continue;
    brute_force::Random random(static_cast<std::uint64_t>(seed));
    const Aabb zone = zoneNear(sampled, random);
    std::vector<double> distances;
    for (const Eigen::Affine3d& pose : sampled.poses)
      distances.push_back(signedDistance(*linkBox(sampled.motion.link, pose), zone));
    if (distances.front() <= 0 || distances.back() <= 0) continue;
    const double nearest = *std::min_element(distances.begin(), distances.end());
    const double wanted = seed % 2 == 0 ? 0 : 1e9;
    const ZoneSearch found =
        searchZone(sampled.tf, sampled.body(0), zone, wanted, [] { return false; });
    EXPECT_LE(found.clearance, std::max(nearest, 0.0));
    EXPECT_TRUE(nearest > 0 || !found.crossings.empty() || !found.undecided.empty());
    if (!found.crossings.empty()) {
      ++entered;
      EXPECT_LE(found.nearest, 0);
      EXPECT_TRUE(found.crossings.front().is_entry);
      between += nearest > 0;
    } else if (!found.undecided.empty()) {
      ++undecided;
      ++reasons[found.undecided];
    } else {
      ++free;
      EXPECT_GT(found.clearance, 0);
      // Some of these motions have 1000 m/s, and 1 mm in the resolution of time.
      const double gap = std::min(nearest, found.nearest) - found.clearance;
      if (wanted > 0 && gap > kZoneAccuracy) ++coarse;
    }
  }
  std::cout << free << " free, " << entered << " entered, of which " << between
            << " between all samples, " << undecided << " undecided, " << coarse
            << " less accurate\n";
  for (const auto& [reason, count] : reasons)
    std::cout << count << " times: " << reason << '\n';
  EXPECT_GT(free, repetitions(3000) / 10);
  EXPECT_GT(entered, repetitions(3000) / 100);
  EXPECT_LE(undecided, 1 + free / 10);
  EXPECT_LE(coarse, 1 + free / 20);
}

TEST(MotionSearch, AMotionThatTfDoesNotKnowIsUndecided) {
  const Sampled sampled(2);
  BodyMotion motion = sampled.body(0);
  motion.span.end += 1'000'000'000'000;
  const Aabb zone(Eigen::Vector3d(1e3, 1e3, 1e3), Eigen::Vector3d(2e3, 2e3, 2e3));
  EXPECT_NE(searchZone(sampled.tf, motion, zone, 0, [] { return false; }).undecided, "");
  EXPECT_NE(searchZone(sampled.tf, sampled.body(0), zone, 1e9, [] { return true; }).clearance, 1e9);
}

}  // namespace
}  // namespace link_bounds
