// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/box/eigen_bits.h"

namespace link_bounds {

EigenBits haswellBits(const SixteenNumbers& first, const SixteenNumbers& second) {
  return eigenBits(first, second);
}

}  // namespace link_bounds
