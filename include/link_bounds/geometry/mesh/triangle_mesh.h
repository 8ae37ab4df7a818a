// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The vertices and triangles of one mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace link_bounds {

/// Metres, in the frame of the mesh file. A vertex is float32 by definition (see
/// doc/performance.md).
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

}  // namespace link_bounds
