// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps directions to the square that they are folded to, and back.
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
#include <cstdint>
#include <cstring>

#include "geometry/support/table/direction_table.h"

namespace link_bounds {

/// A number added to kShifter leaves its integer part and kFraction bits of its fraction in the low
/// bits of the sum, which is faster than a conversion. NaN leaves arbitrary bits.
constexpr int kFraction = 20;
constexpr double kShifter = 1.5 * (1ll << (52 - kFraction));

/// The column or row for a coordinate -1 <= sum / norm <= 1 of the square; `turned` is grid.half
/// with the sign of z. A zero direction has norm 0; all points are extreme for it, so any cell will
/// do.
inline std::uint32_t gridIndex(double sum, double norm, double turned, const DirectionGrid& grid) {
  const double shifted = sum * turned / norm + (grid.half + kShifter);
  std::uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof(bits));
  return static_cast<std::uint32_t>(bits >> kFraction);
}

/// The index of the cell that holds a direction of any length, up to 1e30 along each axis. Near a
/// border the lists of both cells are valid, but their results may differ in the last bit: so every
/// instruction path computes the index with exactly these operations.
inline std::size_t cellOf(double x, double y, double z, const DirectionGrid& grid) {
  const double norm = std::abs(x) + std::abs(y) + std::abs(z);
  const double turned = std::signbit(z) ? -grid.half : grid.half;
  const std::uint32_t column = gridIndex(x + y, norm, turned, grid);
  const std::uint32_t row = gridIndex(x - y, norm, turned, grid);
  return ((row << grid.log2_side) + column) & grid.mask;
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
