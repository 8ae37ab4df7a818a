// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether points belong to a body, answered for nearly all of them by one look into a grid.
//
// The grid covers the body's box with the padding. Each cell is of one class, which holds for all
// its points: they surely belong to the body, surely do not, or each is decided by its distance.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cloud/body_surface.h"

namespace link_bounds {

/// What belongs to a body.
struct GridOptions {
  double padding = 0;                  ///< points up to so far from the surface [m], >= 0
  double max_slack = 0;                ///< the largest slack that isBody() may get [m], >= 0
  std::size_t max_bytes = 256 * 1024;  ///< of the cells
};

/// Immutable, so any number of threads may use it.
class BodyGrid {
 public:
  /// A body without a finite box has no points. What `check_interrupt` throws ends it.
  BodyGrid(BodySurface surface, const GridOptions& options,
           const CheckInterrupt& check_interrupt = nullptr);

  /// True for a point of the body's frame that is inside, or at most padding + slack from the
  /// surface; `slack` is an error of the point [m], from 0 to max_slack. Exact but for the bounds
  /// of BodySurface::distance(): what they leave open belongs to the body. What is not finite does
  /// not.
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

  /// Outside it no point belongs to the body, whatever the slack.
  const Aabb& box() const { return box_; }

  /// False if a shape belongs to no point, because its coordinates are too large or not finite.
  bool isWhole() const { return surface_.isWhole() && box_.isEmpty() == surface_.box().isEmpty(); }

  /// Bytes of the cells.
  std::size_t bytes() const { return cells_.size(); }

  /// How many cells there are.
  std::size_t cells() const { return counts_[0] * counts_[1] * counts_[2]; }

 private:
  enum class Cell : std::uint8_t {
    kClear,  ///< until findSides(): or inside, far from the surface
    kBody,
    kByDistance,  ///< points beyond the padding are outside; until findSides(): or all inside
    kByDistanceAndSide,  ///< the surface crosses the cell: they may also be inside
  };
  /// Cells from `begin` to before `end`.
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
  Eigen::Vector3d end_ = Eigen::Vector3d::Zero();  ///< counts_ as numbers
  std::vector<std::uint8_t> cells_;                ///< four in a byte, x first
};

}  // namespace link_bounds
