// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The input of distances: the shapes of a link or an object, and their triangles.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "link_bounds/geometry/check_interrupt.h"
#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

class TriangleTree;  // private to the library

/// The triangles of a shape in a tree, in the coordinates of the shape's points [m]. It is made
/// once and may be shared by any number of shapes and threads. A triangle with two equal corners is
/// a segment, one with three a point. Null if there is no triangle, an index is too large, or a
/// coordinate is not finite or exceeds 1e30. An exception of `check_interrupt` is passed on.
std::shared_ptr<const TriangleTree> triangleTree(const TriangleMesh& mesh,
                                                 const CheckInterrupt& check_interrupt = nullptr);

/// As above, for vertices in double. `solid` with its `size` sweeps the triangles, as in Shape: so
/// a list of cubes is a list of points that a box sweeps.
std::shared_ptr<const TriangleTree> triangleTree(
    const std::vector<Eigen::Vector3d>& vertices,
    const std::vector<std::array<std::uint32_t, 3>>& triangles, Solid solid = Solid::kNone,
    const Eigen::Vector3d& size = Eigen::Vector3d::Zero(),
    const CheckInterrupt& check_interrupt = nullptr);

/// Bytes kept in memory.
std::size_t bytes(const TriangleTree& tree);

/// Max bytes of the tree of such a mesh. A typical tree takes a third.
std::size_t maxTreeBytes(const TriangleMesh& mesh);

struct BodyShape {
  Shape shape;
  /// The triangles that the shape consists of. They are a surface, also if they enclose a volume.
  /// The points of `shape` must be exactly the vertices of these triangles, and the solid that of
  /// `shape`; otherwise neither bound of a distance holds. Builds without NDEBUG check the points
  /// that a distance rests on. meshShape() makes both. Null: the body is only known to lie within
  /// the convex hull of the shape and to hold the shape's points, each swept by the solid. A solid
  /// without points, or with one, is its own convex hull and needs no triangles.
  std::shared_ptr<const TriangleTree> triangles = nullptr;
  /// With a tip [m], in the coordinates of the shape, the shape is the convex hull of its solid and
  /// the tip: a cylinder of height 0 becomes a cone. Only for a solid without points and triangles.
  std::optional<Eigen::Vector3d> tip = std::nullopt;
};

/// A mesh: its triangles, and those of its vertices that a triangle uses. Nothing where
/// triangleTree() is null. An exception of `check_interrupt` is passed on.
std::optional<BodyShape> meshShape(
    const TriangleMesh& mesh, const Eigen::Affine3d& link_from_mesh = Eigen::Affine3d::Identity(),
    const CheckInterrupt& check_interrupt = nullptr);

/// The shapes of a link or an object, in its frame.
struct Body {
  std::vector<BodyShape> shapes;
};

}  // namespace link_bounds
