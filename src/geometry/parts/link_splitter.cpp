// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A memory of shapes that were split before.
#include "geometry/parts/link_splitter.h"

#include <new>

namespace link_bounds {
namespace {

void append(const void* bytes, std::size_t count, std::string& key) {
  key.append(static_cast<const char*>(bytes), count);
}

/// Bytes, because numbers that are none equal nothing.
std::string keyOf(const std::vector<DivisibleShape>& shapes) {
  std::string key;
  for (const DivisibleShape& divisible : shapes) {
    const Shape& shape = divisible.shape;
    const PointSet* points = shape.points.get();
    append(&points, sizeof(points), key);
    append(&shape.solid, sizeof(shape.solid), key);
    append(shape.size.data(), sizeof(shape.size), key);
    append(shape.link_from_shape.data(), sizeof(shape.link_from_shape.matrix()), key);
  }
  return key;
}

}  // namespace

const std::vector<LinkPart>& LinkSplitter::partsOf(const std::vector<DivisibleShape>& shapes) {
  std::vector<LinkPart>& parts = known_[keyOf(shapes)];
  if (parts.empty()) parts = splitIntoParts(shapes, most_);
  return parts;
}

std::vector<BoundedLink> LinkSplitter::split(const BoundedLink& link,
                                             const std::vector<DivisibleShape>& shapes) try {
  std::vector<BoundedLink> parts;
  for (const LinkPart& part : partsOf(shapes))
    parts.push_back({link.name, part, link.padding, link.missing});
  return parts;
} catch (const std::bad_alloc&) {
  if (link.shapes.empty()) return {};
  return {link};
}

}  // namespace link_bounds
