// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of messages that boxes can be computed from.
#pragma once

#include <cmath>

namespace link_bounds {

/// A pose may contain up to 1e30 [m]; a tenth of it leaves room for rotating and adding.
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
