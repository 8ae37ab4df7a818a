// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The axis-aligned bounding box and the ways the paper writes and draws it.
///
/// Lengths are metres, in the frame whose axes the box follows. Functions never throw.
/// An empty box (`isEmpty()`) has no representation, corners or distance: do not pass one.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace link_bounds {

/// Min-max, the first representation of the paper's Figure 3: (a).
using Aabb = Eigen::AlignedBox3d;

/// Figure 3 (b): smallest corner and the full widths along x, y, z; widths >= 0.
struct MinWidth {
  Eigen::Vector3d min;
  Eigen::Vector3d width;
};

/// Figure 3 (c): centre and half-extents along x, y, z; half-extents >= 0.
struct CenterRadius {
  Eigen::Vector3d center;
  Eigen::Vector3d radius;
};

/// A converted box contains the original one, in real numbers and also where the reader adds its
/// numbers in double precision. A conversion moves a face outward by at most 4 ulp of the box's
/// largest |coordinate|.
MinWidth toMinWidth(const Aabb& box);
CenterRadius toCenterRadius(const Aabb& box);
Aabb toAabb(const MinWidth& box);
Aabb toAabb(const CenterRadius& box);

/// The eight corners, numbered as in Figure 6 from 0 to 7: bit 0 of the number chooses the max of
/// x, bit 1 of y, bit 2 of z.
std::array<Eigen::Vector3d, 8> corners(const Aabb& box);

/// The six faces over those numbers (Figures 7 and 8), the right one (+x) first, then -x, +y, -y,
/// +z, -z; each counter-clockwise when seen from outside.
constexpr std::array<std::array<int, 4>, 6> kQuads{{{{1, 3, 7, 5}},
                                                    {{0, 4, 6, 2}},
                                                    {{2, 6, 7, 3}},
                                                    {{0, 1, 5, 4}},
                                                    {{4, 5, 7, 6}},
                                                    {{0, 2, 3, 1}}}};

/// The twelve edges as pairs of corner numbers, the smaller number first.
std::array<std::array<int, 2>, 12> edges();

/// The box with every face moved outward by `distance` >= 0 metres, rounded outward.
Aabb padded(const Aabb& box, double distance);

/// Euclidean gap between two boxes, or minus the depth by which they penetrate: with
/// g_k = max(a.min - b.max, b.min - a.max) per axis, max g_k if all g_k <= 0, else |max(g, 0)|.
/// A point is a box of zero size.
double signedDistance(const Aabb& a, const Aabb& b);

}  // namespace link_bounds
