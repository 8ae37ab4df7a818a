// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What Eigen computes of two matrices, in plain numbers: objects that are compiled with different
// flags share it.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace link_bounds {

using SixteenNumbers = std::array<double, 16>;

/// The products of matrices and poses that the library is made of.
struct EigenBits {
  SixteenNumbers matrix;
  SixteenNumbers pose;
  std::array<double, 4> vector;
};

namespace {  // each object has its own

inline EigenBits eigenBits(const SixteenNumbers& first, const SixteenNumbers& second) {
  const Eigen::Matrix4d a(first.data()), b(second.data());
  Eigen::Affine3d pose, other;
  pose.matrix().topRows<3>() = a.topRows<3>();
  other.matrix().topRows<3>() = b.topRows<3>();
  pose.makeAffine();
  other.makeAffine();
  EigenBits bits;
  Eigen::Map<Eigen::Matrix4d>(bits.matrix.data()) = a * b;
  Eigen::Map<Eigen::Matrix4d>(bits.pose.data()) = (pose * other).matrix();
  Eigen::Map<Eigen::Vector4d>(bits.vector.data()) = a * b.col(0);
  return bits;
}

}  // namespace

/// As eigenBits(), compiled with -march=haswell where that is possible.
EigenBits haswellBits(const SixteenNumbers& first, const SixteenNumbers& second);

}  // namespace link_bounds
