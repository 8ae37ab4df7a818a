// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Plain code: the dot products of a block are independent, so the compiler makes them vectors.
#include "geometry/support/query/farthest_point.h"

#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

struct Farthest {
  const PointBlock* block = nullptr;
  int lane = 0;
  double dot = 0;

  void add(const PointBlock& next, const Eigen::Vector3d& d) {
    double dots[4];
    for (int i = 0; i < 4; ++i)
      dots[i] = (d.x() * static_cast<double>(next.x[i]) + d.y() * static_cast<double>(next.y[i])) +
                d.z() * static_cast<double>(next.z[i]);
    const int low = dots[1] > dots[0] ? 1 : 0;
    const int high = dots[3] > dots[2] ? 3 : 2;
    const int best = dots[high] > dots[low] ? high : low;
    if (block && !(dots[best] > dot)) return;
    block = &next;
    lane = best;
    dot = dots[best];
  }
};

}  // namespace

Eigen::Vector3d farthestPoint(const DirectionTable& table, const Eigen::Vector3d& direction) {
  const DirectionTable::Cell number =
      table.cells[cellOf(direction.x(), direction.y(), direction.z(), table.grid)];
  const DirectionTable::List& list = table.lists[number];
  Farthest farthest;
  farthest.add(list.blocks[0], direction);
  farthest.add(list.blocks[1], direction);
  if (number < table.rests.size()) {
    const DirectionTable::Rest rest = table.rests[number];
    for (std::uint32_t i = 0; i < rest.count; ++i)
      farthest.add(table.overflow[rest.first + i], direction);
  }
  const PointBlock& block = *farthest.block;
  const int lane = farthest.lane;
  return Eigen::Vector3f(block.x[lane], block.y[lane], block.z[lane]).cast<double>();
}

Eigen::Vector3d farthestPoint(const double* xyz, std::size_t count,
                              const Eigen::Vector3d& direction) {
  const double* best = xyz;
  double best_dot = 0;
  for (const double* point = xyz; point != xyz + 3 * count; point += 3) {
    const double dot =
        (direction.x() * point[0] + direction.y() * point[1]) + direction.z() * point[2];
    if (point != xyz && !(dot > best_dot)) continue;
    best = point;
    best_dot = dot;
  }
  return Eigen::Vector3d(best[0], best[1], best[2]);
}

}  // namespace link_bounds
