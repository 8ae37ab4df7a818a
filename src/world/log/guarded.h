// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Callbacks of a running node must not throw: roscpp does not catch exceptions.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <new>

namespace link_bounds {

/// A function that runs the body of a callback and lets no exception out.
using Guard = std::function<void(const std::function<void()>& body)>;

/// Logs an exception; max one line per second of steady time.
void logUnexpected(const std::exception& error);

/// The number of calls of logUnexpected() in this process.
std::uint64_t unexpectedErrors();

/// Calls `body`. An exception is logged.
template <class Body>
void guarded(Body&& body) {
  try {
    body();
  } catch (const std::exception& error) {
    logUnexpected(error);
  }
}

/// Ends the process with exit code 1 and one line on stderr. Allocates nothing.
[[noreturn]] void endWithoutMemory() noexcept;

/// Calls `body`, which changes the input of boxes or of the search for the robot's points. If
/// memory runs out half way, later results could be wrong, so the process ends.
template <class Body>
void completed(Body&& body) {
  try {
    body();
  } catch (const std::bad_alloc&) {
    endWithoutMemory();
  }
}

}  // namespace link_bounds
