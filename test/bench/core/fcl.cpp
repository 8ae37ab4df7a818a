// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// FCL's convex shape over the points that can be extreme.
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/collision_object.h>

#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

/// Without faces: of those no box is computed.
std::shared_ptr<fcl::Convexd> makeConvex(const MeasuredMesh& mesh) {
  auto points = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Eigen::Vector3f& point : mesh.points->points())
    points->push_back(point.cast<double>());
  return std::make_shared<fcl::Convexd>(points, 0, std::make_shared<std::vector<int>>());
}

struct FclMethod : EigenMethod {
  static Aabb toAabb(const fcl::AABBd& box) { return {box.min_, box.max_}; }
};

/// A cube around the sphere around the resting box.
struct FclObject : FclMethod {
  std::shared_ptr<fcl::CollisionObjectd> object;

  explicit FclObject(const MeasuredMesh& mesh)
      : object(std::make_shared<fcl::CollisionObjectd>(makeConvex(mesh))) {}

  fcl::AABBd box(const Pose& pose) const {
    object->setTransform(pose);
    object->computeAABB();
    return object->getAABB();
  }

  std::size_t bytes() const { return 4 * sizeof(double); }
};

/// All points.
struct FclExact : FclMethod {
  std::shared_ptr<fcl::Convexd> convex;

  explicit FclExact(const MeasuredMesh& mesh) : convex(makeConvex(mesh)) {}

  fcl::AABBd box(const Pose& pose) const {
    fcl::AABBd result;
    fcl::computeBV(*convex, pose, result);
    return result;
  }

  std::size_t bytes() const { return convex->getVertices().size() * sizeof(fcl::Vector3d); }
};

}  // namespace

void addFcl(const Trial& trial, Suite& suite) {
  addCase("fcl", trial.mesh, trial.turning, FclObject(trial.mesh), suite);
  addCase("fcl_exact", trial.mesh, trial.turning, FclExact(trial.mesh), suite);
}

}  // namespace link_bounds::bench
