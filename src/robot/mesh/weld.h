// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks the triangles of a file and merges equal vertices.
#pragma once

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// The same triangles. Keeps only vertices that triangles use, in the order of first use, and
/// merges those with equal bits; -0 counts as +0. Throws MeshError if there is no triangle, an
/// index is out of range, or a vertex in use is not finite.
TriangleMesh welded(const TriangleMesh& mesh);

/// Throws MeshError if there is no triangle, an index is out of range, or any vertex is not finite.
void checkTriangles(const TriangleMesh& mesh);

}  // namespace link_bounds
