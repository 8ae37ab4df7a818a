// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// An immutable set of points and how far it reaches along given directions.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "link_bounds/geometry/support/direction_table.h"

namespace link_bounds {

/// Safe to read from several threads. Metres, in the frame of what the points come from.
///
/// Vertices of meshes are float and stay for long: of them only those are kept that can be extreme
/// in some direction, in a table. Points in double come and go, so preparing a table would cost
/// more than it saves: they stay where they are, and all are scanned at each query.
class PointSet {
 public:
  /// `points` must be finite and not empty.
  explicit PointSet(const std::vector<Eigen::Vector3f>& points);

  /// The same of `count` points in double: `xyz` is the first of 3 `count` numbers, the coordinates
  /// of one point after the other, which must not change while this lives.
  PointSet(std::shared_ptr<const double> xyz, std::size_t count);

  /// With a table of at most `most_bytes` where that is possible (see directionTable).
  PointSet(const std::vector<Eigen::Vector3f>& points, std::size_t most_bytes);

  /// Extents along the rows of `directions`, evaluated as those of a table (see there): the same to
  /// the bit by every path of instructions. Of points in double the products must not overflow.
  Extents extents(const Directions& directions) const {
    return isScanned() ? scan(directions) : link_bounds::extents(table_, directions);
  }

  /// True for points in double, which have no table.
  bool isScanned() const { return xyz_ != nullptr; }

  /// Of points in float.
  const DirectionTable& table() const { return table_; }

  /// True for the very same set, and for points in double that are equal one by one.
  bool isSame(const PointSet& other) const;

  /// The largest |x|, |y| and |z| of any point [m].
  const Eigen::Vector3d& magnitude() const { return magnitude_; }

  /// The points in float that can be extreme, each once, in no particular order.
  std::vector<Eigen::Vector3f> points() const;

  /// All points that are kept, in double; some may be there twice.
  std::vector<Eigen::Vector3d> keptPoints() const;

  /// The number of points that are kept.
  std::size_t size() const { return size_; }

  /// Bytes kept in memory.
  std::size_t bytes() const;

 private:
  Extents scan(const Directions& directions) const;

  DirectionTable table_;               ///< of points in float
  std::shared_ptr<const double> xyz_;  ///< of points in double
  Eigen::Vector3d magnitude_;
  std::size_t size_;
};

}  // namespace link_bounds
