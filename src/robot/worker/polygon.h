// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Divides the polygons of a mesh file into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace link_bounds {

using CornerIndices = std::vector<std::uint32_t>;  // indices of vertices, in order

/// Gives two triangles fewer than there are corners. Each corner is in a triangle, so that their
/// box is that of the polygon. A convex polygon becomes a fan from its first corner. From a concave
/// one, ears are cut off, so that the triangles cover it and nothing else, also where bridges lead
/// to its holes. If there is no ear, because the polygon crosses itself, the rest becomes a fan.
/// Throws MeshError for a polygon of thousands of corners with so many notches that it takes
/// seconds.
std::vector<std::array<std::uint32_t, 3>> trianglesOf(const CornerIndices& corners,
                                                      const std::vector<Eigen::Vector3f>& vertices);

}  // namespace link_bounds
