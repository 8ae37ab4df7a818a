// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Directed sums for callers whose compiler may contract.
#include "link_bounds/geometry/box/rounding.h"

#include <cfloat>

#include "geometry/box/directed_sum.h"

namespace link_bounds {

static_assert(FLT_EVAL_METHOD == 0,
              "all proofs count one rounding per operation; on 32-bit x86, compile with -msse2 "
              "-mfpmath=sse");

double addUp(double a, double b) {
  return sumUp(a, b);
}

double addDown(double a, double b) {
  return sumDown(a, b);
}

}  // namespace link_bounds
