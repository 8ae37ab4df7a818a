// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// An immutable set of points and how far it reaches along given directions.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "link_bounds/direction_table.h"

namespace link_bounds {

/// Safe to read from several threads. Metres, in the frame of the mesh the points come from. Of the
/// points only those are kept that can be extreme in some direction (see directionTable).
class PointSet {
 public:
  /// `points` must be finite and not empty.
  explicit PointSet(const std::vector<Eigen::Vector3f>& points);

  const DirectionTable& table() const { return table_; }

  /// The largest |x|, |y| and |z| of any point.
  const Eigen::Vector3d& magnitude() const { return magnitude_; }

  /// The points that can be extreme, each once, in no particular order.
  std::vector<Eigen::Vector3f> points() const;

  /// Their number.
  std::size_t size() const { return size_; }

  /// Bytes kept in memory.
  std::size_t bytes() const { return sizeof(*this) - sizeof(table_) + table_.bytes(); }

 private:
  DirectionTable table_;
  Eigen::Vector3d magnitude_;
  std::size_t size_;
};

}  // namespace link_bounds
