// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The checks that make a mesh from a file trustworthy.
#pragma once

#include "link_bounds/geometry/parts/triangle_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// The same triangles over the vertices they use, bit-equal ones merged (-0 counts as +0), in the
/// order of first use. Throws MeshError if there is no triangle, an index names no vertex, or a
/// used vertex is not finite.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace link_bounds
