// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/joint_box.h"

#include <cmath>
#include <limits>

namespace link_bounds {

JointBox wholeBox(const JointPath& path) {
  JointBox all;
  for (const Limits& range : path.ranges) {
    all.center.push_back(range.lower + width(range) / 2);
    all.half_widths.push_back(
        std::nextafter(width(range) / 2, std::numeric_limits<double>::infinity()));
  }
  return all;
}

std::array<JointBox, 2> halves(const JointBox& box, std::size_t variable) {
  std::array<JointBox, 2> result{box, box};
  const double half = box.half_widths[variable] / 2;
  result[0].half_widths[variable] = result[1].half_widths[variable] = half;
  result[0].center[variable] -= half;
  result[1].center[variable] += half;
  return result;
}

double shareOf(const JointBox& box, const JointPath& path) {
  double share = 1;
  for (std::size_t v = 0; v < path.ranges.size(); ++v)
    share *= 2 * box.half_widths[v] / width(path.ranges[v]);
  return share;
}

}  // namespace link_bounds
