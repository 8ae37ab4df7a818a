// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/posed/row_threads.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace link_bounds {

unsigned coreCount() {
  return std::max(1U, std::thread::hardware_concurrency());
}

void forRows(std::size_t begin, std::size_t end, unsigned threads, std::size_t at_once,
             const RowWork& work) {
  std::atomic<std::size_t> next{begin};
  const auto take = [&](unsigned thread) {
    for (;;) {
      const std::size_t first = next.fetch_add(at_once);
      if (first >= end) return;
      work(thread, first, std::min(first + at_once, end));
    }
  };
  std::vector<std::future<void>> workers;
  try {
    for (unsigned thread = 1; thread < threads; ++thread)
      workers.push_back(std::async(std::launch::async, take, thread));
  } catch (const std::system_error&) {
    // The system gives no more threads: these do the work.
  }
  take(0);
  for (std::future<void>& worker : workers)
    worker.get();
}

}  // namespace link_bounds
