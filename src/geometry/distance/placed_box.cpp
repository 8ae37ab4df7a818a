// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each step gives two points of the boxes, and so an upper bound of their distance and a direction
// that may prove a lower one.
#include "geometry/distance/placed_box.h"

namespace link_bounds {
namespace {

constexpr int kSteps = 4;  ///< then the boxes count as near

}  // namespace

void separate(const PlacedBox& first, const PlacedBox& second, double far_enough, double rounding,
              Separation& known) {
  const Eigen::Vector3d between = second.center - first.center;
  const auto lowerAlong = [&](const Eigen::Vector3d& normal) {
    return normal.dot(between) - first.extent(normal) - second.extent(normal) - rounding;
  };
  known.raise(lowerAlong(known.normal), known.normal);
  Eigen::Vector3d on_second = second.center;
  for (int step = 0; step < kSteps && !(known.lower >= far_enough); ++step) {
    const Eigen::Vector3d on_first = first.near(on_second);
    on_second = second.near(on_first);
    const Eigen::Vector3d apart = on_second - on_first;
    known.near = apart.norm();
    if (!(known.near > far_enough) || !(known.near > kShortest)) return;
    const Eigen::Vector3d normal = apart / known.near;
    known.raise(lowerAlong(normal), normal);
  }
}

}  // namespace link_bounds
