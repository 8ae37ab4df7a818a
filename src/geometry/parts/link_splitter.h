// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Links into parts; links of equal shapes, as wheels are, share the points of their parts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/geometry/parts/part_tree.h"
#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

class LinkSplitter {
 public:
  explicit LinkSplitter(std::size_t most) : most_(most) {}

  /// The link's parts, which take everything but the shapes from it; the link as its own only part
  /// where memory does not suffice. `shapes` are those of the link.
  std::vector<BoundedLink> split(const BoundedLink& link,
                                 const std::vector<DivisibleShape>& shapes);

 private:
  const std::vector<LinkPart>& partsOf(const std::vector<DivisibleShape>& shapes);

  std::size_t most_;
  std::map<std::string, std::vector<LinkPart>> known_;  ///< by the bytes of the shapes
};

}  // namespace link_bounds
