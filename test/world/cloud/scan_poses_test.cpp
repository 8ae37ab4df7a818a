// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random ways of a link, also with quaternions whose lengths change, against tf's pose at each
// time.
#include "world/cloud/scan_poses.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"
#include "world/tf/tf2_pose.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::int64_t kBegin = 20000000000000000;  // ns
constexpr std::int64_t kPeriod = 50000000;          // ns, between transforms
constexpr int kSamples = 6;
constexpr double kRounding = 1e-9;  // m

Eigen::Quaterniond nearly(const Eigen::Quaterniond& q, Random& random) {
  const Eigen::Vector3d turn = random.vector(0.02);
  return (Eigen::Quaterniond(1, turn.x(), turn.y(), turn.z()) * q).normalized();
}

/// One edge, which turns or does not, and whose quaternions are of length 1 or not quite.
void addEdge(const char* parent, const char* child, Random& random, TransformBuffer& tf) {
  Eigen::Quaterniond q(random.rotation());
  const bool turns = random.uniform(0, 1) < 0.3;
  const double noise = random.uniform(0, 1) < 0.6 ? 0.004 : 0;
  Eigen::Vector3d place = random.vector(3);
  for (int i = 0; i < kSamples; ++i) {
    if (turns) q = nearly(q, random);
    place += random.vector(0.06);
    const double length = 1 + random.uniform(-noise, noise);
    std::vector<TransformView> views{TransformView(
        parent, child, "", ros::Time().fromNSec(static_cast<std::uint64_t>(kBegin + i * kPeriod)))};
    views[0].parent_from_child =
        Tf2Pose(tf2::Quaternion(q.x() * length, q.y() * length, q.z() * length, q.w() * length),
                tf2::Vector3(place.x(), place.y(), place.z()));
    tf.add(views, false, views[0].stamp);
  }
}

/// Also the last moments before the samples.
std::int64_t someTime(TimeSpan span, int i, Random& random) {
  if (i % 3 > 0)
    return span.begin + std::llround(random.uniform(0, static_cast<double>(span.end - span.begin)));
  const std::int64_t before = i % 2 == 0 ? 1 : std::llround(random.uniform(1, 2e6));
  return kBegin + (1 + i % (kSamples - 2)) * kPeriod - before;
}

TEST(ScanPoses, AreAsNearToThoseOfTfAsTheySay) {
  Random random(1);
  int count = 0;
  for (int run = 0; run < 1000; ++run) {
    TransformBuffer tf;
    const auto sensor = tf.frame("sensor"), link = tf.frame("link");
    addEdge("sensor", "base", random, tf);
    addEdge("base", "link", random, tf);
    const TimeSpan span{kBegin + kPeriod / 5, kBegin + (kSamples - 1) * kPeriod - kPeriod / 5};
    const Eigen::Vector3d corner(0.2, 0.2, 0.2);
    const ScanPoses poses = scanPoses(tf, sensor, {{link, Aabb(-corner, corner)}}, span);
    if (!poses.problem.empty()) continue;
    ++count;
    ScanCursor cursor(poses);
    for (int i = 0; i < 200; ++i) {
      const std::int64_t time = someTime(span, i, random);
      const Eigen::Affine3d link_from_sensor = MatrixPose(*tf.pose(link, sensor, time)).affine;
      const Eigen::Vector3d in_link = random.vector(0.2);
      const Eigen::Vector3d point = link_from_sensor.inverse() * in_link;
      cursor.seek(time);
      ASSERT_LE((cursor.inLink(poses.links[0], point) - link_from_sensor * point).norm(),
                poses.links[0].error + kRounding)
          << "run " << run;
      ASSERT_TRUE(poses.links[0].box.contains(point)) << "run " << run;
    }
  }
  EXPECT_GT(count, 900);
}

}  // namespace
}  // namespace link_bounds
