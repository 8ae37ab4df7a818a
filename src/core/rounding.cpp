// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Knuth's TwoSum gives the rounding error of a sum exactly, barring overflow.
#include "link_bounds/rounding.h"

namespace link_bounds {

double addUp(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  return error > 0 ? nextUp(sum) : sum;
}

double addDown(double a, double b) {
  return -addUp(-a, -b);
}

}  // namespace link_bounds
