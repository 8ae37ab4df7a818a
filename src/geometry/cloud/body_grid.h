// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tells whether a point belongs to a body. For nearly all points, one look into a grid is enough.
//
// The grid covers the body's box with the padding and the max slack. The class of a cell holds for
// all its points: all surely belong to the body, none does, or each point is decided by its
// distance from the surface and, where the surface may cross the cell, by its side of it.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cloud/body_surface.h"

namespace link_bounds {

/// Which points belong to a body.
struct GridOptions {
  double padding = 0;    ///< max distance from the surface of a point that belongs [m], >= 0
  double max_slack = 0;  ///< max `slack` of isBody() [m], >= 0
  std::size_t max_bytes = 256 * 1024;  ///< max memory of the cells
};

/// Immutable, so any number of threads may use it.
class BodyGrid {
 public:
  /// If the body has no finite box, no point belongs to it. An exception of `check_interrupt` is
  /// passed on.
  BodyGrid(BodySurface surface, const GridOptions& options,
           const CheckInterrupt& check_interrupt = nullptr);

  /// True if the point, in the body's frame, is inside or at most padding + slack from the surface.
  /// `slack` is the max error of the point [m], from 0 to max_slack. A point that the bounds of
  /// BodySurface::distance() leave open belongs to the body; a point that is not finite does not.
  bool isBody(const Eigen::Vector3d& point, double slack = 0) const {
    const Eigen::Vector3d place = (point - origin_) * per_cell_;
    if (!(place.minCoeff() >= 0)) return false;
    if (!(place.x() < end_.x() && place.y() < end_.y() && place.z() < end_.z())) return false;
    const auto x = static_cast<std::size_t>(place.x()), y = static_cast<std::size_t>(place.y()),
               z = static_cast<std::size_t>(place.z());
    const Cell cell = at(indexOf(x, y, z));
    if (cell == Cell::kClear) return false;
    return cell == Cell::kBody || decide(point, slack, cell);
  }

  const BodySurface& surface() const { return surface_; }

  /// No point outside this box belongs to the body, whatever the slack.
  const Aabb& box() const { return box_; }

  /// False if a shape is left out, because its coordinates are too large or not finite.
  bool isWhole() const { return surface_.isWhole() && box_.isEmpty() == surface_.box().isEmpty(); }

  /// Bytes of the cells.
  std::size_t bytes() const { return cells_.size(); }

  std::size_t cells() const { return counts_[0] * counts_[1] * counts_[2]; }

 private:
  enum class Cell : std::uint8_t {
    kClear,  ///< outside, far from the surface; before findSides() maybe inside
    kBody,
    kByDistance,  ///< a point belongs if it is near enough; before findSides(), the cell may be
                  ///< inside
    kByDistanceAndSide,  ///< the surface may cross the cell: a point belongs if it is near enough
                         ///< or inside
  };
  /// The cells from `begin` up to `end`, without those at `end`.
  struct Block {
    std::array<std::size_t, 3> begin, end;
  };

  static bool isOnOneSide(Cell cell) { return cell == Cell::kClear || cell == Cell::kByDistance; }
  Cell at(std::size_t index) const {
    return static_cast<Cell>(cells_[index / 4] >> (index % 4 * 2) & 3);
  }
  bool decide(const Eigen::Vector3d& point, double slack, Cell cell) const;
  void layOut(std::size_t max_bytes);
  void build(const CheckInterrupt& check_interrupt);
  std::optional<Cell> classOf(const Block& block, BodySurface::Hint& hint) const;
  void fill(const Block& block, Cell cell);
  void findSides(const CheckInterrupt& check_interrupt);
  std::vector<std::size_t> regionAt(std::size_t index, std::vector<bool>& is_seen) const;
  bool isInside(const std::vector<std::size_t>& region) const;
  Eigen::Vector3d centerOf(std::size_t index) const;
  std::size_t indexOf(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * counts_[1] + y) * counts_[0] + x;
  }
  void set(std::size_t index, Cell cell) {
    const std::size_t shift = index % 4 * 2;
    cells_[index / 4] = static_cast<std::uint8_t>((cells_[index / 4] & ~(3u << shift)) |
                                                  static_cast<unsigned>(cell) << shift);
  }

  BodySurface surface_;
  double padding_;
  double max_slack_;
  Aabb box_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double cell_ = 1;  ///< edge of a cell [m]
  double per_cell_ = 1;
  std::array<std::size_t, 3> counts_{{0, 0, 0}};
  Eigen::Vector3d end_ = Eigen::Vector3d::Zero();  ///< counts_ as doubles
  std::vector<std::uint8_t> cells_;                ///< four cells per byte; x varies fastest
};

}  // namespace link_bounds
