// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// An immutable set of points and how far it reaches along given directions.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace link_bounds {

/// The smallest and largest r . p over the points p of a set, for three directions r; metres.
struct Extents {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

/// Safe to read from several threads. Metres, in the frame of the mesh the points come from.
class PointSet {
 public:
  /// `points` must be finite and not empty.
  explicit PointSet(const std::vector<Eigen::Vector3f>& points);

  /// Extents along the rows of `directions`, a linear map from this set's frame to another's.
  /// Each r . p is evaluated as (r0 x + r1 y) + r2 z in double, so the result is reproducible to
  /// the bit on every machine.
  Extents extents(const Eigen::Matrix3d& directions) const;

  /// The largest |x|, |y| and |z| of any point.
  const Eigen::Vector3d& magnitude() const { return magnitude_; }

  std::size_t size() const { return x_.size(); }

  /// Bytes kept in memory.
  std::size_t bytes() const;

 private:
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  Eigen::Vector3d magnitude_;
};

}  // namespace link_bounds
