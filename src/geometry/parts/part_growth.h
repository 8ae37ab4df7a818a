// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree over the items of a link, grown where there is the most surface in the largest box.
#pragma once

#include <vector>

#include "geometry/parts/part_items.h"

namespace link_bounds {

/// The items [begin, end), which its two children share. No children: left is 0.
struct PartNode {
  std::size_t begin;
  std::size_t end;
  std::size_t left = 0;
  std::size_t right = 0;

  bool isLeaf() const { return left == 0; }
};

/// The root comes first, parents before children. Orders the items as the nodes need it.
std::vector<PartNode> growTree(PartItems& items, std::size_t most_leaves);

}  // namespace link_bounds
