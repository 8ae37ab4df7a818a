// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Places every triangle in the link and bounds it.
#include "geometry/parts/part_items.h"

#include <algorithm>
#include <cmath>

namespace link_bounds {
namespace {

float surfaceOf(const Eigen::Vector3f& width) {
  return 2 * (width.x() * width.y() + width.y() * width.z() + width.z() * width.x());
}

PartItem itemOf(const Shape& shape, std::uint32_t index, const Eigen::Affine3d& unit_from_link) {
  const Eigen::AlignedBox3f box = worldBox(shape, unit_from_link)->cast<float>();
  return {box.min(), box.max(), surfaceOf(box.sizes()), index, 0};
}

void addTriangles(const DivisibleShape& shape, std::uint32_t index,
                  const Eigen::Affine3d& unit_from_link, PartItems& items) {
  const Eigen::Affine3d unit_from_shape = unit_from_link * shape.shape.link_from_shape;
  std::vector<Eigen::Vector3f> vertices;
  vertices.reserve(shape.mesh->vertices.size());
  for (const Eigen::Vector3f& vertex : shape.mesh->vertices)
    vertices.push_back((unit_from_shape * vertex.cast<double>()).cast<float>());
  std::uint32_t triangle = 0;
  for (const auto& [i, j, k] : shape.mesh->triangles) {
    const Eigen::Vector3f& a = vertices[i];
    const Eigen::Vector3f& b = vertices[j];
    const Eigen::Vector3f& c = vertices[k];
    items.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c),
                     (b - a).cross(c - a).norm() / 2, index, triangle++});
  }
}

}  // namespace

std::optional<Eigen::Affine3d> unitFromLink(const std::vector<DivisibleShape>& shapes) {
  Aabb link;
  for (const DivisibleShape& shape : shapes) {
    const std::optional<Aabb> box = worldBox(shape.shape, Eigen::Affine3d::Identity());
    if (!box) return std::nullopt;
    link.extend(*box);
  }
  if (link.isEmpty()) return std::nullopt;
  const double unit_per_metre = 1 / link.sizes().maxCoeff();
  const Eigen::Affine3d unit_from_link =
      Eigen::Scaling(unit_per_metre) * Eigen::Translation3d(-link.min());
  // Of every shape a box is needed in turned frames, too, where it is larger.
  const Eigen::Affine3d larger_from_link = Eigen::Scaling(4.0) * unit_from_link;
  const bool is_usable =
      std::isnormal(unit_per_metre) &&
      std::all_of(shapes.begin(), shapes.end(), [&](const DivisibleShape& shape) {
        return worldBox(shape.shape, larger_from_link).has_value();
      });
  return is_usable ? std::optional(unit_from_link) : std::nullopt;
}

PartItems partItems(const std::vector<DivisibleShape>& shapes,
                    const Eigen::Affine3d& unit_from_link) {
  std::size_t count = 0;
  for (const DivisibleShape& shape : shapes)
    count += shape.mesh ? shape.mesh->triangles.size() : 1;
  PartItems items;
  items.reserve(count);
  std::uint32_t index = 0;
  for (const DivisibleShape& shape : shapes) {
    if (shape.mesh) {
      addTriangles(shape, index, unit_from_link, items);
    } else {
      items.push_back(itemOf(shape.shape, index, unit_from_link));
    }
    ++index;
  }
  return items;
}

}  // namespace link_bounds
