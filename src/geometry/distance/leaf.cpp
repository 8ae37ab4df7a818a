// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a gap in floats proves a distance. Let v = 2^-24, and S the sum of both leaves' sizes and of
// the largest coordinate of the vector between their centres. A corner p is at L (p - c) from the
// centre c of its node's box. The half edges of the box add up to at least |p - c|, coordinate by
// coordinate, so no sum of the absolute values of the factors of L (p - c) exceeds the leaf's size.
// Let n be a vector of floats. A gap consists of three dot products with n: of a corner of either
// leaf and of the vector between the centres. Together they are wrong by
//   5 v S |n|_1  in the coordinates: p - c, L, a product and two sums
//   3 v S |n|_1  for a product and two sums
//   2 v S |n|_1  for the two sums that make the gap of them,
// which is less than 18 v S |n|. The length of n differs from 1 by less than 8 v: three products,
// two sums, a root, a quotient and a product. Thus
//   gap (1 - 2^-19) - 2^-19 S,  that is gap (1 - 32 v) - 32 v S,
// is no more than the distance along n / |n|; what is left covers the terms of second order. So n
// need not be exactly normal to its triangle, for example if that is thin: the gap counts the
// corners of both triangles. kFloatUnderflow covers the digits that tiny floats lose. `rounding`
// bounds the rounding of doubles in a search (placed_body.cpp); that of the two centres adds less
// than as much again.
#include "geometry/distance/leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace link_bounds {
namespace {

constexpr double kPad = 0x1p-19;  // both are derived above
constexpr double kShare = 1 - 0x1p-19;

constexpr double kFloatUnderflow = 1e-34;  // m

/// Max length [m] and scale: squares of areas stay finite in floats.
constexpr double kLargestLeaf = 1e8;

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// Shorter normals, those of tiny or thin triangles, lose digits in their squares [m^2].
constexpr float kShortestNormal = 1e-15f;

PlacedLeaf::Vectors difference(const PlacedLeaf::Vectors& a, const PlacedLeaf::Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

PlacedLeaf::Vectors turned(const Eigen::Matrix3f& by, const PlacedLeaf::Vectors& v) {
  return {v.dot(by.row(0)), v.dot(by.row(1)), v.dot(by.row(2))};
}

/// Zero for a triangle without a normal.
PlacedLeaf::Vectors unitNormals(const std::array<PlacedLeaf::Vectors, 3>& corners) {
  const PlacedLeaf::Vectors a = difference(corners[1], corners[0]);
  const PlacedLeaf::Vectors b = difference(corners[2], corners[0]);
  const PlacedLeaf::Vectors across{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                   a.x * b.y - a.y * b.x};
  // Not Eigen's root, which is an estimate that depends on the processor.
  const Lanes length =
      across.dot(across).unaryExpr([](float squared) { return std::sqrt(squared); });
  const Lanes inverse = (length > kShortestNormal).select(1 / length, Lanes::Zero());
  return {across.x * inverse, across.y * inverse, across.z * inverse};
}

/// Minus infinity in the first `count` lanes; infinity in the others, which have no triangle, so
/// that these are never open.
Eigen::Map<const Lanes> lanesBeyond(std::uint32_t count) {
  static constexpr std::size_t kLanes = kTrianglesPerLeaf;
  static const Eigen::Array<float, 2 * kLanes, 1> kBoth =
      (Eigen::Array<float, 2 * kLanes, 1>() << Lanes::Constant(-kInfinite),
       Lanes::Constant(kInfinite))
          .finished();
  return Eigen::Map<const Lanes>(kBoth.data() + (kLanes - count));
}

}  // namespace

void PlacedLeaf::place(const TriangleTree& tree, std::uint32_t node, const Placement& at) {
  first = tree.nodes[node].first;
  count = tree.nodes[node].count;
  const Parallelepiped box = tree.nodes[node].box();
  center = at.toSearch(box.center);
  const Eigen::Vector3d half =
      box.edges[0].cwiseAbs() + box.edges[1].cwiseAbs() + box.edges[2].cwiseAbs();
  const Eigen::Matrix3d linear = at.linear.cwiseAbs();
  size = (linear * half).maxCoeff();
  if (!(std::max({size, half.maxCoeff(), linear.maxCoeff()}) <= kLargestLeaf)) {
    size = std::numeric_limits<double>::infinity();
    return;
  }
  for (std::uint32_t i = 0; i < kTrianglesPerLeaf; ++i) {
    const auto& triangle = tree.triangles[first + std::min(i, count - 1)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& corner = tree.vertices[triangle[k]];
      const Eigen::Vector3f from_center = (corner - box.center).cast<float>();
      corners[k].x[i] = from_center.x();
      corners[k].y[i] = from_center.y();
      corners[k].z[i] = from_center.z();
    }
  }
  const Eigen::Matrix3f axes = at.linear.cast<float>();
  for (Vectors& corner : corners)
    corner = turned(axes, corner);
  normals = unitNormals(corners);
  const Lanes a = normals.dot(corners[0]), b = normals.dot(corners[1]), c = normals.dot(corners[2]);
  low = a.min(b).min(c);
  high = a.max(b).max(c);
}

LeafGaps::LeafGaps(const PlacedLeaf& first, const PlacedLeaf& second, double rounding,
                   const Eigen::Vector3d& first_to_second)
    : first_(first), second_(second) {
  const Eigen::Vector3d between = second.center - first.center;
  const double size = first.size + second.size + between.cwiseAbs().maxCoeff();
  pad_ = kPad * size + 2 * rounding + kFloatUnderflow;
  is_small_ = size <= kLargestLeaf;
  if (is_small_) between_ = between.cast<float>();
  const Eigen::Map<const Lanes> beyond = lanesBeyond(second.count);
  for (std::uint32_t i = 0; i < first.count; ++i)
    gaps_.col(i) = beyond;
  raiseAlong(first_to_second);
}

void LeafGaps::raiseAlong(const Eigen::Vector3d& first_to_second) {
  if (!is_small_) return;
  const Eigen::Vector3f n = first_to_second.cast<float>();
  const Lanes farthest = first_.farthest(n);
  const Lanes nearest = second_.nearest(n) + between_.dot(n);
  for (std::uint32_t i = 0; i < first_.count; ++i)
    gaps_.col(i) = gaps_.col(i).max(nearest - farthest[i]);
}

void LeafGaps::raiseAcrossFirst(std::uint32_t i) {
  if (!is_small_) return;
  const Eigen::Vector3f n = first_.normals.of(i);
  const float between = between_.dot(n);
  if (between > first_.high[i]) {
    gaps_.col(i) = gaps_.col(i).max((second_.nearest(n) + between) - first_.high[i]);
  } else {
    gaps_.col(i) = gaps_.col(i).max(first_.low[i] - (second_.farthest(n) + between));
  }
}

void LeafGaps::raiseAcrossSecond(std::uint32_t j) {
  if (!is_small_) return;
  const Eigen::Vector3f n = second_.normals.of(j);
  const float between = between_.dot(n);
  const float low = second_.low[j] + between, high = second_.high[j] + between;
  const Lanes gaps = low > 0 ? Lanes(low - first_.farthest(n)) : Lanes(first_.nearest(n) - high);
  for (std::uint32_t i = 0; i < first_.count; ++i)
    gaps_(j, i) = std::max(gaps_(j, i), gaps[i]);
}

void LeafGaps::setFarEnough(double far_enough) {
  // Rounded up, so that lower() is at least `far_enough` if no pair is open.
  enough_ = static_cast<float>(std::min((far_enough + pad_) * (1 + 0x1p-18), 1e30));
}

void LeafGaps::close(std::uint32_t i, std::uint32_t j) {
  gaps_(j, i) = kInfinite;
}

double LeafGaps::lower() const {
  return gaps_.leftCols(first_.count).minCoeff() * kShare - pad_;
}

}  // namespace link_bounds
