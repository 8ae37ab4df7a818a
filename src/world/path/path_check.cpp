// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/path/path_check.h"

#include <cmath>
#include <utility>

#include "robot/urdf/simple_joints.h"

namespace link_bounds {
static_assert(PathSegment::SAFE == static_cast<int>(PathVerdict::kSafe));
static_assert(PathSegment::COLLIDES == static_cast<int>(PathVerdict::kCollides));
static_assert(PathSegment::UNDECIDED == static_cast<int>(PathVerdict::kUndecided));

PathCheck::PathCheck(PastScene& scene, CheckPath::Request& request, const PathTrees& trees,
                     const PathLimits& limits)
    : joints_(plannedJoints(withSimpleJoints(*scene.model->robot), request.trajectory)),
      scene_(pathScene(scene, joints_, trees, limits)),
      trajectory_(scene_.robot, joints_, std::move(request.trajectory)),
      ranges_(trajectory_.ranges()),
      prover_(scene_.robot, scene_.bodies, scene_.pairs, ranges_, {request.clearance}) {
  for (const std::size_t joint : trajectory_.joints())
    response_.joint_names.push_back(scene_.robot.joints[joint].name);
  response_.incomplete = scene_.incomplete;
  response_.segments.reserve(trajectory_.segments());
}

bool PathCheck::proceed(std::chrono::nanoseconds budget, const std::function<bool()>& is_over) {
  const auto end = std::chrono::steady_clock::now() + budget;
  while (response_.segments.size() < trajectory_.segments()) {
    proveNext(is_over);
    if (std::chrono::steady_clock::now() >= end) break;
  }
  return response_.segments.size() == trajectory_.segments();
}

void PathCheck::proveNext(const std::function<bool()>& is_over) {
  PathSegment segment;
  segment.start = static_cast<std::uint32_t>(response_.segments.size());
  SegmentProof proof;
  const JointMotion motion = trajectory_.motion(segment.start);
  if (!is_over()) proof = prover_.prove(motion, is_over);
  segment.verdict = static_cast<std::uint8_t>(proof.verdict);
  segment.clearance = proof.clearance;
  segment.nearest = proof.nearest;
  if (std::isfinite(proof.nearest)) {
    segment.first = scene_.names[proof.first];
    segment.second = scene_.names[proof.second];
    segment.at = proof.share;
    const std::vector<double> values = motion.at(proof.share);
    for (const std::size_t joint : trajectory_.joints())
      segment.pose.push_back(values[joint]);
  }
  if (segment.verdict == PathSegment::UNDECIDED && undecided_++ == 0) {
    response_.message =
        "the segment from points[" + std::to_string(segment.start) + "] on is not decided: ";
    response_.message +=
        scene_.pairs.empty()         ? "the trajectory moves no pair of bodies"
        : !scene_.incomplete.empty() ? scene_.problem
        : is_over()
            ? "the 10 s of a request were over; send fewer points"
            : "a contact grazes, triangles are missing, or it is too long; send points between";
  }
  response_.segments.push_back(std::move(segment));
}

CheckPath::Response PathCheck::take() {
  if (undecided_ > 1)
    response_.message += "; not decided are " + std::to_string(undecided_ - 1) + " more";
  response_.success = true;
  return std::move(response_);
}

}  // namespace link_bounds
