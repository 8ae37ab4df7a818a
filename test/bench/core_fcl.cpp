// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// FCL: the box a collision object keeps, and the box of a convex shape.
#include "core_suite.h"

#ifdef LINK_BOUNDS_WITH_FCL
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/collision_object.h>

namespace link_bounds::bench {
namespace {

using FclPoints = std::vector<fcl::Vector3d>;

/// Bounding needs no faces, so there is but one.
std::shared_ptr<fcl::Convexd> makeConvex(const Mesh& mesh) {
  auto points = std::make_shared<FclPoints>();
  for (const Eigen::Vector3f& point : mesh.points->points())
    points->push_back(point.cast<double>());
  return std::make_shared<fcl::Convexd>(
      points, 1, std::make_shared<std::vector<int>>(std::vector{3, 0, 1, 2}));
}

struct Fcl : Method {
  std::shared_ptr<fcl::Convexd> convex;

  explicit Fcl(const Mesh& mesh) : convex(makeConvex(mesh)) {}
  fcl::Transform3d prepare(const Eigen::Affine3d& pose) const {
    return fcl::Transform3d(pose.matrix());
  }
  Aabb toAabb(const fcl::AABBd& box) const { return {box.min_, box.max_}; }
  std::size_t bytes() const { return convex->getVertices().size() * sizeof(fcl::Vector3d); }
};

/// Loose: a cube around the circumscribed sphere.
struct FclObject : Fcl {
  std::shared_ptr<fcl::CollisionObjectd> object;

  explicit FclObject(const Mesh& mesh)
      : Fcl(mesh), object(std::make_shared<fcl::CollisionObjectd>(convex)) {}
  fcl::AABBd box(const fcl::Transform3d& pose) const {
    object->setTransform(pose);
    object->computeAABB();
    return object->getAABB();
  }
};

/// Exact: all vertices.
struct FclExact : Fcl {
  using Fcl::Fcl;
  fcl::AABBd box(const fcl::Transform3d& pose) const {
    fcl::AABBd result;
    fcl::computeBV(*convex, pose, result);
    return result;
  }
};

}  // namespace

void addFcl(const Task& task) {
  addCase("fcl", task, FclObject(task.mesh));
  addCase("fcl_exact", task, FclExact(task.mesh));
}

}  // namespace link_bounds::bench
#else
void link_bounds::bench::addFcl(const Task&) {}
#endif
