// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of messages that are filled again and again.
#pragma once

#include <vector>

namespace link_bounds {

/// Keeps memory for what may come back soon, not for ten thousand objects that are gone.
template <class T>
void shorten(std::vector<T>& entries, std::size_t size) {
  constexpr std::size_t kSpare = 1000;
  entries.resize(size);
  if (entries.capacity() > 2 * (size + kSpare)) entries.shrink_to_fit();
}

}  // namespace link_bounds
