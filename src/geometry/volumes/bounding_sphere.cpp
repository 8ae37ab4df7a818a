// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A sphere that grows through the farthest points of the link, until no point is left outside.
//
// The smallest sphere around a set is determined by at most four of its points, and that around any
// points of the set is no larger. So: keep at most four points and the smallest sphere around them,
// find the link's point that is farthest from its centre, put it among the four, repeat. The sphere
// around that centre through the farthest point bounds the link; the two radii enclose that of the
// smallest sphere. Every shape is points swept by ellipsoids (see sweptPoints), whose farthest
// point is exact, so curved solids need no facets.
#include "link_bounds/geometry/volumes/bounding_sphere.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kTolerance = 5e-7;  ///< of the radius, when to stop
constexpr int kMostSteps = 1000;     ///< some tens are usual

/// What rounding may cost, relative to the link's magnitude. Every step below is good to some tens
/// of roundoffs; what a point set leaves out, to 2e-14.
constexpr double kPad = 2e-13;

/// Every point is the centre of an ellipsoid. Lengths are in units of the link, see unitOf.
struct SweptPoints {
  std::vector<Eigen::Vector3d> points;
  Eigen::Matrix3d semi_axes;  ///< its columns, at right angles to each other; zero: points only
};

/// A power of 2 that is about the link's magnitude, so that squares neither overflow nor vanish.
double unitOf(const BoundedLink& link) {
  const double size = magnitude(link);
  return size > 0 ? std::ldexp(1.0, std::ilogb(size)) : 1.0;
}

/// The image of the unit ball under a linear map, by its semi-axes.
Eigen::Matrix3d semiAxes(const Eigen::Matrix3d& map) {
  if (map.isZero(0)) return Eigen::Matrix3d::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(map * map.transpose());
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// The solid as a few centres and the ellipsoid around each; `half` are its half axes.
SweptPoints sweptSolid(Solid solid, const Eigen::Matrix3d& half) {
  SweptPoints result{{Eigen::Vector3d::Zero()}, Eigen::Matrix3d::Zero()};
  if (solid == Solid::kBox) {
    result.points.clear();
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      result.points.emplace_back(half * corner);
    }
  } else if (solid == Solid::kEllipsoid) {
    result.semi_axes = semiAxes(half);
  } else if (solid == Solid::kCylinder) {
    result.points = {half.col(2), -half.col(2)};
    result.semi_axes = semiAxes(half * Eigen::Vector3d(1, 1, 0).asDiagonal());
  }
  return result;
}

SweptPoints sweptPoints(const Shape& shape, double unit) {
  const Eigen::Affine3d& pose = shape.link_from_shape;
  const SweptPoints solid =
      sweptSolid(shape.solid, pose.linear() * shape.size.asDiagonal() / 2 / unit);
  SweptPoints result{{}, solid.semi_axes};
  const auto add = [&](const Eigen::Vector3d& point) {
    for (const Eigen::Vector3d& center : solid.points)
      result.points.emplace_back((pose * point) / unit + center);
  };
  if (!shape.points) add(Eigen::Vector3d::Zero());
  if (!shape.points) return result;
  for (const Eigen::Vector3d& point : shape.points->keptPoints())
    add(point);
  return result;
}

struct Farthest {
  Eigen::Vector3d point;
  double distance = -1;  ///< not below the real one, but for rounding
};

/// The point of an ellipsoid, centred at `offset`, that is farthest from the origin. With the
/// semi-axes w_i, point = offset + sum u_i w_i and g_i = w_i . offset, this maximises the convex
/// |offset|^2 + 2 g . u + sum |w_i|^2 u_i^2 over |u| <= 1. For any l > |w_i|^2 the maximum is at
/// most |offset|^2 + l + sum g_i^2 / (l - |w_i|^2), by duality, and equal where
/// u_i = g_i / (l - |w_i|^2) has length 1.
Farthest farthestOfEllipsoid(const Eigen::Vector3d& offset, const Eigen::Matrix3d& semi_axes) {
  const Eigen::Array3d square = semi_axes.colwise().squaredNorm();
  const Eigen::Array3d g = semi_axes.transpose() * offset;
  const auto coordinates = [&](double l) -> Eigen::Array3d {
    return (g == 0).select(0.0, g / (l - square));
  };
  double low = square.maxCoeff();
  double high = nextUp(low + g.matrix().norm());
  for (double l = (low + high) / 2; low < l && l < high; l = (low + high) / 2)
    (coordinates(l).square().sum() > 1 ? low : high) = l;
  Eigen::Array3d u = coordinates(high);
  const double bound = offset.squaredNorm() + high + (g * u).sum();
  // Where g vanishes along the longest axis, u falls short and both ends of it are as far.
  int longest = 0;
  square.maxCoeff(&longest);
  const double rest = u.square().sum() - u[longest] * u[longest];
  u[longest] = std::copysign(std::sqrt(std::max(0.0, 1 - rest)), g[longest]);
  return {offset + semi_axes * u.matrix(), std::sqrt(bound)};
}

