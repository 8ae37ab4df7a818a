// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A walk over memory, and some thousand small functions.
#include "bench/common/cold.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace link_bounds::bench {
namespace {

constexpr std::size_t kBytes = 96u << 20;  ///< three times the largest cache of common processors
constexpr std::size_t kLine = 64;
constexpr std::size_t kFunctions = 2048;  ///< of about 100 bytes each

volatile std::uint64_t number = 1;

template <std::size_t i>
__attribute__((noinline)) void mix() {
  std::uint64_t value = number;
  for (const std::uint64_t step : {i + 1, 3 * i + 7, 5 * i + 11})
    value = (value ^ (value >> (1 + step % 31))) * (2 * step + 1) + (value < step ? i : step);
  number = value;
}

template <std::size_t... i>
constexpr std::array<void (*)(), sizeof...(i)> functions(std::index_sequence<i...>) {
  return {&mix<i>...};
}

}  // namespace

void emptyCaches() {
  static std::vector<std::uint8_t> memory(kBytes);
  for (std::size_t i = 0; i < kBytes; i += kLine)
    ++memory[i];
  static constexpr auto kMixers = functions(std::make_index_sequence<kFunctions>());
  for (const auto& mixer : kMixers)
    mixer();
}

}  // namespace link_bounds::bench
