// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Linear maps that are likely to find a hole in a table of directions.
#pragma once

#include "geometry/support/table/direction_fold.h"
#include "testing/brute_force.h"

namespace link_bounds {

/// A direction on the border between two cells of a grid, where both lists must serve.
inline Eigen::Vector3d borderDirection(brute_force::Random& random) {
  const int side = 8 << static_cast<int>(random.uniform(0, 4));
  const double s = -1 + 2 * std::floor(random.uniform(0, side + 1)) / side;
  const double t = random.uniform(-1, 1);
  const bool is_swapped = random.sign() > 0;
  const Eigen::Vector3d direction = directionAt(is_swapped ? t : s, is_swapped ? s : t,
                                                faceAt(is_swapped ? t : s, is_swapped ? s : t));
  return random.sign() * direction;
}

/// On the edges of the octahedron to which directions are folded, and beside them by a hair.
inline Eigen::Vector3d creaseDirection(brute_force::Random& random) {
  const double a = random.magnitude(-3, 3);
  const double b = random.magnitude(-3, 3);
  const double hair = random.sign() > 0 ? 0 : random.magnitude(-18, -9);
  const double zero = random.sign() > 0 ? 0.0 : -0.0;
  switch (static_cast<int>(random.uniform(0, 5))) {
    case 0:
      return {random.sign() * a, hair, zero};
    case 1:
      return {a, random.sign() * a, zero};
    case 2:
      return {random.sign() * a, random.sign() * b, zero};
    case 3:
      return {zero, random.sign() * a, random.sign() * b};
    default:
      return {random.sign() * a, hair, random.sign() * b};
  }
}

/// What a pose should not contain but may: zeros, and numbers near the ends of the range.
inline Eigen::Vector3d oddDirection(brute_force::Random& random) {
  constexpr double kScales[] = {0.0, -0.0, 1e-310, 1e-40, 1e-3, 1e3, 1e30, -1e30};
  const double scale = kScales[static_cast<int>(random.uniform(0, 8))];
  return scale * random.vector(1);
}

inline Eigen::Matrix3d signedPermutation(brute_force::Random& random) {
  Eigen::Matrix3d map = Eigen::Matrix3d::Zero();
  const int first = static_cast<int>(random.uniform(0, 3));
  const int step = random.sign() > 0 ? 1 : 2;
  for (int k = 0; k < 3; ++k)
    map(k, (first + k * step) % 3) = random.sign();
  return map;
}

template <class Direction>
Eigen::Matrix3d rowsOf(Direction&& direction, brute_force::Random& random) {
  Eigen::Matrix3d map;
  for (int k = 0; k < 3; ++k)
    map.row(k) = direction(random);
  return map;
}

/// One of nine kinds in turn: random, coherent with the last, axis-aligned, nearly so, on borders,
/// on creases, sheared and mirrored, scaled, odd.
class LinearMaps {
 public:
  explicit LinearMaps(std::uint64_t seed) : random_(seed) {}

  Eigen::Matrix3d next() {
    switch (count_++ % 9) {
      case 0:
        return random_.rotation();
      case 1:
        coherent_ = Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 3).normalized()) * coherent_;
        return coherent_;
      case 2:
        return signedPermutation(random_);
      case 3:
        return signedPermutation(random_) *
               brute_force::turned(random_.magnitude(-16, -1), random_.vector(1));
      case 4:
        return rowsOf(borderDirection, random_);
      case 5:
        return rowsOf(creaseDirection, random_);
      case 6:
        return random_.affine(0).linear();
      case 7:
        return random_.rotation() * (random_.sign() > 0 ? 1e-3 : 1e3);
      default:
        return rowsOf(oddDirection, random_);
    }
  }

 private:
  brute_force::Random random_;
  Eigen::Matrix3d coherent_ = Eigen::Matrix3d::Identity();
  int count_ = 0;
};

}  // namespace link_bounds
