// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's convex hulls and poses, in single precision, as Debian has it.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <Eigen/Geometry>
#include <memory>

namespace link_bounds::bench {

/// Of points that are moved by the pose.
template <class Points>
std::shared_ptr<btConvexHullShape> bulletHull(const Points& points, const Eigen::Affine3d& pose) {
  auto hull = std::make_shared<btConvexHullShape>();
  for (const auto& point : points) {
    const Eigen::Vector3f moved = (pose * point.template cast<double>()).template cast<float>();
    hull->addPoint(btVector3(moved.x(), moved.y(), moved.z()), false);
  }
  hull->setMargin(0);
  hull->recalcLocalAabb();
  return hull;
}

inline btTransform toBullet(const Eigen::Affine3d& pose) {
  const Eigen::Matrix<btScalar, 4, 4> matrix = pose.matrix().cast<btScalar>();
  btTransform result;
  result.setFromOpenGLMatrix(matrix.data());
  return result;
}

}  // namespace link_bounds::bench
