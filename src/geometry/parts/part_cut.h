// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which nodes of the tree become parts.
#pragma once

#include <vector>

#include "geometry/parts/part_reach.h"

namespace link_bounds {

/// At most `most` nodes that have all items between them, each item once, such that the sum of
/// their mean volumes is small and the sum of their volumes in the axes of the link is not larger
/// than for any smaller `most`.
std::vector<std::size_t> cutTree(const std::vector<PartNode>& nodes,
                                 const std::vector<PartReach>& reaches, std::size_t most);

}  // namespace link_bounds
