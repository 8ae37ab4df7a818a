// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A segment is a triangle with two equal corners, a point one with three.
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Corners of the drawing's triangles among `count` points.
Triangles trianglesOf(DrawingKind kind, std::uint32_t count) {
  Triangles triangles;
  switch (kind) {
    case DrawingKind::kPoints:
      for (std::uint32_t i = 0; i < count; ++i)
        triangles.push_back({i, i, i});
      break;
    case DrawingKind::kSegments:
      for (std::uint32_t i = 0; i + 1 < count; i += 2)
        triangles.push_back({i, i + 1, i + 1});
      break;
    case DrawingKind::kStrip:
      for (std::uint32_t i = 0; i + 1 < count; ++i)
        triangles.push_back({i, i + 1, i + 1});
      break;
    case DrawingKind::kTriangles:
      for (std::uint32_t i = 0; i + 2 < count; i += 3)
        triangles.push_back({i, i + 1, i + 2});
      break;
    case DrawingKind::kSolids:
    case DrawingKind::kMesh:
    case DrawingKind::kArrow:
      break;
  }
  return triangles;
}

}  // namespace

bool hasTree(const ObjectContent& content) {
  const DrawingKind kind = content.drawing.kind;
  return kind != DrawingKind::kSolids && kind != DrawingKind::kArrow;
}

MadeTree listTree(const ObjectContent& content, const CheckInterrupt& check_interrupt) {
  const Shape& shape = content.bounded.shapes.front();
  const std::vector<Eigen::Vector3d> points = shape.points->keptPoints();
  const auto count = static_cast<std::uint32_t>(points.size());
  MadeTree made{shape.points, nullptr, ""};
  made.triangles = triangleTree(points, trianglesOf(content.drawing.kind, count), shape.solid,
                                shape.size, check_interrupt);
  if (!made.triangles) made.error = content.bounded.name + ": its numbers are too large";
  return made;
}

Body objectBody(const ObjectContent& content, std::shared_ptr<const TriangleTree> triangles) {
  const std::vector<Shape>& shapes = content.bounded.shapes;
  if (content.drawing.kind == DrawingKind::kArrow) {
    const Eigen::Vector3d tip(0, 0, content.drawing.cone_height);
    return {{{shapes[0], nullptr, std::nullopt}, {shapes[1], nullptr, tip}}};
  }
  return {{{shapes.front(), std::move(triangles), std::nullopt}}};
}

}  // namespace link_bounds
