// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Many rows of joint values on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace link_bounds {

/// Rows begin <= row < end, on the thread of that number.
using RowWork = std::function<void(unsigned thread, std::size_t begin, std::size_t end)>;

/// Calls `work` for all rows, so many at once, on so many threads, which are numbered from 0.
/// Returns when all is done. Throws what one of them threw.
void forRows(std::size_t begin, std::size_t end, unsigned threads, std::size_t at_once,
             const RowWork& work);

/// One per core.
unsigned coreCount();

}  // namespace link_bounds
