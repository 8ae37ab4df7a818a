// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// For threads that compute long: where cores are scarce, the scheduler prefers the other threads,
// which publish boxes.
#pragma once

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace link_bounds {

/// Applies to the calling thread.
inline void beNice() {
  constexpr int kNiceness = 10;  // as of the command nice
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  setpriority(PRIO_PROCESS, thread, kNiceness);  // if it is refused, nothing is lost
}

}  // namespace link_bounds
