// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// A link split into parts with tight boxes: the paper's hierarchy of bounding volumes.
///
/// A part is a list of shapes, as a link is, so its box is exact in any pose. The union of the
/// parts' boxes is the box of the link. Links are split once, when a model is loaded.
#pragma once

#include <memory>
#include <vector>

#include "link_bounds/geometry/check_interrupt.h"
#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

/// A shape of a link, and the triangles that it can be divided into.
struct DivisibleShape {
  Shape shape;
  /// Its vertices are the points of the shape. Null: the shape is indivisible.
  std::shared_ptr<const TriangleMesh> mesh;
};

/// The shapes of one part. A mesh that is divided has in each part a shape with the points of the
/// triangles there.
using LinkPart = std::vector<Shape>;

/// The points that one mesh has in all parts take at most so much memory times the number of parts
/// [bytes]. A link in 64 parts then takes at most 1 MB for each of its meshes.
constexpr std::size_t kBytesPerPart = 16'000;

/// At most `max_parts` >= 1 parts. Each indivisible shape and each triangle is in exactly one part,
/// and no part is empty. The sum of the parts' volumes, in the axes of the link, does not rise with
/// `max_parts`, but for rounding. There are fewer parts if more would not reduce it. There is one
/// part if a shape has no finite box. A mesh whose points would take too much memory is not
/// divided. An exception of `check_interrupt` is passed on.
std::vector<LinkPart> splitIntoParts(const std::vector<DivisibleShape>& shapes,
                                     std::size_t max_parts,
                                     const CheckInterrupt& check_interrupt = nullptr);

}  // namespace link_bounds
