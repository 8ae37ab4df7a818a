// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's convex hull over the points that can be extreme.
#include "bench/common/bullet_hull.h"
#include "bench/core/methods.h"

namespace link_bounds::bench {
namespace {

struct BulletBox {
  btVector3 min;
  btVector3 max;
};

Eigen::Vector3d toEigen(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

struct Bullet : Method {
  using Pose = btTransform;
  std::shared_ptr<btConvexHullShape> shape;

  explicit Bullet(const MeasuredMesh& mesh)
      : shape(bulletHull(mesh.points->points(), Eigen::Affine3d::Identity())) {}

  static Pose toPose(const Eigen::Affine3d& pose) { return toBullet(pose); }
  static Aabb toAabb(const BulletBox& box) { return {toEigen(box.min), toEigen(box.max)}; }
};

/// Turns the box of the resting hull.
struct BulletFast : Bullet {
  using Bullet::Bullet;

  BulletBox box(const Pose& pose) const {
    BulletBox result;
    shape->getAabb(pose, result.min, result.max);
    return result;
  }

  std::size_t bytes() const { return sizeof(BulletBox); }
};

/// Looks for the farthest points of the hull along each axis.
struct BulletSlow : Bullet {
  using Bullet::Bullet;

  BulletBox box(const Pose& pose) const {
    BulletBox result;
    shape->getAabbSlow(pose, result.min, result.max);
    return result;
  }

  std::size_t bytes() const {
    return static_cast<std::size_t>(shape->getNumPoints()) * sizeof(btVector3);
  }
};

}  // namespace

void addBullet(const Trial& trial, Suite& suite) {
  addCase("bullet", trial.mesh, trial.turning, BulletFast(trial.mesh), suite);
  addCase("bullet_slow", trial.mesh, trial.turning, BulletSlow(trial.mesh), suite);
}

}  // namespace link_bounds::bench
