// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The vertices and triangles of one mesh file, and the checks that make them trustworthy.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "link_bounds/mesh_fault.h"

namespace link_bounds {

/// Metres, in the frame of the mesh file. A vertex is float32 by definition (see README,
/// "Accuracy and cost").
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

/// The same triangles over the vertices they use, bit-equal ones merged (-0 counts as +0), in the
/// order of first use. Throws MeshError if there is no triangle, an index names no vertex, or a
/// used vertex is not finite.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace link_bounds
