// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why every lower bound in this folder is proven.
//
// Let n be a vector of doubles, which GJK or two witness points give, with | |n| - 1 | <= 4u where
// u = 2^-53. Whatever n is, no point of A is nearer to one of B than
//   (min over B of n . b  -  max over A of n . a) / |n|,
// so only the rounding of these two supports counts, never that of what found n. A shape places its
// point p at W (S p), with the poses W and S as given. Computed are
//   M = fl(W S)                 relative to |W| |S|, each entry   4u (three products, two sums,
//                                                                    one more for the translation)
//   m = fl(M' n)                                                  3u more
//   p, the point with the largest fl(m . p)                       3u more: it may lose twice 10u
//                                                                 to the best point. Of a solid
//                                                                 it is computed: twice 7u and 6u
//   n . fl(M p + t)                                               the 4u of M, and 4u + 3u
//   the difference of both supports, and |n|                      1u + 4u
// together 36u of the sum over the absolute values of all factors, which is at most
//   rho = | |W| (|S| A + |s|) |,  A the largest |coordinate|, s the translation of S,
// since |n| <= 1 to within 4u. A direction table leaves out points that others beat to within
// kTableTolerance A |m|_1 <= kTableTolerance rho, but for rounding while it was made; as much again
// covers that (kPointTolerance). The origins of the bodies are subtracted once, with an error of u
// of the difference, which then enters the last four steps. Where a capsule stands for three
// shapes, it may be wrong by 64u (capsules.cpp). kRounding is 128u: the 28u beyond those above
// cover the terms of second order and the sum of a solid and a point, which are left out there.
#include "geometry/distance/placed_body.h"

#include <algorithm>

#include "geometry/distance/capsules.h"
#include "geometry/distance/triangle_tree.h"
#include "geometry/support/table/direction_table.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kRounding = 128 * kUnitRoundoff;  // derived above

/// Max loss of products and squares of tiny numbers by underflow [m].
constexpr double kUnderflow = 1e-140;

/// Larger bodies could overflow in a product of four lengths.
constexpr double kLargest = 1e60;

double magnitudeOf(const BodyShape& body_shape) {
  const Shape& shape = body_shape.shape;
  double magnitude = shape.size.cwiseAbs().maxCoeff() / 2;
  if (shape.points) magnitude += shape.points->magnitude().maxCoeff();
  if (body_shape.triangles) magnitude = std::max(magnitude, body_shape.triangles->magnitude);
  if (body_shape.tip) magnitude = std::max(magnitude, body_shape.tip->cwiseAbs().maxCoeff());
  return magnitude;
}

/// The bound rho of the argument above.
double roundingBound(const BodyShape& shape, const Eigen::Affine3d& world_from_body) {
  const Eigen::Affine3d& link_from_shape = shape.shape.link_from_shape;
  const Eigen::Vector3d in_body =
      link_from_shape.linear().cwiseAbs() * Eigen::Vector3d::Constant(magnitudeOf(shape)) +
      link_from_shape.translation().cwiseAbs();
  const Eigen::Vector3d rho = world_from_body.linear().cwiseAbs() * in_body;
  return length(rho.x(), rho.y(), rho.z());
}

/// The box of the shape in the world.
std::optional<Aabb> boxOf(const BodyShape& shape, const Eigen::Affine3d& world_from_body) {
  std::optional<Aabb> box = worldBox(shape.shape, world_from_body);
  if (!box || !shape.tip) return box;
  Shape tip;
  tip.link_from_shape = shape.shape.link_from_shape * Eigen::Translation3d(*shape.tip);
  const std::optional<Aabb> tip_box = worldBox(tip, world_from_body);
  if (!tip_box) return std::nullopt;
  return box->merged(*tip_box);
}

/// No vector grows or shrinks by more than |M'M - 1| of its length, M being the axes of the shape
/// in the world. The rounding of M and of points is within 64u, too.
PlacedBall placedBall(const BodyShape& shape, const Eigen::Matrix3d& axes) {
  if (!hasCore(shape)) return {};
  const double radius = shape.shape.size.x() / 2;
  const double defect =
      (axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() + 64 * kUnitRoundoff;
  return {std::max(0.0, radius * (1 - defect)), radius * (1 + defect)};
}

}  // namespace

std::optional<PlacedBody> placedBody(const Body& body, const Eigen::Affine3d& world_from_body) {
  if (body.shapes.empty() || !isUsablePose(world_from_body)) return std::nullopt;
  PlacedBody result{world_from_body.translation(), {}, Aabb(), {}, 0, {}};
  if (!(result.origin.cwiseAbs().maxCoeff() <= kLargest)) return std::nullopt;
  result.shapes.reserve(body.shapes.size());
  for (const BodyShape& shape : body.shapes) {
    const std::optional<Aabb> box = boxOf(shape, world_from_body);
    const double rho = roundingBound(shape, world_from_body);
    if (!box || !(rho <= kLargest)) return std::nullopt;
    result.rounding = std::max(result.rounding, (kRounding + kPointTolerance) * rho + kUnderflow);
    const Eigen::Affine3d& link_from_shape = shape.shape.link_from_shape;
    const Placement placement{world_from_body.linear() * link_from_shape.linear(),
                              world_from_body.linear() * link_from_shape.translation()};
    result.shapes.push_back({&shape, placement, *box, placedBall(shape, placement.linear)});
    result.box.extend(*box);
  }
  const Placement& at = result.shapes[0].from_body_origin;
  result.any_point = at.toSearch(ShapeHull{body.shapes[0]}.farthest(Eigen::Vector3d::UnitX()));
  return result;
}

double pairRounding(const PlacedBody& first, const PlacedBody& second) {
  const Eigen::Vector3d offset = second.origin - first.origin;
  return first.rounding + second.rounding + kRounding * length(offset.x(), offset.y(), offset.z()) +
         kUnderflow;
}

}  // namespace link_bounds
