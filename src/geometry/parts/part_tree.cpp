// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Items, a tree over them, a cut through it, and the points of what was cut.
#include "link_bounds/geometry/parts/part_tree.h"

#include <algorithm>
#include <map>

#include "geometry/parts/part_cut.h"

namespace link_bounds {
namespace {

/// The same tree for every number of parts, so that more parts never fit worse than fewer; with
/// leaves to spare, because what gains nothing at first may gain later.
constexpr std::size_t kMostLeaves = 1024;

/// The vertices of a part, by shape. An indivisible shape has none.
using PartVertices = std::map<std::uint32_t, std::vector<std::uint32_t>>;

PartVertices verticesOf(const PartNode& node, const PartItems& items,
                        const std::vector<DivisibleShape>& shapes) {
  PartVertices vertices;
  for (std::size_t i = node.begin; i < node.end; ++i) {
    std::vector<std::uint32_t>& of_shape = vertices[items[i].shape];
    const auto& mesh = shapes[items[i].shape].mesh;
    if (!mesh) continue;
    const auto& triangle = mesh->triangles[items[i].triangle];
    of_shape.insert(of_shape.end(), triangle.begin(), triangle.end());
  }
  for (auto& [shape, indices] : vertices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }
  return vertices;
}

std::vector<PartVertices> cutLink(const std::vector<DivisibleShape>& shapes,
                                  const Eigen::Affine3d& unit_from_link, std::size_t most) {
  PartItems items = partItems(shapes, unit_from_link);
  const std::vector<PartNode> nodes = growTree(items, kMostLeaves);
  const std::vector<PartReach> reaches = reachesOf(nodes, items, shapes, unit_from_link);
  std::vector<PartVertices> parts;
  for (const std::size_t index : cutTree(nodes, reaches, most))
    parts.push_back(verticesOf(nodes[index], items, shapes));
  return parts;
}

/// The points of one mesh in each part that has some of it; those of the link where it has all.
struct MeshPoints {
  std::map<std::size_t, std::shared_ptr<const PointSet>> of_part;
  std::size_t bytes = 0;
  std::size_t least_bytes = 0;  ///< what the numbers of plain lists take
};

MeshPoints pointsOf(const DivisibleShape& divisible, std::uint32_t shape,
                    const std::vector<PartVertices>& parts, std::size_t most_bytes) {
  MeshPoints result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto found = parts[i].find(shape);
    if (found == parts[i].end()) continue;
    if (found->second.size() == divisible.mesh->vertices.size()) {
      result.of_part[i] = divisible.shape.points;
      continue;
    }
    std::vector<Eigen::Vector3f> points;
    for (const std::uint32_t vertex : found->second)
      points.push_back(divisible.mesh->vertices[vertex]);
    auto set = std::make_shared<const PointSet>(points, most_bytes);
    result.bytes += set->bytes();
    result.least_bytes += set->size() * sizeof(points[0]);
    result.of_part[i] = std::move(set);
  }
  return result;
}

/// With tables where there is room for all, else with plain lists; nothing if even these are too
/// large.
std::optional<MeshPoints> fittingPoints(const DivisibleShape& divisible, std::uint32_t shape,
                                        const std::vector<PartVertices>& parts) {
  const std::size_t limit = kBytesPerPart * parts.size();
  MeshPoints points = pointsOf(divisible, shape, parts, kBytesPerPart);
  if (points.bytes <= limit) return points;
  if (points.least_bytes > limit) return std::nullopt;
  points = pointsOf(divisible, shape, parts, 0);
  return points.bytes <= limit ? std::optional(std::move(points)) : std::nullopt;
}

/// Nothing if the points of some meshes are too large; those meshes are then made indivisible.
std::optional<std::vector<LinkPart>> partsOf(std::vector<DivisibleShape>& shapes,
                                             const Eigen::Affine3d& unit_from_link,
                                             std::size_t most) {
  const std::vector<PartVertices> parts = cutLink(shapes, unit_from_link, most);
  std::vector<MeshPoints> points(shapes.size());
  bool fits = true;
  for (std::uint32_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].mesh) continue;
    if (auto fitting = fittingPoints(shapes[i], i, parts)) {
      points[i] = std::move(*fitting);
    } else {
      shapes[i].mesh = nullptr;
      fits = false;
    }
  }
  if (!fits) return std::nullopt;
  std::vector<LinkPart> result(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const auto& [shape, vertices] : parts[i]) {
      result[i].push_back(shapes[shape].shape);
      if (shapes[shape].mesh) result[i].back().points = points[shape].of_part.at(i);
    }
  }
  return result;
}

LinkPart wholeLink(const std::vector<DivisibleShape>& shapes) {
  LinkPart part;
  for (const DivisibleShape& shape : shapes)
    part.push_back(shape.shape);
  return part;
}

}  // namespace

std::vector<LinkPart> splitIntoParts(const std::vector<DivisibleShape>& shapes, std::size_t most) {
  if (shapes.empty()) return {};
  const std::optional<Eigen::Affine3d> unit_from_link = unitFromLink(shapes);
  if (most == 1 || !unit_from_link) return {wholeLink(shapes)};
  std::vector<DivisibleShape> divisible = shapes;
  while (true) {
    if (auto parts = partsOf(divisible, *unit_from_link, most)) return std::move(*parts);
  }
}

}  // namespace link_bounds
