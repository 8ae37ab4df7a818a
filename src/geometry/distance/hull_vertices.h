// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices the convex hull of a node needs.
#pragma once

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

/// Max size of all lists together, in bytes per triangle; the last list may exceed it. Meshes of
/// robots need half of that.
constexpr std::size_t kListedBytes = 12;

/// Nodes with up to this many triangles list all vertices that their children list; larger ones
/// leave out vertices that are proven to be redundant. These proofs make building a tree take 1.4
/// times as long as without any, 1.6 times with half of this limit, and 2.3 times with proofs for
/// all nodes. Distances take 2 to 4 % longer than with proofs for all nodes.
constexpr std::uint32_t kProvenNode = kSmallNode / 2;

/// Makes the lists of small nodes that are no leaves, until kListedBytes is used up. `first_vertex`
/// must be set.
void listHullVertices(TriangleTree& tree, WorkMeter& meter);

}  // namespace link_bounds
