// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// For threads with long computations: when cores are scarce, the scheduler prefers the other
// threads, which publish boxes.
#pragma once

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace link_bounds {

/// The argument of sched_setattr(2). glibc declares it only since 2.41.
struct SchedulerAttributes {
  std::uint32_t size = sizeof(SchedulerAttributes);
  std::uint32_t policy = 0;
  std::uint64_t flags = 0;
  std::int32_t niceness = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0;  ///< nanoseconds
  std::uint64_t deadline = 0;
  std::uint64_t period = 0;
};

/// Lowers the priority of the calling thread. Linux before 6.12 ignores the length of the time
/// slice. For the gain of slices and SCHED_BATCH see doc/reliability.md, "Under load".
inline void beNice() {
  constexpr int kNiceness = 10;                       // default of the command nice
  constexpr std::uint64_t kLongestSlice = 100000000;  // ns; the max in Linux
  SchedulerAttributes attributes;
  attributes.policy = SCHED_BATCH;  // preempts no other thread when it wakes up
  attributes.niceness = kNiceness;
  attributes.runtime = kLongestSlice;  // a thread with a shorter slice preempts it at once
  if (syscall(SYS_sched_setattr, 0, &attributes, 0) == 0) return;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  setpriority(PRIO_PROCESS, thread, kNiceness);  // if this fails, only the priority stays higher
}

}  // namespace link_bounds
