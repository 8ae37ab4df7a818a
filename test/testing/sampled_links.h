// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random links of all kinds of shapes, samples of their points, and poses to move them.
#pragma once

#include <array>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/brute_force.h"
#include "testing/solid_samples.h"

namespace link_bounds {

/// More digits than the doubles that are tested.
using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongMatrix = Eigen::Matrix<long double, 3, 3>;

constexpr int kLinkSteps = 48;  ///< samples around a circle
constexpr std::array<Solid, 4> kSolids{Solid::kNone, Solid::kBox, Solid::kEllipsoid,
                                       Solid::kCylinder};

inline Shape meshShape(const std::vector<Eigen::Vector3f>& points,
                       const Eigen::Affine3d& link_from_shape = Eigen::Affine3d::Identity()) {
  return {std::make_shared<const PointSet>(points), Solid::kNone, Eigen::Vector3d::Zero(),
          link_from_shape};
}

inline Shape solidShape(Solid solid, const Eigen::Vector3d& size,
                        const Eigen::Affine3d& link_from_shape = Eigen::Affine3d::Identity()) {
  return {nullptr, solid, size, link_from_shape};
}

inline BoundedLink linkOf(const std::vector<Shape>& shapes) {
  return {"l", shapes, 0, ""};
}

/// Meshes, solids and swept points, turned and moved. Half of the links are sheared or mirrored.
inline BoundedLink randomLink(brute_force::Random& random) {
  BoundedLink link = linkOf({});
  const bool is_rigid = random.sign() > 0;
  const int count = static_cast<int>(random.uniform(1, 4));
  for (int i = 0; i < count; ++i) {
    Shape shape;
    shape.solid = kSolids[static_cast<std::size_t>(random.uniform(0, 4))];
    if (shape.solid != Solid::kNone)
      shape.size = random.vector(0.5).cwiseAbs() + Eigen::Vector3d::Constant(0.01);
    if (shape.solid == Solid::kNone || random.sign() > 0)
      shape.points = std::make_shared<const PointSet>(random.points(30, 0.5));
    shape.link_from_shape = is_rigid ? random.rigid(0.5) : random.affine(0.5);
    link.shapes.push_back(shape);
  }
  return link;
}

/// In the frame of the link: the exact vertices of meshes and boxes, and samples of curved solids.
inline std::vector<LongVector> pointsOf(const BoundedLink& link) {
  std::vector<LongVector> result;
  for (const Shape& shape : link.shapes) {
    const std::vector<Eigen::Vector3f> points =
        shape.points ? shape.points->points() : std::vector<Eigen::Vector3f>{{0, 0, 0}};
    const LongMatrix linear = shape.link_from_shape.linear().cast<long double>();
    const LongVector translation = shape.link_from_shape.translation().cast<long double>();
    for (const Eigen::Vector3d& sample : surface(shape.solid, kLinkSteps)) {
      const LongVector offset =
          sample.cast<long double>().cwiseProduct(shape.size.cast<long double>());
      for (const Eigen::Vector3f& point : points)
        result.emplace_back(linear * (point.cast<long double>() + offset) + translation);
    }
  }
  return result;
}

inline LongVector moved(const LongVector& point, const Eigen::Isometry3d& pose) {
  return pose.linear().cast<long double>() * point + pose.translation().cast<long double>();
}

inline Eigen::Isometry3d posed(const Eigen::Matrix3d& rotation,
                               const Eigen::Vector3d& translation) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = rotation;
  result.translation() = translation;
  return result;
}

/// Identity, turned by 30 and 45 degrees, and random.
inline std::vector<Eigen::Isometry3d> manyPoses(brute_force::Random& random) {
  std::vector<Eigen::Isometry3d> result{
      Eigen::Isometry3d::Identity(),
      posed(brute_force::turned(30, Eigen::Vector3d::UnitX()), {1, -2, 3}),
      posed(brute_force::turned(45, Eigen::Vector3d(1, 1, 0)), {-0.1, 0.2, 0.3})};
  for (int i = 0; i < 10; ++i)
    result.push_back(posed(random.rotation(), random.vector(random.magnitude(-3, 3))));
  return result;
}

/// How far a face of one box is outside that of another one.
inline double faceGap(const Aabb& outer, const Aabb& inner, int face) {
  return face < 3 ? inner.min()[face] - outer.min()[face]
                  : outer.max()[face - 3] - inner.max()[face - 3];
}

}  // namespace link_bounds
