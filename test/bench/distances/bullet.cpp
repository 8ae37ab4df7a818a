// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's GJK of two convex hulls, which is what it has of distances. It knows of each link the
// points of one hull, and works in single precision.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "bench/common/bullet_hull.h"
#include "bench/distances/distance_methods.h"

namespace link_bounds::bench {
namespace {

std::shared_ptr<btConvexHullShape> hullOf(const DistanceLink& link) {
  if (link.body.shapes.size() != 1 || !link.body.shapes[0].shape.points) return nullptr;
  const Shape& shape = link.body.shapes[0].shape;
  return bulletHull(shape.points->keptPoints(), shape.link_from_shape);
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
  std::vector<std::shared_ptr<btConvexHullShape>> hulls_;
  std::vector<btTransform> poses_;
};

}  // namespace

void addBulletDistances(std::vector<DistanceSetting>& settings) {
  settings.push_back({"bullet convex", "hull", [](const DistanceRobot& robot, double) {
                        return std::make_unique<BulletDistances>(robot);
                      }});
}

}  // namespace link_bounds::bench
