// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rules that turn the box of the resting mesh and put a box around that; written from their ideas.
#include <array>

#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

Aabb restingBox(const MeasuredMesh& mesh) {
  Aabb box;
  for (const Eigen::Vector3f& vertex : mesh.mesh.vertices)
    box.extend(vertex.cast<double>());
  return box;
}

struct Corners8 : EigenMethod {
  std::array<Eigen::Vector3d, 8> corner;

  explicit Corners8(const MeasuredMesh& mesh) : corner(corners(restingBox(mesh))) {}

  Aabb box(const Pose& pose) const {
    Aabb result;
    for (const Eigen::Vector3d& point : corner)
      result.extend(pose * point);
    return result;
  }

  std::size_t bytes() const { return sizeof(corner); }
};

#if EIGEN_VERSION_AT_LEAST(3, 4, 0)
struct EigenBox : EigenMethod {
  Aabb resting;

  explicit EigenBox(const MeasuredMesh& mesh) : resting(restingBox(mesh)) {}
  Aabb box(const Pose& pose) const { return resting.transformed(pose); }
  std::size_t bytes() const { return sizeof(resting); }
};
#endif

/// MoveIt's RobotState::computeAABB moves each link's frame to the centre of the resting box and
/// there extends the result by both ends of |R| * size / 2 (extendWithTransformedBox in aabb.cpp of
/// moveit_core's robot_model).
struct MoveIt : EigenMethod {
  Eigen::Vector3d center;
  Eigen::Vector3d size;

  explicit MoveIt(const MeasuredMesh& mesh)
      : center(restingBox(mesh).center()), size(restingBox(mesh).sizes()) {}

  Aabb box(const Pose& pose) const {
    const Pose world_from_center = pose * Eigen::Translation3d(center);
    const Eigen::Vector3d reach = 0.5 * (world_from_center.linear().cwiseAbs() * size);
    Aabb result;
    result.extend(world_from_center.translation() + reach);
    result.extend(world_from_center.translation() - reach);
    return result;
  }

  std::size_t bytes() const { return sizeof(center) + sizeof(size); }
};

}  // namespace

void addLooseBoxes(const Trial& trial, Suite& suite) {
  addCase("corners8", trial.mesh, trial.turning, Corners8(trial.mesh), suite);
#if EIGEN_VERSION_AT_LEAST(3, 4, 0)
  addCase("eigen", trial.mesh, trial.turning, EigenBox(trial.mesh), suite);
#endif
  addCase("moveit", trial.mesh, trial.turning, MoveIt(trial.mesh), suite);
}

}  // namespace link_bounds::bench
