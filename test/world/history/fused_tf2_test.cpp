// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Motions at which the library tf2 interpolates and the same formula compiled here does not, or the
// other way round. Linked with fused_library.cpp, and with the random motions of
// swept_motions_test.cpp.
#include <gtest/gtest.h>
#include <tf2/time_cache.h>

#include <cmath>

#include "world/history/edge_motion.h"

namespace link_bounds {
namespace {

constexpr std::int64_t kSecond = 1000000000;

/// What the library gives.
Tf2Pose inLibrary(const EdgeSample& older, const EdgeSample& newer, std::int64_t stamp) {
  tf2::TimeCache cache;
  for (const EdgeSample* sample : {&older, &newer}) {
    tf2::TransformStorage stored;
    stored.rotation_ = sample->parent_from_child.rotation();
    stored.translation_ = sample->parent_from_child.translation();
    stored.stamp_.fromNSec(static_cast<std::uint64_t>(sample->stamp));
    stored.frame_id_ = stored.child_frame_id_ = 0;
    cache.insertData(stored);
  }
  tf2::TransformStorage found;
  cache.getData(ros::Time().fromNSec(static_cast<std::uint64_t>(stamp)), found);
  return {found.rotation_, found.translation_};
}

void expectNear(const Tf2Pose& pose, const Tf2Pose& expected) {
  for (std::size_t i = 0; i < pose.numbers.size(); ++i)
    EXPECT_NEAR(pose.numbers[i], expected.numbers[i], 1e-14) << i;
}

// A thousand tiny turns between quaternions of different lengths.
TEST(FusedTf2, AnEdgeMovesAsInTheLibraryOrAsHere) {
  int sudden_here = 0, sudden_there = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double half_angle = i * 5e-11;
    const tf2::Quaternion from(0.1, 0.2, 0.3, 0.9);
    const tf2::Quaternion turn(0, std::sin(half_angle), 0, std::cos(half_angle));
    const EdgeSample older{{from, {1, 2, 3}}, 0, kSecond};
    const EdgeSample newer{{from * turn * 1.004, {1, 2, 4}}, 0, 2 * kSecond};
    EdgeMotion edge({&older, &newer});
    const std::int64_t middle = kSecond * 3 / 2;
    expectNear(edge.at(middle), interpolated(older, newer, middle));
    if (!edge.isAmbiguous()) continue;
    ++(edge.isSudden() ? sudden_here : sudden_there);
    const bool was_sudden = edge.isSudden();
    edge.followLibrary(true);
    EXPECT_NE(edge.isSudden(), was_sudden);
    expectNear(edge.at(middle), inLibrary(older, newer, middle));
    edge.followLibrary(false);
    expectNear(edge.at(middle), interpolated(older, newer, middle));
  }
  EXPECT_GT(sudden_here, 0);
  EXPECT_GT(sudden_there, 0);
}

}  // namespace
}  // namespace link_bounds
