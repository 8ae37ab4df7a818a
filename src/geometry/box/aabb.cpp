// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's three representations, numbered corners, quads and edges, and the distance of boxes.
#include "link_bounds/geometry/box/aabb.h"

#include <algorithm>

#include "geometry/box/directed_sum.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {

MinWidth toMinWidth(const Aabb& box) {
  MinWidth result{box.min(), Eigen::Vector3d::Zero()};
  for (int k = 0; k < 3; ++k)
    result.width[k] = addUp(box.max()[k], -box.min()[k]);
  return result;
}

CenterRadius toCenterRadius(const Aabb& box) {
  // Halving first cannot overflow.
  CenterRadius result{0.5 * box.min() + 0.5 * box.max(), Eigen::Vector3d::Zero()};
  for (int k = 0; k < 3; ++k) {
    const double center = result.center[k];
    result.radius[k] = std::max(addUp(box.max()[k], -center), addUp(center, -box.min()[k]));
  }
  return result;
}

Aabb toAabb(const MinWidth& box) {
  Eigen::Vector3d max;
  for (int k = 0; k < 3; ++k)
    max[k] = addUp(box.min[k], box.width[k]);
  return {box.min, max};
}

Aabb toAabb(const CenterRadius& box) {
  Eigen::Vector3d min;
  Eigen::Vector3d max;
  for (int k = 0; k < 3; ++k) {
    min[k] = addDown(box.center[k], -box.radius[k]);
    max[k] = addUp(box.center[k], box.radius[k]);
  }
  return {min, max};
}

std::array<Eigen::Vector3d, 8> corners(const Aabb& box) {
  std::array<Eigen::Vector3d, 8> result;
  for (int i = 0; i < 8; ++i) {
    result[static_cast<std::size_t>(i)] = {(i & 1 ? box.max() : box.min()).x(),
                                           (i & 2 ? box.max() : box.min()).y(),
                                           (i & 4 ? box.max() : box.min()).z()};
  }
  return result;
}

/// Two quads share each edge and run along it in opposite directions, so each edge rises in one.
std::array<std::array<int, 2>, 12> edges() {
  std::array<std::array<int, 2>, 12> result{};
  std::size_t count = 0;
  for (const auto& quad : kQuads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const int from = quad[i];
      const int to = quad[(i + 1) % 4];
      if (from < to) result[count++] = {from, to};
    }
  }
  return result;
}

Aabb padded(const Aabb& box, double distance) {
  Aabb result = box;
  for (int k = 0; k < 3; ++k) {
    result.min()[k] = sumDown(box.min()[k], -distance);
    result.max()[k] = sumUp(box.max()[k], distance);
  }
  return result;
}

double signedDistance(const Aabb& a, const Aabb& b) {
  const Eigen::Vector3d gap = (a.min() - b.max()).cwiseMax(b.min() - a.max());
  if ((gap.array() <= 0).all()) return gap.maxCoeff();
  return length(std::max(gap.x(), 0.0), std::max(gap.y(), 0.0), std::max(gap.z(), 0.0));
}

}  // namespace link_bounds
