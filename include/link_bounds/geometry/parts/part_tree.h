// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// A link split into tight parts: the paper's hierarchy of bounding volumes.
///
/// A part is a set of shapes like the link itself, so that its box is exact and tight in any pose
/// and the union of the parts' boxes is the box of the link. Made once, when a model is loaded.
#pragma once

#include <memory>
#include <vector>

#include "link_bounds/geometry/parts/triangle_mesh.h"
#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// A shape of a link and what it can be divided into.
struct DivisibleShape {
  Shape shape;
  /// Whose vertices are the points of the shape. Null: the shape is indivisible.
  std::shared_ptr<const TriangleMesh> mesh;
};

/// The shapes of one part. Of a mesh that is divided it has the points of its own triangles.
using LinkPart = std::vector<Shape>;

/// What the points of all parts may take in memory, for each mesh and part of the link [bytes].
constexpr std::size_t kBytesPerPart = 16'000;

/// At most `most` >= 1 parts. Each indivisible shape and each triangle is in exactly one, whole; no
/// part is empty. In the axes of the link the sum of the parts' volumes never rises with `most`.
/// There are fewer parts if more would not reduce it, or not all shapes have a finite box. A mesh
/// whose parts would take more memory than they may stays undivided.
std::vector<LinkPart> splitIntoParts(const std::vector<DivisibleShape>& shapes, std::size_t most);

}  // namespace link_bounds
