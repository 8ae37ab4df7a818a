// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions for all targets of libFuzzer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// libFuzzer's own mutation; returns the new size.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace link_bounds {

/// Aborts unless the promise is kept; libFuzzer then reports the input.
inline void require(bool is_kept, const char* promise) {
  if (is_kept) return;
  std::fprintf(stderr, "BROKEN: %s\n", promise);
  std::abort();
}

inline std::size_t replaceInput(const std::string& content, std::uint8_t* data,
                                std::size_t max_size) {
  const std::size_t size = std::min(content.size(), max_size);
  std::copy_n(content.begin(), size, data);
  return size;
}

/// Replaces the nearly empty inputs that libFuzzer starts with, and sometimes others, by a seed, so
/// that no corpus has to be stored. Returns 0 if it replaces nothing.
inline std::size_t seeded(const std::vector<std::string>& seeds, unsigned random,
                          std::uint8_t* data, std::size_t size, std::size_t max_size) {
  constexpr unsigned kOneIn = 500;
  if (size > 1 && random % kOneIn != 0) return 0;
  return replaceInput(seeds[random / kOneIn % seeds.size()], data, max_size);
}

}  // namespace link_bounds
