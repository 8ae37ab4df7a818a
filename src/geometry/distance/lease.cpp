// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a carried bound is proven. A point p of one body is at A p + a, a point q of the other one at
// B q + b, with |A'A - 1| <= e and |B'B - 1| <= e, so that |A v| and |A'v| are |v| to within e |v|.
// With M = A'B and m = A'(b - a), the vector v between the two points has
//   A'v = M q + m - p, but for e |p|.
// From one pair of poses to another one, the right side changes by
//   (M1 - M0) q + m1 - m0,  which is at most  |(M1 - M0) c + m1 - m0| + |M1 - M0| r
// for all q within r of c. So the distance |v| of two points never shrinks by more than that, the
// motion of one body as seen from the other. A common motion of both costs nothing. M differs from
// a rotation by the two e, and the difference of two rotations stretches no vector by more than its
// Frobenius norm over sqrt(2), which is the chord of the angle between them.
//
// Let D be the sum of the four e, each at least 64u, and S the sum of Ball::farthest of both bodies
// and of the offset of their origins, then and now. No length above exceeds 4 S. The e cost
//   |v| to |A'v| and back, and e |p|                       at most 7 D S
//   M against rotations                                    2.3 D S
//   a point of the world to its body by A' and not A^-1    1.1 D S
// and the rounding of all sums and products less than D S. kSlack is 16. A point is known in the
// world, so its rounding there is added once. Along a normal that turns with the body of A, the gap
// shrinks by the same motion, so the normal of a level of boxes or hulls proves the bound as
// before. Turned with the other body it would not: where a small body turns, that tilts the normal
// against the large one.
#include "geometry/distance/lease.h"

#include <algorithm>
#include <cmath>

#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kSlack = 16;
constexpr double kMinDefect = 64 * kUnitRoundoff;
constexpr double kLargestDefect = 1e-9;  // the defect of poses of tf is below 1e-14
constexpr double kFarthest = 1e9;        // m; no square overflows

}  // namespace

std::optional<Ball> ballOf(const Body& body) {
  Aabb box;
  for (const BodyShape& body_shape : body.shapes) {
    Shape shape = body_shape.shape;
    const auto its_box = worldBox(shape, Eigen::Affine3d::Identity());
    if (!its_box) return std::nullopt;
    box.extend(*its_box);
    if (body_shape.tip) box.extend(shape.link_from_shape * *body_shape.tip);
  }
  if (box.isEmpty()) return std::nullopt;
  return Ball{box.center(), (box.max() - box.min()).norm() / 2 * (1 + 8 * kUnitRoundoff)};
}

std::optional<RigidBody> rigidBody(const Ball& ball, const Eigen::Affine3d& world_from_body) {
  const Eigen::Matrix3d axes = world_from_body.linear();
  const Eigen::Vector3d origin = world_from_body.translation();
  const Eigen::Matrix3d product = axes.transpose() * axes;
  const double defect = (product - Eigen::Matrix3d::Identity()).norm() + kMinDefect;
  const double from_origin = origin.norm();
  const bool is_small = from_origin <= kFarthest && ball.farthest <= kFarthest;
  if (!(defect <= kLargestDefect) || !is_small || axes.determinant() < 0) return std::nullopt;
  return RigidBody{ball, axes, origin, from_origin, defect};
}

PosePair::PosePair(const RigidBody& first, const RigidBody& second) {
  const RigidBody& rests = resting(first, second);
  const RigidBody& mover = &rests == &first ? second : first;
  axes.noalias() = rests.axes.transpose() * mover.axes;
  const Eigen::Vector3d offset = mover.origin - rests.origin;
  origin.noalias() = rests.axes.transpose() * offset;
  defect = first.defect + second.defect;
  size = first.ball.farthest + second.ball.farthest + offset.norm();
  rounding = 8 * kUnitRoundoff * (first.from_origin + second.from_origin + size);
}

RelativeMotion motionBetween(const PosePair& then, const PosePair& now, const RigidBody& mover) {
  RelativeMotion result;
  result.turned = now.axes - then.axes;
  result.shifted = now.origin - then.origin;
  result.slack = kSlack * (then.defect + now.defect) * (then.size + now.size) + then.rounding;
  result.approach = (result.turned * mover.ball.center + result.shifted).norm() +
                    result.turned.norm() * M_SQRT1_2 * mover.ball.radius + result.slack;
  return result;
}

Lease::Lease(const BodyDistance& found, const PosePair& now, const RigidBody& first,
             const RigidBody& second)
    : then_(now),
      lower_(found.lower),
      level_(found.level),
      on_first_(first.axes.transpose() * (found.on_first - first.origin)),
      on_second_(second.axes.transpose() * (found.on_second - second.origin)),
      normal_(resting(first, second).axes.transpose() * found.normal) {}

BodyDistance Lease::carried(const RelativeMotion& motion, const RigidBody& first,
                            const RigidBody& second) const {
  const Eigen::Vector3d from_first = first.axes * on_first_;
  const Eigen::Vector3d from_second = second.axes * on_second_;
  const Eigen::Vector3d between = (second.origin - first.origin) + (from_second - from_first);
  const double upper = length(between.x(), between.y(), between.z()) + motion.slack;
  const double lower = std::max(0.0, lower_ - motion.approach);
  BodyDistance result{std::min(lower, upper),    upper,
                      first.origin + from_first, second.origin + from_second,
                      Eigen::Vector3d::Zero(),   level_};
  if (!(result.lower > 0)) return result;
  result.normal = level_ == DistanceLevel::kMesh
                      ? between.stableNormalized()
                      : (resting(first, second).axes * normal_).stableNormalized();
  return result;
}

}  // namespace link_bounds
