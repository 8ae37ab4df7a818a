// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/threads/row_threads.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace link_bounds {

unsigned coreCount() {
  cpu_set_t usable;
  const bool is_known = sched_getaffinity(0, sizeof(usable), &usable) == 0;
  const auto count =
      is_known ? static_cast<unsigned>(CPU_COUNT(&usable)) : std::thread::hardware_concurrency();
  return std::max(1U, count);
}

void forRows(std::size_t begin, std::size_t end, unsigned threads, std::size_t at_once,
             const RowWork& work) {
  std::atomic<std::size_t> next{begin};
  const auto take = [&](unsigned thread) {
    for (;;) {
      const std::size_t first = next.fetch_add(at_once);
      if (first >= end) return;
      try {
        work(thread, first, std::min(first + at_once, end));
      } catch (...) {
        next = end;
        throw;
      }
    }
  };
  const std::size_t useful = end > begin ? (end - begin - 1) / at_once + 1 : 0;
  std::vector<std::future<void>> workers;
  try {
    for (unsigned thread = 1; thread < std::min<std::size_t>(threads, useful); ++thread)
      workers.push_back(std::async(std::launch::async, take, thread));
  } catch (const std::exception&) {
    // The system gives no more threads, or no memory for them: these do the work.
  }
  take(0);
  for (std::future<void>& worker : workers)
    worker.get();
}

}  // namespace link_bounds
