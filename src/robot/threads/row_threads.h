// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Many rows of work, such as sets of joint values, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace link_bounds {

/// Poses that one thread takes at once. They are consecutive, so that each search can begin where
/// the search of the row before ended.
constexpr std::size_t kPosesAtOnce = 32;

/// Rows begin <= row < end, on the thread of that number.
using RowWork = std::function<void(unsigned thread, std::size_t begin, std::size_t end)>;

/// Calls `work` for all rows, `at_once` rows per call, on `threads` threads. These are numbered
/// from 0, which is the calling one. Where the system gives fewer threads, these do the work.
/// Returns when all is done. Throws what one of them threw; rows that have not begun then are left
/// out.
void forRows(std::size_t begin, std::size_t end, unsigned threads, std::size_t at_once,
             const RowWork& work);

/// Cores that this process may use, as taskset and cpusets say.
unsigned coreCount();

}  // namespace link_bounds
