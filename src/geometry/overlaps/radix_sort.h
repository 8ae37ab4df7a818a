// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sorting whole numbers digit by digit, in time linear in their number.
#pragma once

#include <cstdint>
#include <vector>

namespace link_bounds {

/// Sorts by the bits from `low_bit` up to, not including, `high_bit`; what has these in common
/// stays in its order. `scratch` is memory for a copy.
void radixSort(std::vector<std::uint64_t>& values, std::vector<std::uint64_t>& scratch, int low_bit,
               int high_bit);

}  // namespace link_bounds
