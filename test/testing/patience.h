// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Waiting in tests: with a deadline, so that what never comes is a failure and no hang.
#pragma once

#include <chrono>
#include <cstdlib>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

namespace link_bounds {

/// Deadlines are multiplied by this, as in patience.py.
inline double patience() {
  const char* text = std::getenv("LINK_BOUNDS_TEST_PATIENCE");
  return text ? std::stod(text) : 1;
}

inline std::chrono::steady_clock::duration deadline() {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(60 * patience()));
}

inline bool isNeverHopeless() {
  return false;
}

/// Checks `condition` every millisecond. Gives up after `limit`, or when `is_hopeless` returns
/// true.
template <class Condition, class IsHopeless = bool (*)()>
bool becomesTrue(const Condition& condition, std::chrono::duration<double> limit = deadline(),
                 const IsHopeless& is_hopeless = isNeverHopeless) {
  const auto begin = std::chrono::steady_clock::now();
  while (!condition()) {
    if (is_hopeless() || std::chrono::steady_clock::now() - begin > limit) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// Throws if there is none by the deadline.
template <class T>
T valueOf(std::future<T> result) {
  if (result.wait_for(deadline()) != std::future_status::ready)
    throw std::runtime_error("waited in vain");
  return result.get();
}

}  // namespace link_bounds
