// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices the convex hull of a node needs: of a node of a hundred triangles about a quarter.
#pragma once

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

/// Together the lists take no more bytes for each triangle, but for one list. Meshes of robots need
/// half of that.
constexpr std::size_t kListedBytes = 12;

/// Lists them for small nodes that are no leaves, as far as kListedBytes suffices. `first_vertex`
/// must be set.
void listHullVertices(TriangleTree& tree, WorkMeter& meter);

}  // namespace link_bounds
