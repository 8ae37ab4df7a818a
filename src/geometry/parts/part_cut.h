// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the nodes of the tree that become parts.
#pragma once

#include <vector>

#include "geometry/parts/part_tree.h"

namespace link_bounds {

/// At most `max_parts` nodes that together hold each item once, such that their boxes are small in
/// the axes of the link and in turned axes. In the axes of the link the sum of their volumes is not
/// larger than for any smaller `max_parts`. Returns indices of nodes.
std::vector<std::size_t> cutTree(const PartTree& tree, const std::vector<DivisibleShape>& shapes,
                                 const Eigen::Affine3d& unit_from_link, std::size_t max_parts,
                                 WorkMeter& meter);

}  // namespace link_bounds