/// Of all points of the link.
Farthest farthestFrom(const Eigen::Vector3d& center, const std::vector<SweptPoints>& link) {
  Farthest result;
  for (const SweptPoints& swept : link) {
    const bool is_swept = !swept.semi_axes.isZero(0);
    for (const Eigen::Vector3d& point : swept.points) {
      const Eigen::Vector3d offset = point - center;
      const Farthest found =
          is_swept ? farthestOfEllipsoid(offset, swept.semi_axes) : Farthest{offset, offset.norm()};
      if (found.distance > result.distance) result = found;
    }
  }
  result.point += center;
  return result;
}

/// The smallest sphere with all points on its surface, where there is one.
BoundingSphere throughPoints(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() == 1) return {points[0], 0};
  const Eigen::Index count = static_cast<Eigen::Index>(points.size()) - 1;
  Eigen::MatrixXd edges(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    edges.row(i) = points[static_cast<std::size_t>(i) + 1] - points[0];
  // The shortest solution, which lies in the plane of the points.
  const Eigen::Vector3d center = edges.completeOrthogonalDecomposition().solve(
      Eigen::VectorXd(edges.rowwise().squaredNorm() / 2));
  return {points[0] + center, center.norm()};
}

bool contains(const BoundingSphere& sphere, const std::vector<Eigen::Vector3d>& points) {
  constexpr double kSlack = 1e-12;
  for (const Eigen::Vector3d& point : points) {
    if (!((point - sphere.center).norm() <= sphere.radius + kSlack)) return false;
  }
  return true;
}

/// The smallest sphere around some points, and those on it.
struct Inner {
  BoundingSphere sphere;
  std::vector<Eigen::Vector3d> points;  ///< at most four
};

/// The smallest sphere around the points of `inner` and a point outside of it, which then lies on
/// the new one. Tries every choice of the other points on it.
Inner grown(const Inner& inner, const Eigen::Vector3d& point) {
  std::vector<Eigen::Vector3d> all = inner.points;
  all.push_back(point);
  Inner best{{point, std::numeric_limits<double>::infinity()}, {}};
  for (unsigned choice = 0; choice < 1u << inner.points.size(); ++choice) {
    std::vector<Eigen::Vector3d> points{point};
    for (std::size_t i = 0; i < inner.points.size(); ++i) {
      if (choice & 1u << i) points.push_back(inner.points[i]);
    }
    if (points.size() > 4) continue;
    const BoundingSphere sphere = throughPoints(points);
    if (sphere.radius < best.sphere.radius && contains(sphere, all)) best = {sphere, points};
  }
  return best;
}

BoundingSphere smallestSphere(const std::vector<SweptPoints>& link, const Eigen::Vector3d& start) {
  Inner inner{{start, 0}, {}};
  BoundingSphere best{start, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < kMostSteps; ++step) {
    const Farthest farthest = farthestFrom(inner.sphere.center, link);
    if (farthest.distance < best.radius) best = {inner.sphere.center, farthest.distance};
    if (best.radius <= inner.sphere.radius * (1 + kTolerance)) break;
    const Inner next = grown(inner, farthest.point);
    // Rounding can end the growth early; the best sphere so far bounds the link all the same.
    if (!std::isfinite(next.sphere.radius)) break;
    if (step > 0 && next.sphere.radius <= inner.sphere.radius) break;
    inner = next;
  }
  return best;
}

std::optional<BoundingSphere> ifFinite(const BoundingSphere& sphere) {
  if (!sphere.center.allFinite() || !std::isfinite(sphere.radius)) return std::nullopt;
  return sphere;
}

}  // namespace

std::optional<BoundingSphere> boundingSphere(const BoundedLink& link) {
  const std::optional<Aabb> box = linkBox(link, Eigen::Affine3d::Identity());
  if (!box) return std::nullopt;
  const double unit = unitOf(link);
  std::vector<SweptPoints> swept;
  for (const Shape& shape : link.shapes)
    swept.push_back(sweptPoints(shape, unit));
  const BoundingSphere sphere = smallestSphere(swept, toCenterRadius(*box).center / unit);
  const double radius = (sphere.radius + kPad) * unit;
  return ifFinite({sphere.center * unit, addUp(radius, link.padding)});
}

std::optional<BoundingSphere> placed(const BoundingSphere& sphere,
                                     const Eigen::Isometry3d& world_from_link) {
  constexpr double kRoundingPad = 16 * kUnitRoundoff;
  const Eigen::Matrix3d linear = world_from_link.linear();
  const Eigen::Vector3d translation = world_from_link.translation();
  // Lengths grow at most by the root of 1 + deviation, which is 0 for a rotation.
  const double deviation =
      (linear.transpose() * linear - Eigen::Matrix3d::Identity()).cwiseAbs().sum();
  const double radius = (1 + deviation / 2) * sphere.radius;
  const double reach =
      (linear.cwiseAbs() * sphere.center.cwiseAbs() + translation.cwiseAbs()).sum();
  const double pad = kRoundingPad * (radius + reach) + std::numeric_limits<double>::min();
  return ifFinite({linear * sphere.center + translation, radius + pad});
}

}  // namespace link_bounds
