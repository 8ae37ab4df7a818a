// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links can be where, from the sensor: a coarse grid over the box around all links.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world/cloud/scan_poses.h"

namespace link_bounds {

/// Made for each scan. A point in the box of a link finds that link.
class LinkCells {
 public:
  struct Links {
    const std::uint32_t* first;
    const std::uint32_t* last;  ///< behind them
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };

  explicit LinkCells(const ScanPoses& poses);

  /// Of a point in poses.box, which must not be empty.
  Links at(const Eigen::Vector3d& point) const {
    const std::size_t cell =
        indexOf(placeOf(0, point[0]), placeOf(1, point[1]), placeOf(2, point[2]));
    return {links_.data() + starts_[cell], links_.data() + starts_[cell + 1]};
  }

 private:
  /// Along each axis: a cell then has few of the 50 links of a PR2.
  static constexpr std::size_t kCells = 16;

  /// Larger coordinates have no smaller place, also rounded.
  std::size_t placeOf(int axis, double coordinate) const {
    const double place = (coordinate - origin_[axis]) * per_cell_[axis];
    return place >= kCells - 1 ? kCells - 1 : place > 0 ? static_cast<std::size_t>(place) : 0;
  }
  static std::size_t indexOf(std::size_t x, std::size_t y, std::size_t z) {
    return (z * kCells + y) * kCells + x;
  }
  template <class Visit>
  void forEachCell(const Aabb& box, const Visit& visit) const;

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d per_cell_ = Eigen::Vector3d::Zero();
  std::array<std::uint32_t, kCells * kCells * kCells + 1> starts_{};  ///< in links_, by cell
  std::vector<std::uint32_t> links_;
};

}  // namespace link_bounds
