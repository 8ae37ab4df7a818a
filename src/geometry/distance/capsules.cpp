// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The end of the cylinder's axis is computed with an error of at most 8u of the largest coordinate,
// and the centre of its ball may be as far from there. Let M be the axes of a shape: no entry of
// M'M - 1 exceeds 32u, so M changes a length by at most 48u of it. So no point of the three shapes
// is farther than 64u from the capsule between the two centres, and no point of the capsule is
// farther than that from the shapes.
#include "geometry/distance/capsules.h"

#include <algorithm>

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kPlaceTolerance = 8 * kUnitRoundoff;
constexpr double kRigidTolerance = 32 * kUnitRoundoff;

/// A body of more shapes is left as it is: each cylinder is compared with every shape.
constexpr std::size_t kMaxShapes = 64;

bool isBareSolid(const BodyShape& body_shape, Solid solid) {
  return body_shape.shape.solid == solid && !body_shape.shape.points && !body_shape.triangles &&
         !body_shape.tip;
}

bool isBall(const BodyShape& body_shape) {
  const Eigen::Vector3d& size = body_shape.shape.size;
  return isBareSolid(body_shape, Solid::kEllipsoid) && size.x() > 0 && size.x() == size.y() &&
         size.x() == size.z();
}

bool isRoundCylinder(const BodyShape& body_shape) {
  const Eigen::Vector3d& size = body_shape.shape.size;
  return isBareSolid(body_shape, Solid::kCylinder) && size.x() > 0 && size.x() == size.y() &&
         size.z() > 0;
}

/// True for a rotation with a translation, up to rounding.
bool isRigid(const Eigen::Affine3d& pose) {
  const Eigen::Matrix3d axes = pose.linear();
  return ((axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().array() <=
          kRigidTolerance)
      .all();
}

/// True for a ball with that diameter and, up to rounding, its centre at `place`.
bool isBallAt(const BodyShape& body_shape, double diameter, const Eigen::Vector3d& place) {
  if (!isBall(body_shape) || body_shape.shape.size.x() != diameter) return false;
  const Eigen::Affine3d& pose = body_shape.shape.link_from_shape;
  const Eigen::Vector3d center = pose.translation();
  const double magnitude =
      std::max({center.cwiseAbs().maxCoeff(), place.cwiseAbs().maxCoeff(), diameter});
  return isRigid(pose) && (center - place).cwiseAbs().maxCoeff() <= kPlaceTolerance * magnitude;
}

BodyShape capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double diameter) {
  BodyShape result;
  result.shape.solid = Solid::kEllipsoid;
  result.shape.size.setConstant(diameter);
  const auto ends = std::make_shared<std::array<double, 6>>();
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(ends->data()) << a, b;
  result.shape.points =
      std::make_shared<PointSet>(std::shared_ptr<const double>(ends, ends->data()), 2);
  result.triangles = triangleTree({a, b}, {{0, 1, 1}});
  return result;
}

/// If the cylinder at `index` has a ball at each end, replaces the three shapes by a capsule.
bool merge(std::vector<BodyShape>& shapes, std::size_t index) {
  const Shape& cylinder = shapes[index].shape;
  if (!isRoundCylinder(shapes[index]) || !isRigid(cylinder.link_from_shape)) return false;
  std::array<std::size_t, 2> balls{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double side = k == 0 ? -0.5 : 0.5;
    const Eigen::Vector3d end =
        cylinder.link_from_shape * Eigen::Vector3d(0, 0, side * cylinder.size.z());
    const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const BodyShape& shape) {
      return isBallAt(shape, cylinder.size.x(), end);
    });
    if (found == shapes.end()) return false;
    balls[k] = static_cast<std::size_t>(found - shapes.begin());
  }
  const BodyShape merged =
      capsule(shapes[balls[0]].shape.link_from_shape.translation(),
              shapes[balls[1]].shape.link_from_shape.translation(), cylinder.size.x());
  if (balls[0] == balls[1] || !merged.triangles) return false;
  shapes[index] = merged;
  shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(std::max(balls[0], balls[1])));
  shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(std::min(balls[0], balls[1])));
  return true;
}

}  // namespace

std::shared_ptr<const Body> withCores(std::shared_ptr<const Body> body) {
  if (!body || body->shapes.size() > kMaxShapes) return body;
  if (std::none_of(body->shapes.begin(), body->shapes.end(), isBall)) return body;
  std::vector<BodyShape> shapes = body->shapes;
  for (std::size_t i = 0; i < shapes.size();)
    i = merge(shapes, i) ? 0 : i + 1;
  for (BodyShape& shape : shapes) {
    if (isBall(shape) && isRigid(shape.shape.link_from_shape))
      shape.triangles = triangleTree({Eigen::Vector3d::Zero()}, {{0, 0, 0}});
  }
  return std::make_shared<Body>(Body{std::move(shapes)});
}

bool hasCore(const BodyShape& shape) {
  return shape.shape.solid == Solid::kEllipsoid && shape.triangles &&
         shape.triangles->solid == Solid::kNone;
}

}  // namespace link_bounds
