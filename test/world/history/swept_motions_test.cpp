// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Swept boxes of random motions contain every pose and are tight, beside poses in quadruple
// precision and those of tf2. LINK_BOUNDS_TEST_SAMPLES says how often each motion is sampled in
// quadruple precision; otherwise only near its extremes.
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

#include "testing/random_motion.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr int kMotions = 2000;
constexpr double kTimeout = 0;
constexpr double kRounding = 1e-13;  // m

/// The poses of one motion.
class Sampled {
 public:
  explicit Sampled(std::uint64_t seed) : motion(seed) {
    motion.send([&](const std::string& parent, const std::string& child,
                    const QuadEdge::Sample& sample, bool is_static) {
      geometry_msgs::TransformStamped transform;
      transform.header.frame_id = parent;
      transform.child_frame_id = child;
      transform.header.stamp.fromNSec(static_cast<std::uint64_t>(sample.stamp));
      std::memcpy(static_cast<void*>(&transform.transform), sample.pose.numbers.data(),
                  sizeof(sample.pose.numbers));
      tf2.setTransform(transform, "test", is_static);
      EXPECT_TRUE(ours.add({transform}, is_static, ros::Time(1)).empty());
    });
    target = ours.frame(motion.targetName());
    source = ours.frame(RandomMotion::sourceName());
  }

  QuadBox quad(std::int64_t time) const {
    return quadBox(motion.points, motion.radius,
                   quadPose(motion.from_source, motion.from_target, time));
  }

  Aabb box(std::int64_t time) const {
    return *linkBox(motion.link, MatrixPose(*ours.pose(target, source, time)).affine);
  }

  RandomMotion motion;
  tf2::BufferCore tf2;
  TransformBuffer ours;
  TransformBuffer::Frame target;
  TransformBuffer::Frame source;
};

/// Stamps at which the link may be farthest: all samples, the last time before each, and some
/// between them.
std::vector<std::int64_t> stampsOf(const RandomMotion& motion) {
  constexpr int kBetween = 10;
  const auto [begin, end] = motion.span;
  std::vector<std::int64_t> cuts{begin, end};
  for (const auto* edges : {&motion.from_source, &motion.from_target}) {
    for (const QuadEdge& edge : *edges) {
      for (const QuadEdge::Sample& sample : edge.samples) {
        if (sample.stamp > begin && sample.stamp < end) cuts.push_back(sample.stamp);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    for (int k = 0; k < kBetween; ++k)
      stamps.push_back(cuts[i] + (cuts[i + 1] - cuts[i]) * k / kBetween);
    stamps.push_back(std::max(cuts[i], cuts[i + 1] - 1));
  }
  stamps.push_back(end);
  return stamps;
}

double face(const Aabb& box, int face) {
  return face < 3 ? box.max()[face] : -box.min()[face - 3];
}

/// The stamp between two stamps at which a face is farthest outside.
std::int64_t farthest(const Sampled& sampled, int which, std::int64_t from, std::int64_t to) {
  while (to - from > 8) {
    const std::int64_t step = (to - from) / 4;
    std::int64_t best = from;
    double most = -std::numeric_limits<double>::infinity();
    for (int k = 1; k < 4; ++k) {
      const double out = face(sampled.box(from + k * step), which);
      if (out <= most) continue;
      most = out;
      best = from + k * step;
    }
    from = best - step;
    to = best + step;
  }
  return (from + to) / 2;
}

/// One stamp for each face, found in double.
std::vector<std::int64_t> extremeStamps(const Sampled& sampled) {
  const std::vector<std::int64_t> stamps = stampsOf(sampled.motion);
  std::vector<Aabb> boxes;
  for (const std::int64_t stamp : stamps)
    boxes.push_back(sampled.box(stamp));
  std::vector<std::int64_t> extremes;
  for (int which = 0; which < 6; ++which) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < stamps.size(); ++i) {
      if (face(boxes[i], which) > face(boxes[best], which)) best = i;
    }
    extremes.push_back(stamps[best]);
    extremes.push_back(farthest(sampled, which, stamps[best > 0 ? best - 1 : 0],
                                stamps[std::min(best + 1, stamps.size() - 1)]));
  }
  return extremes;
}

int quadSamples() {
  const char* text = std::getenv("LINK_BOUNDS_TEST_SAMPLES");
  return text ? std::stoi(text) : 0;
}

/// In quadruple precision.
QuadBox unionOf(const Sampled& sampled, const std::vector<std::int64_t>& extremes) {
  std::vector<std::int64_t> stamps = extremes;
  const auto [begin, end] = sampled.motion.span;
  for (int i = 0; i < quadSamples(); ++i)
    stamps.push_back(begin + (end - begin) / quadSamples() * i);
  QuadBox result = sampled.quad(end);
  for (const std::int64_t stamp : stamps) {
    const QuadBox box = sampled.quad(stamp);
    for (std::size_t k = 0; k < 3; ++k) {
      result.min[k] = std::min(result.min[k], box.min[k]);
      result.max[k] = std::max(result.max[k], box.max[k]);
    }
  }
  return result;
}

/// What tf2 itself gives.
Aabb boxInTf2(const Sampled& sampled, std::int64_t stamp) {
  const auto transform =
      sampled.tf2.lookupTransform(sampled.motion.targetName(), RandomMotion::sourceName(),
                                  ros::Time().fromNSec(static_cast<std::uint64_t>(stamp)));
  const Tf2Pose pose = TransformView(transform).parent_from_child;
  return *linkBox(sampled.motion.link, MatrixPose(pose).affine);
}

/// Where lengths differ the library may interpolate otherwise than its formula as compiled here.
/// Its extremes may then be at other stamps.
void mergeTf2(const Sampled& sampled, const Aabb& swept, QuadBox& all) {
  for (const std::int64_t stamp : stampsOf(sampled.motion)) {
    const Aabb box = boxInTf2(sampled, stamp);
    EXPECT_TRUE(swept.contains(box)) << stamp;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      all.min[i] = std::min(all.min[i], Quad(box.min()[k]));
      all.max[i] = std::max(all.max[i], Quad(box.max()[k]));
    }
  }
}

TEST(SweptMotions, ContainAllPosesAndAreTight) {
  double worst = 0;
  for (int seed = 1; seed <= repetitions(kMotions) && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const Sampled sampled(static_cast<std::uint64_t>(seed));
    const SweptBox swept = sweptBox(sampled.ours, sampled.target, sampled.source,
                                    sampled.motion.span, sampled.motion.link, kTimeout);
    ASSERT_TRUE(swept.box) << swept.problem;
    // At rest it is the box of one pose, which rounding may place a little elsewhere.
    const Aabb outer = padded(*swept.box, sampled.motion.isAtRest() ? kRounding : 0);
    const std::vector<std::int64_t> extremes = extremeStamps(sampled);
    for (const std::int64_t stamp : extremes)
      EXPECT_TRUE(outer.contains(boxInTf2(sampled, stamp))) << stamp;
    QuadBox all = unionOf(sampled, extremes);
    if (sampled.motion.isSloppy()) mergeTf2(sampled, outer, all);
    EXPECT_TRUE(contains(outer, all));
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const auto size = static_cast<double>(all.max[i] - all.min[i]);
      const double excess = swept.box->sizes()[k] - size;
      worst = std::max(worst, excess / (1e-3 + 0.01 * size));
      EXPECT_LE(excess, 1e-3 + 0.01 * size) << "along axis " << k;
    }
  }
  std::cout << "largest excess: " << worst << " of 1 mm + 1 %\n";
}

}  // namespace
}  // namespace link_bounds
