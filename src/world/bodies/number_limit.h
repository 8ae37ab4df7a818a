// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The range of numbers in messages for which boxes can be computed.
#pragma once

#include <cmath>

namespace link_bounds {

/// Max absolute value [m]: a pose may contain up to 1e30; a tenth leaves room for rotating and
/// adding.
constexpr double kMaxNumber = 1e29;

/// False for NaN.
inline bool isBelowLimit(double value) {
  return std::abs(value) <= kMaxNumber;
}

template <class Vector>
bool isBelowLimit(const Vector& v) {
  return isBelowLimit(v.x) && isBelowLimit(v.y) && isBelowLimit(v.z);
}

}  // namespace link_bounds
