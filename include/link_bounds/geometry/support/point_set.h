// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// An immutable set of points and how far it extends along given directions.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "link_bounds/geometry/check_interrupt.h"
#include "link_bounds/geometry/support/query/extents.h"

namespace link_bounds {

struct DirectionTable;  // private to the library

/// Any number of threads may read it. Metres, in the frame that the points are given in.
///
/// Vertices of meshes are float and stay for long: only those that can be extreme in some
/// direction are kept, in a table that finds them in constant time. Points in double come and go,
/// so preparing a table would cost more than it saves: they stay where they are, and each query
/// scans all of them.
class PointSet {
 public:
  /// `points` must be finite and not empty. Millions of points can take seconds; an exception of
  /// `check_interrupt` is passed on.
  explicit PointSet(const std::vector<Eigen::Vector3f>& points,
                    const CheckInterrupt& check_interrupt = nullptr);

  /// As above, with a table of at most `max_bytes` where that is possible: for a set that is one
  /// of many.
  PointSet(const std::vector<Eigen::Vector3f>& points, std::size_t max_bytes,
           const CheckInterrupt& check_interrupt = nullptr);

  /// Points in double: `xyz` is the first of 3 `count` numbers, the coordinates of one point after
  /// the other, which must be finite and must not change while this lives.
  PointSet(std::shared_ptr<const double> xyz, std::size_t count);

  /// Extents along the rows of `directions`, the same to the bit on every machine. Entries of
  /// `directions` must not exceed 1e30, and no product with points in double may overflow.
  Extents extents(const Directions& directions) const;

  /// A point with the largest d . p, up to the rounding of its evaluation and the 1e-14 of the
  /// largest |coordinate| times |d|_1 by which a table may leave out points. Entries of `direction`
  /// must not exceed 1e30, and no product with points in double may overflow.
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const;

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

  /// The table; null for points in double. For the library alone.
  const DirectionTable* table() const { return table_.get(); }

 private:
  std::shared_ptr<const DirectionTable> table_;  ///< of points in float
  std::shared_ptr<const double> xyz_;            ///< of points in double
  Eigen::Vector3d magnitude_;
  std::size_t size_;
};

}  // namespace link_bounds
