// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Splits the links of a robot. Links of equal shapes, as wheels are, share the points of parts.
#pragma once

#include <vector>

#include "link_bounds/geometry/parts/link_parts.h"
#include "link_bounds/geometry/shape/link_boxes.h"

namespace link_bounds {

class LinkSplitter {
 public:
  explicit LinkSplitter(std::size_t max_parts) : max_parts_(max_parts) {}

  /// The parts of a link with its name and padding. `shapes` are those of the link. If memory does
  /// not suffice, the link itself is its only part. What `check_interrupt` throws ends it.
  std::vector<BoundedLink> split(const BoundedLink& link, const std::vector<DivisibleShape>& shapes,
                                 const CheckInterrupt& check_interrupt);

 private:
  struct SplitLink {
    std::vector<DivisibleShape> shapes;
    std::vector<LinkPart> parts;
  };

  const std::vector<LinkPart>& partsOf(const std::vector<DivisibleShape>& shapes,
                                       const CheckInterrupt& check_interrupt);

  std::size_t max_parts_;
  std::vector<SplitLink> known_;
};

}  // namespace link_bounds
