// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds of a support function in all directions, from its values in some.
//
// The support function h(d) of a set is the largest dot product of d with a point of the set. So
//
//   h(c d) = c h(d) for c >= 0,   h(d + e) <= h(d) + h(e):
//
// the point that is best for d + e gives the sum of its two dot products, and neither is larger
// than the best one for d or e alone. Where d = sum w_k d_k with w_k >= 0, it follows that
//
//   h(d) <= sum w_k h(d_k).
//
// The table has upper bounds of h at the points d_k of a square grid on each face of the cube [-1,
// 1]^3. Any direction is a multiple of a point of the cube's surface, which is the bilinear mean of
// the four corners of its cell.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace link_bounds {

class SupportTable {
 public:
  /// The points of the grid with `cells` > 0 cells along an edge of the cube.
  static std::vector<Eigen::Vector3d> directions(int cells);

  /// `supports` are upper bounds of the support in each of `directions(cells)`.
  SupportTable(int cells, std::vector<double> supports)
      : cells_(cells), supports_(std::move(supports)) {}

  const std::vector<double>& supports() const { return supports_; }

  /// Upper bound of the support in `direction`, of any length; infinite if `direction` is not
  /// finite.
  double at(const Eigen::Vector3d& direction) const;

 private:
  int cells_;
  std::vector<double> supports_;
};

/// Sorted by face, then by the axis after that of the face, then by the one after that.
inline std::vector<Eigen::Vector3d> SupportTable::directions(int cells) {
  std::vector<Eigen::Vector3d> result;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    Eigen::Vector3d direction;
    direction[axis] = face % 2 == 0 ? 1 : -1;
    for (int i = 0; i <= cells; ++i) {
      direction[(axis + 1) % 3] = 2.0 * i / cells - 1;
      for (int j = 0; j <= cells; ++j) {
        direction[(axis + 2) % 3] = 2.0 * j / cells - 1;
        result.push_back(direction);
      }
    }
  }
  return result;
}

inline double SupportTable::at(const Eigen::Vector3d& direction) const {
  const double x = std::abs(direction.x());
  const double y = std::abs(direction.y());
  const double z = std::abs(direction.z());
  const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  const double length = std::abs(direction[axis]);
  if (!std::isfinite(x + y + z)) return std::numeric_limits<double>::infinity();
  if (length == 0) return 0;
  // Shares first: the reciprocal of a tiny length is not finite.
  const double u = (direction[axis == 2 ? 0 : axis + 1] / length + 1) * (0.5 * cells_);
  const double v = (direction[axis == 0 ? 2 : axis - 1] / length + 1) * (0.5 * cells_);
  const int i = std::min(std::max(static_cast<int>(u), 0), cells_ - 1);
  const int j = std::min(std::max(static_cast<int>(v), 0), cells_ - 1);
  const double s = u - i;
  const double t = v - j;
  const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
  const double* const low =
      &supports_[static_cast<std::size_t>((face * (cells_ + 1) + i) * (cells_ + 1) + j)];
  const double* const high = low + cells_ + 1;
  return length *
         ((1 - s) * ((1 - t) * low[0] + t * low[1]) + s * ((1 - t) * high[0] + t * high[1]));
}

}  // namespace link_bounds
