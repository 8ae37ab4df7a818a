// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices the convex hull of a node needs.
#pragma once

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

/// Together the lists take no more bytes for each triangle, but for one list. Meshes of robots need
/// half of that.
constexpr std::size_t kListedBytes = 12;

/// Smaller nodes list all their vertices. With proofs for all nodes a tree takes 2.3 times as long
/// as without any, for those of half as many triangles as well 1.6 times, with this 1.4 times;
/// distances then take 2 to 4 % longer than with proofs for all.
constexpr std::uint32_t kProvenNode = kSmallNode / 2;

/// Lists them for small nodes that are no leaves, as far as kListedBytes suffices. `first_vertex`
/// must be set.
void listHullVertices(TriangleTree& tree, WorkMeter& meter);

}  // namespace link_bounds
