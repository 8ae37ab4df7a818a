// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's GJK of two convex hulls, which is what it has of distances. It knows of each link the
// points of one hull, and works in single precision.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "bench/distances/distance_methods.h"

namespace link_bounds::bench {
namespace {

std::unique_ptr<btConvexHullShape> hullOf(const DistanceLink& link) {
  if (link.body.shapes.size() != 1 || !link.body.shapes[0].shape.points) return nullptr;
  const Shape& shape = link.body.shapes[0].shape;
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Eigen::Vector3d& point : shape.points->keptPoints()) {
    const Eigen::Vector3f p = (shape.link_from_shape * point).cast<float>();
    hull->addPoint(btVector3(p.x(), p.y(), p.z()), false);
  }
  hull->recalcLocalAabb();
  hull->setMargin(0);
  return hull;
}

btTransform toBullet(const Eigen::Affine3d& pose) {
  const Eigen::Matrix4f m = pose.matrix().cast<float>();
  const btMatrix3x3 basis(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1),
                          m(2, 2));
  return btTransform(basis, btVector3(m(0, 3), m(1, 3), m(2, 3)));
}

class BulletDistances : public DistanceMethod {
 public:
  explicit BulletDistances(const DistanceRobot& robot) {
    for (const DistanceLink& link : robot.links)
      hulls_.push_back(hullOf(link));
  }

  void prepare(const LinkPoses& poses) override {
    poses_.clear();
    for (const Eigen::Affine3d& pose : poses)
      poses_.push_back(toBullet(pose));
  }

  bool has(std::size_t first, std::size_t second) const override {
    return hulls_[first] && hulls_[second];
  }

  MeasuredDistance distance(std::size_t first, std::size_t second) override {
    btVoronoiSimplexSolver simplex;
    btGjkPairDetector detector(hulls_[first].get(), hulls_[second].get(), &simplex, nullptr);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = poses_[first];
    input.m_transformB = poses_[second];
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    const double distance =
        result.m_hasResult ? std::max(0.0, static_cast<double>(result.m_distance)) : 0;
    return {distance, distance};
  }

 private:
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::vector<btTransform> poses_;
};

}  // namespace

void addBulletDistances(std::vector<DistanceSetting>& settings) {
  settings.push_back({"bullet convex", "hull", [](const DistanceRobot& robot, double) {
                        return std::make_unique<BulletDistances>(robot);
                      }});
}

}  // namespace link_bounds::bench
