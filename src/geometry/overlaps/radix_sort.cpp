// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One stable counting sort per digit, the lowest digit first.
#include "geometry/overlaps/radix_sort.h"

#include <algorithm>
#include <array>

namespace link_bounds {
namespace {

constexpr int kMostDigitBits = 11;  // the counters of a digit stay in the first cache

/// Where the next value of each digit goes.
using Places = std::array<std::uint32_t, std::size_t{1} << kMostDigitBits>;

void sortByDigit(const std::vector<std::uint64_t>& from, std::vector<std::uint64_t>& to, int shift,
                 int bits) {
  const std::size_t count = std::size_t{1} << bits;
  const std::uint64_t mask = count - 1;
  Places places;
  std::fill_n(places.begin(), count, 0u);
  for (const std::uint64_t value : from)
    ++places[(value >> shift) & mask];
  std::uint32_t place = 0;
  for (std::size_t digit = 0; digit < count; ++digit) {
    const std::uint32_t occurrences = places[digit];
    places[digit] = place;
    place += occurrences;
  }
  for (const std::uint64_t value : from)
    to[places[(value >> shift) & mask]++] = value;
}

}  // namespace

void radixSort(std::vector<std::uint64_t>& values, std::vector<std::uint64_t>& scratch, int low_bit,
               int high_bit) {
  scratch.resize(values.size());
  const int digits = (high_bit - low_bit + kMostDigitBits - 1) / kMostDigitBits;
  for (int digit = 0; digit < digits; ++digit) {
    const int from = low_bit + (high_bit - low_bit) * digit / digits;
    const int to = low_bit + (high_bit - low_bit) * (digit + 1) / digits;
    sortByDigit(values, scratch, from, to - from);
    values.swap(scratch);
  }
}

}  // namespace link_bounds
