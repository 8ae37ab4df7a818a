// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Between directions and the square they are folded to.
//
//   s = (x + y) / (|x| + |y| + |z|)      after multiplying (x, y, z) by the sign of z, so that
//   t = (x - y) / (|x| + |y| + |z|)      opposite directions meet; -1 <= s, t <= 1
//
// The map is linear within each of the four triangles into which the diagonals cut the square (the
// faces of an octahedron's upper half), and z = 1 - max(|s|, |t|).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "link_bounds/direction_table.h"

namespace link_bounds {

/// The column or row for a coordinate -1 <= sum / norm <= 1 of the square. A zero direction has
/// norm 0; all points are extreme for it, so any cell will do.
inline int gridIndex(double sum, double norm, const DirectionGrid& grid) {
  const double position = sum * grid.half / norm + grid.half;
  return position >= 0 && position < grid.side ? static_cast<int>(position) : 0;
}

/// The index of the cell that holds a direction of any length, up to 1e30 along each axis.
inline std::size_t cellOf(double x, double y, double z, const DirectionGrid& grid) {
  const double norm = std::abs(x) + std::abs(y) + std::abs(z);
  const double sign = std::signbit(z) ? -1.0 : 1.0;
  const int column = gridIndex(sign * (x + y), norm, grid);
  const int row = gridIndex(sign * (x - y), norm, grid);
  return static_cast<std::size_t>(row * grid.side + column);
}

/// One of the four triangles, by the signs of x and y in it.
struct FoldFace {
  double sign_x;
  double sign_y;
};

/// The triangle in which (s, t) lies.
inline FoldFace faceAt(double s, double t) {
  return {s + t < 0 ? -1.0 : 1.0, s - t < 0 ? -1.0 : 1.0};
}

/// The direction that is folded to (s, t) by the linear map of a face, which may be continued
/// beyond the face.
inline Eigen::Vector3d directionAt(double s, double t, FoldFace face) {
  const double x = (s + t) / 2;
  const double y = (s - t) / 2;
  return {x, y, 1 - face.sign_x * x - face.sign_y * y};
}

}  // namespace link_bounds
