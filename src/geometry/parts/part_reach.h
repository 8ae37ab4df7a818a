// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How large the box of a part is, in the axes of the link and turned.
#pragma once

#include <vector>

#include "geometry/parts/part_growth.h"

namespace link_bounds {

/// Along the axes of eight frames. A link moves: were only its own axes looked at, parts would be
/// chosen that are no help once it is turned.
class PartReach {
 public:
  static constexpr int kFrames = 8;
  using Values = Eigen::Array<double, 3 * kFrames, 1>;

  void extend(const Values& low, const Values& high) {
    low_ = low_.min(low);
    high_ = high_.max(high);
  }
  void extend(const PartReach& other) { extend(other.low_, other.high_); }

  /// Volume of the box in the axes of the link.
  double volume() const { return (high_ - low_).head<3>().prod(); }

  /// Half of it counts that volume, half the mean of those in the turned frames.
  double meanVolume() const;

 private:
  Values low_ = Values::Constant(std::numeric_limits<double>::infinity());
  Values high_ = -low_;
};

/// One per node.
std::vector<PartReach> reachesOf(const std::vector<PartNode>& nodes, const PartItems& items,
                                 const std::vector<DivisibleShape>& shapes,
                                 const Eigen::Affine3d& unit_from_link);

}  // namespace link_bounds
