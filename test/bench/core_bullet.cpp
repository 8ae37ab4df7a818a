// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's btConvexHullShape over the points that can be extreme; single precision.
#include "core_suite.h"

#ifdef LINK_BOUNDS_WITH_BULLET
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

namespace link_bounds::bench {
namespace {

struct BulletBox {
  btVector3 min;
  btVector3 max;
};

struct Bullet : Method {
  std::shared_ptr<btConvexHullShape> shape = std::make_shared<btConvexHullShape>();

  explicit Bullet(const Mesh& mesh) {
    for (const Eigen::Vector3f& p : mesh.points->points())
      shape->addPoint(btVector3(p.x(), p.y(), p.z()), false);
    shape->setMargin(0);
    shape->recalcLocalAabb();
  }

  btTransform prepare(const Eigen::Affine3d& pose) const {
    btTransform result;
    const Eigen::Matrix4f matrix = pose.matrix().cast<float>();
    result.setFromOpenGLMatrix(matrix.data());
    return result;
  }
  Aabb toAabb(const BulletBox& box) const {
    return {Eigen::Vector3d(box.min.x(), box.min.y(), box.min.z()),
            Eigen::Vector3d(box.max.x(), box.max.y(), box.max.z())};
  }
  std::size_t bytes() const {
    return static_cast<std::size_t>(shape->getNumPoints()) * sizeof(btVector3);
  }
};

/// Loose: turns the box of the resting mesh.
struct BulletFast : Bullet {
  using Bullet::Bullet;
  BulletBox box(const btTransform& pose) const {
    BulletBox result;
    shape->getAabb(pose, result.min, result.max);
    return result;
  }
};

/// Exact: looks for the farthest point, axis by axis.
struct BulletSlow : Bullet {
  using Bullet::Bullet;
  BulletBox box(const btTransform& pose) const {
    BulletBox result;
    shape->getAabbSlow(pose, result.min, result.max);
    return result;
  }
};

}  // namespace

void addBullet(const Task& task) {
  addCase("bullet", task, BulletFast(task.mesh));
  addCase("bullet_slow", task, BulletSlow(task.mesh));
}

}  // namespace link_bounds::bench
#else
void link_bounds::bench::addBullet(const Task&) {}
#endif
