// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Remembers the links that were split before.
#include "geometry/parts/link_splitter.h"

#include <algorithm>
#include <new>

namespace link_bounds {
namespace {

bool isEqual(const DivisibleShape& a, const DivisibleShape& b) {
  return a.shape.points == b.shape.points && a.shape.solid == b.shape.solid &&
         a.shape.size == b.shape.size &&
         a.shape.link_from_shape.matrix() == b.shape.link_from_shape.matrix();
}

}  // namespace

const std::vector<LinkPart>& LinkSplitter::partsOf(const std::vector<DivisibleShape>& shapes,
                                                   const CheckInterrupt& check_interrupt) {
  for (const SplitLink& link : known_) {
    if (std::equal(link.shapes.begin(), link.shapes.end(), shapes.begin(), shapes.end(), isEqual))
      return link.parts;
  }
  known_.push_back({shapes, splitIntoParts(shapes, max_parts_, check_interrupt)});
  return known_.back().parts;
}

std::vector<BoundedLink> LinkSplitter::split(const BoundedLink& link,
                                             const std::vector<DivisibleShape>& shapes,
                                             const CheckInterrupt& check_interrupt) try {
  std::vector<BoundedLink> parts;
  for (const LinkPart& part : partsOf(shapes, check_interrupt))
    parts.push_back({link.name, part, link.padding, link.missing});
  return parts;
} catch (const std::bad_alloc&) {
  if (link.shapes.empty()) return {};
  return {link};
}

}  // namespace link_bounds
