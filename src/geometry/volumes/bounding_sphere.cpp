// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Grows a sphere through the farthest points of the link until no point is outside.
//
// At most four points of a set determine the smallest sphere around it, and the smallest sphere
// around some points of the set is no larger. So the search keeps at most four points and the
// smallest sphere around these. It finds the point of the link that is farthest from the centre,
// puts it among the four, and repeats. The sphere about that centre through the farthest point
// bounds the link. The radius of the smallest sphere lies between the two radii.
//
// A shape is a set of points, each the centre of an ellipsoid (see SweptPoints). The farthest point
// of an ellipsoid is computed, so curved solids need no facets.
#include "link_bounds/geometry/volumes/bounding_sphere.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kTolerance = 5e-7;  ///< of the radius; half of what the header promises
constexpr int kMaxSteps = 1000;      ///< typically some tens
constexpr double kFlat = 1e-12;  ///< of an edge's length: so near to the line or plane of others, a
                                 ///< point is skipped

/// Against rounding, relative to the link's magnitude. Each step of the computation is exact to
/// some tens of roundoffs (1e-16). Points that a point set leaves out are outside by at most 2e-14.
constexpr double kSpherePad = 2e-13;

/// An ellipsoid around each point. Lengths are in the unit of the link, see unitOf().
struct SweptPoints {
  std::vector<Eigen::Vector3d> points;
  Eigen::Matrix3d semi_axes;  ///< in columns, perpendicular to each other; zero: only the points
};

/// A power of 2 near the link's magnitude. In this unit, squares neither overflow nor underflow.
double unitOf(const BoundedLink& link) {
  const double size = magnitude(link);
  return size > 0 ? std::ldexp(1.0, std::ilogb(size)) : 1.0;
}

/// The semi-axes of the ellipsoid that a linear map makes of the unit ball.
Eigen::Matrix3d semiAxes(const Eigen::Matrix3d& map) {
  if (map.isZero(0)) return Eigen::Matrix3d::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(map * map.transpose());
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// A solid as ellipsoids around a few points: a box has only its corners, a cylinder has a disc at
/// each end. The columns of `half` are the half axes of the solid.
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
  double distance = -1;  ///< no smaller than the true one, except for rounding
};

/// The point of an ellipsoid that is farthest from the origin. The centre is `offset`, and w_i are
/// the semi-axes. The point is offset + sum u_i w_i, where u maximises
///   |offset|^2 + 2 g . u + sum |w_i|^2 u_i^2    for |u| <= 1, with g_i = w_i . offset.
/// This is a trust region problem (Conn, Gould, Toint, Trust Region Methods, 2000, chapter 7). For
/// each l > max |w_i|^2 its dual bounds the maximum by |offset|^2 + l + sum g_i^2 / (l - |w_i|^2).
/// The bound is attained where u_i = g_i / (l - |w_i|^2) has length 1; bisection finds that l.
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
  // If g is 0 along the longest axis, u may be shorter than 1. Both ends of the axis are then
  // equally far.
  int longest = 0;
  square.maxCoeff(&longest);
  const double rest = u.square().sum() - u[longest] * u[longest];
  u[longest] = std::copysign(std::sqrt(std::max(0.0, 1 - rest)), g[longest]);
  return {offset + semi_axes * u.matrix(), std::sqrt(bound)};
}

/// The point of the link that is farthest from `center`.
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

/// The smallest sphere through up to four points, if there is one. Its centre lies in their plane,
/// and is found along perpendicular directions: to the point that is farthest from the first one,
/// to the one that is farthest from that line, and to the last one. Twice projected, directions are
/// perpendicular up to rounding.
BoundingSphere throughPoints(const std::vector<Eigen::Vector3d>& points) {
  std::array<Eigen::Vector3d, 3> edges, directions;
  const std::size_t count = points.size() - 1;
  for (std::size_t i = 0; i < count; ++i)
    edges[i] = points[i + 1] - points[0];
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (std::size_t done = 0; done < count; ++done) {
    double farthest = -1;
    for (std::size_t i = done; i < count; ++i) {
      Eigen::Vector3d rest = edges[i];
      for (std::size_t pass = 0; pass < 2 * done; ++pass)
        rest -= rest.dot(directions[pass % done]) * directions[pass % done];
      if (rest.norm() <= farthest) continue;
      farthest = rest.norm();
      directions[done] = rest.normalized();
      std::swap(edges[done], edges[i]);
    }
    const Eigen::Vector3d& edge = edges[done];
    const double along = edge.dot(directions[done]);
    if (!(along > kFlat * edge.norm())) break;
    center += (edge.squaredNorm() / 2 - edge.dot(center)) / along * directions[done];
  }
  return {points[0] + center, center.norm()};
}

bool contains(const BoundingSphere& sphere, const std::vector<Eigen::Vector3d>& points) {
  // More than rounding, in the unit of the link. It decides only which centre is tried next.
  constexpr double kSlack = 1e-12;
  for (const Eigen::Vector3d& point : points) {
    if (!((point - sphere.center).norm() <= sphere.radius + kSlack)) return false;
  }
  return true;
}

/// The smallest sphere around at most four points, all of which lie on it.
struct Inner {
  BoundingSphere sphere;
  std::vector<Eigen::Vector3d> points;
};

/// The smallest sphere around the points of `inner` and a point outside of it. That point lies on
/// the new sphere. Which of the others do is found by trying every choice.
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
  for (int step = 0; step < kMaxSteps; ++step) {
    const Farthest farthest = farthestFrom(inner.sphere.center, link);
    if (farthest.distance < best.radius) best = {inner.sphere.center, farthest.distance};
    if (best.radius <= inner.sphere.radius * (1 + kTolerance)) break;
    const Inner next = grown(inner, farthest.point);
    // Rounding can end the growth early. The best sphere so far bounds the link nevertheless.
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
  const double radius = (sphere.radius + kSpherePad) * unit;
  return ifFinite({sphere.center * unit, addUp(radius, link.padding)});
}

std::optional<BoundingSphere> placed(const BoundingSphere& sphere,
                                     const Eigen::Isometry3d& world_from_link) {
  // The radius is off by less than 9 roundoffs, each coordinate of the centre by 4 of its terms.
  constexpr double kPlacedPad = 16 * kUnitRoundoff;
  const Eigen::Matrix3d linear = world_from_link.linear();
  const Eigen::Vector3d translation = world_from_link.translation();
  // Lengths grow at most by the factor sqrt(1 + deviation). A rotation has deviation 0.
  const double deviation =
      (linear.transpose() * linear - Eigen::Matrix3d::Identity()).cwiseAbs().sum();
  const double radius = (1 + deviation / 2) * sphere.radius;
  const double magnitude =
      (linear.cwiseAbs() * sphere.center.cwiseAbs() + translation.cwiseAbs()).sum();
  const double pad = kPlacedPad * (radius + magnitude) + std::numeric_limits<double>::min();
  return ifFinite({linear * sphere.center + translation, radius + pad});
}

}  // namespace link_bounds
