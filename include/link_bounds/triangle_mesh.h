// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The vertices and triangles of one mesh file, and the checks that make them trustworthy.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace link_bounds {

/// Why a mesh cannot be used, in words for the user; the thrower does not repeat the file's name.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same where the file itself may be sound; what() ends with what to do instead.
class ImportError : public MeshError {
 public:
  using MeshError::MeshError;
};

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
