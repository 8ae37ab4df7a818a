// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Leaves from their items, the others from their children.
#include "geometry/parts/part_reach.h"

#include <array>
#include <cmath>

namespace link_bounds {
namespace {

using Frames = std::array<Eigen::Matrix3d, PartReach::kFrames>;
using Directions = Eigen::Matrix<double, 3 * PartReach::kFrames, 3>;

Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// That of the link first; then by 45 degrees about its axes and by 60 about the diagonals.
Frames frames() {
  return {Eigen::Matrix3d::Identity(),  turned(M_PI / 4, {1, 0, 0}), turned(M_PI / 4, {0, 1, 0}),
          turned(M_PI / 4, {0, 0, 1}),  turned(M_PI / 3, {1, 1, 1}), turned(M_PI / 3, {-1, 1, 1}),
          turned(M_PI / 3, {1, -1, 1}), turned(M_PI / 3, {1, 1, -1})};
}

/// The points of one shape seen along all axes of all frames.
struct View {
  Directions linear;
  PartReach::Values offset;

  View(const Frames& all, const Eigen::Affine3d& unit_from_shape) {
    for (int i = 0; i < PartReach::kFrames; ++i) {
      const Eigen::Matrix3d& frame = all[static_cast<std::size_t>(i)];
      linear.middleRows<3>(3 * i) = frame * unit_from_shape.linear();
      offset.segment<3>(3 * i) = (frame * unit_from_shape.translation()).array();
    }
  }

  PartReach::Values of(const Eigen::Vector3f& point) const {
    return (linear * point.cast<double>()).array() + offset;
  }
};

void extendByShape(const Frames& all, const Shape& shape, const Eigen::Affine3d& unit_from_link,
                   PartReach& reach) {
  PartReach::Values low;
  PartReach::Values high;
  for (int i = 0; i < PartReach::kFrames; ++i) {
    const Aabb box = worldBox(shape, all[static_cast<std::size_t>(i)] * unit_from_link).value();
    low.segment<3>(3 * i) = box.min().array();
    high.segment<3>(3 * i) = box.max().array();
  }
  reach.extend(low, high);
}

}  // namespace

double PartReach::meanVolume() const {
  const Values width = high_ - low_;
  double turned_sum = 0;
  for (int i = 1; i < kFrames; ++i)
    turned_sum += width.segment<3>(3 * i).prod();
  return (volume() + turned_sum / (kFrames - 1)) / 2;
}

std::vector<PartReach> reachesOf(const std::vector<PartNode>& nodes, const PartItems& items,
                                 const std::vector<DivisibleShape>& shapes,
                                 const Eigen::Affine3d& unit_from_link) {
  const Frames all = frames();
  std::vector<View> views;
  for (const DivisibleShape& shape : shapes)
    views.emplace_back(all, unit_from_link * shape.shape.link_from_shape);
  std::vector<PartReach> reaches(nodes.size());
  const auto extend = [&](const PartItem& item, PartReach& reach) {
    const DivisibleShape& shape = shapes[item.shape];
    if (!shape.mesh) return extendByShape(all, shape.shape, unit_from_link, reach);
    for (const std::uint32_t vertex : shape.mesh->triangles[item.triangle]) {
      const PartReach::Values seen = views[item.shape].of(shape.mesh->vertices[vertex]);
      reach.extend(seen, seen);
    }
  };
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].isLeaf()) {
      for (std::size_t k = nodes[i].begin; k < nodes[i].end; ++k)
        extend(items[k], reaches[i]);
    } else {
      reaches[i].extend(reaches[nodes[i].left]);
      reaches[i].extend(reaches[nodes[i].right]);
    }
  }
  return reaches;
}

}  // namespace link_bounds
