// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// geometric_shapes, as robot_body_filter and MoveIt ask it: for each point, each body in whose
// bounding sphere it is.
#include "bench/cloud/cloud_methods.h"
#include "bench/cloud/posed_hulls.h"
#include "bench/common/convex_mesh.h"

namespace link_bounds::bench {
namespace {

EigenSTL::vector_Vector3d pointsOf(const Body& body) {
  EigenSTL::vector_Vector3d points;
  for (const BodyShape& shape : body.shapes) {
    if (!shape.triangles) {
      for (const Eigen::Vector3d& corner :
           corners(*worldBox(shape.shape, Eigen::Affine3d::Identity())))
        points.push_back(corner);
      continue;
    }
    for (const Eigen::Vector3d& vertex : shape.triangles->vertices)
      points.push_back(shape.shape.link_from_shape * vertex);
  }
  return points;
}

}  // namespace

std::vector<PosedHull> posedHulls(const CloudScene& scene) {
  std::vector<PosedHull> posed;
  const auto stamp = static_cast<std::int64_t>(scene.cloud.header.stamp.toNSec());
  for (std::size_t i = 0; i < scene.robot->bodies.size(); ++i) {
    PosedHull body{convexMesh(pointsOf(scene.robot->bodies[i])), {}};
    if (body.body->getVertices().empty()) continue;
    body.body->setPadding(kPadding);
    const Eigen::Affine3d pose = scene.robot->linkFromSensor(i, stamp).inverse();
    Eigen::Isometry3d rigid = Eigen::Isometry3d::Identity();
    rigid.matrix() = pose.matrix();
    body.body->setPose(rigid);
    body.body->computeBoundingSphere(body.sphere);
    posed.push_back(body);
  }
  return posed;
}

LabelAll geometricShapes(const CloudScene& scene) {
  return [posed = posedHulls(scene), &scene] {
    const CloudPoints points = layoutOf(scene.cloud).points;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d place = points.position(points.point(i));
      for (const PosedHull& body : posed) {
        if (!((place - body.sphere.center).squaredNorm() <=
              body.sphere.radius * body.sphere.radius) ||
            !body.body->containsPoint(place))
          continue;
        ++count;
        break;
      }
    }
    return count;
  };
}

}  // namespace link_bounds::bench
