// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two samples that are too far apart in time say nothing about the speed between them.
#include "world/stopping/edge_samples.h"

#include <algorithm>

namespace link_bounds {
namespace {

constexpr double kStillRounding = 1e-9;   // m; relative for a rotation matrix
constexpr double kChainRounding = 4e-15;  // relative to a translation: about 20 rounding errors

}  // namespace

EdgeSamples edgeSamples(const TransformBuffer& tf, TransformBuffer::Frame child, std::int64_t stamp,
                        std::int64_t window) {
  EdgeSamples result;
  result.is_static = tf.isStatic(child);
  const std::string frame = "frame \"" + tf.name(child) + "\"";
  if (tf.isStaticInDoubt(child)) {
    result.problem = frame +
                     " is on /tf_static, and elsewhere on /tf, so its speed is not known; " +
                     "end one of the publishers";
    return result;
  }
  const EdgeHistory* const history = tf.history(child);
  const auto samples =
      history ? history->between(stamp - window, stamp) : std::vector<const EdgeSample*>();
  if (samples.empty() || (!result.is_static && samples.size() < 2)) {
    result.problem = "the transforms of " + frame +
                     " do not reach back for ~velocity_window yet, so its speed is not known";
    return result;
  }
  for (const EdgeSample* sample : samples) {
    Eigen::Isometry3d pose;
    if (!toIsometry(sample->parent_from_child, pose)) {
      result.problem = "a quaternion of " + frame + " is not of length 1; correct its publisher";
    } else if (sample->parent != samples.back()->parent) {
      result.problem = frame + " got another parent within ~velocity_window";
    } else if (!result.poses.empty() && sample->stamp - result.poses.back().stamp > window) {
      result.problem = "transforms of " + frame +
                       " are farther apart than ~velocity_window, so its speed is not known; "
                       "raise ~velocity_window, or send them more often";
    }
    if (!result.problem.empty()) return result;
    result.poses.push_back({sample->stamp, pose});
  }
  return result;
}

bool isStill(const std::vector<TimedPose>& poses) {
  const Eigen::Isometry3d& first = poses.front().pose;
  const double rounding = kStillRounding + kChainRounding * first.translation().norm();
  return std::all_of(poses.begin(), poses.end(), [&](const TimedPose& pose) {
    return (pose.pose.translation() - first.translation()).norm() <= rounding &&
           pose.pose.linear().isApprox(first.linear(), kStillRounding);
  });
}

std::vector<std::size_t> piecesOf(const std::vector<std::int64_t>& stamps, std::int64_t window) {
  std::vector<std::size_t> cuts{0};
  const auto is_long = [&](std::size_t from, std::size_t to) {
    return (stamps[to] - stamps[from]) * kMinPieces >= window;
  };
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    if (is_long(cuts.back(), i)) cuts.push_back(i);
  }
  if (cuts.back() + 1 == stamps.size()) return cuts;
  if (cuts.size() > 1) cuts.pop_back();
  cuts.push_back(stamps.size() - 1);
  return cuts;
}

}  // namespace link_bounds
