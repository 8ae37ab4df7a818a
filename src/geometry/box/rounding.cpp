// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Directed sums for callers whose compiler may contract.
#include "link_bounds/geometry/box/rounding.h"

#include "geometry/box/directed_sum.h"

namespace link_bounds {

double addUp(double a, double b) {
  return sumUp(a, b);
}

double addDown(double a, double b) {
  return sumDown(a, b);
}

}  // namespace link_bounds
