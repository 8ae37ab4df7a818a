// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How a way to compute boxes becomes a case. It is a type that derives from Method and has
//   using Pose, what it wants a pose as; made before the clock runs, in
//   static Pose toPose(const Eigen::Affine3d& world_from_mesh);
//   Box box(const Pose& pose), which is what is measured;
//   static Aabb toAabb(const Box& box);
//   std::size_t bytes() const, that the box is computed from; 0 if not known.
#pragma once

#include "bench/common/measured_mesh.h"
#include "bench/common/suite.h"
#include "bench/core/judgement.h"

namespace link_bounds::bench {

struct Method {
  /// Called before a series of boxes, outside of what is measured.
  void begin() {}
};

/// For those that need nothing but Eigen.
struct EigenMethod : Method {
  using Pose = Eigen::Isometry3d;
  static Pose toPose(const Eigen::Affine3d& pose) { return Pose(pose.matrix()); }
  static Aabb toAabb(const Aabb& box) { return box; }
};

/// Poses, and the exact boxes of one mesh under the first of them.
struct TruePoses {
  const Poses& poses;
  Boxes exact;
};

/// What all cases of one mesh need.
struct Trial {
  explicit Trial(const MeasuredMesh& measured)
      : mesh(measured),
        turning{turningPoses(), exactBoxes(mesh.mesh, turningPoses())},
        sliding{slidingPoses(), exactBoxes(mesh.mesh, slidingPoses())} {}

  const MeasuredMesh& mesh;
  TruePoses turning;
  TruePoses sliding;
};

/// The same poses for every mesh, in one place in memory.
template <class Method>
const std::vector<typename Method::Pose>& posesFor(const Poses& poses) {
  const auto convert = [](const Poses& source) {
    std::vector<typename Method::Pose> result;
    for (const Eigen::Affine3d& pose : source)
      result.push_back(Method::toPose(pose));
    return result;
  };
  static const auto turning = convert(turningPoses());
  static const auto sliding = convert(slidingPoses());
  return &poses == &slidingPoses() ? sliding : turning;
}

template <class Method>
Judgement judge(Method& method, const TruePoses& motion) {
  const auto& poses = posesFor<Method>(motion.poses);
  Boxes boxes;
  method.begin();
  for (std::size_t i = 0; i < kRandomPoses; ++i)
    boxes.push_back(Method::toAabb(method.box(poses[i])));
  return judge(boxes, motion.exact);
}

template <class Method>
void addCase(const std::string& name, const MeasuredMesh& mesh, const TruePoses& motion,
             Method method, Suite& suite) {
  const Judgement judgement = judge(method, motion);
  const Result result{mesh.name, mesh.kind,       mesh.mesh.vertices.size(), mesh.points->size(),
                      name,      judgement.exact, judgement.volume_ratio,    method.bytes()};
  const auto& poses = posesFor<Method>(motion.poses);
  const auto body = [method, &poses](benchmark::State& state) mutable {
    method.begin();
    std::size_t i = 0;
    for (auto _ : state) {
      auto box = method.box(poses[i]);
      benchmark::DoNotOptimize(box);
      i = (i + 1) % kPoses;
    }
  };
  const auto one_box = [method, &poses](std::size_t pose) mutable {
    auto box = method.box(poses[pose % kPoses]);
    benchmark::DoNotOptimize(box);
  };
  suite.push_back({result, body, 1, one_box});
}

}  // namespace link_bounds::bench
