// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A clock, and the words for each way to end early.
#include "link_bounds/robot/mesh/mesh_limits.h"

#include <algorithm>
#include <chrono>
#include <sstream>

#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMaxTimeout = 1e8;  // s; three years, whose nanoseconds fit the clock

}  // namespace

CheckInterrupt meshDeadline(const MeshLimits& limits, std::function<bool()> is_cancelled) {
  const std::chrono::duration<double> wait(std::min(limits.timeout, kMaxTimeout));
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(wait);
  return [end, limits, is_cancelled = std::move(is_cancelled)] {
    if (is_cancelled && is_cancelled()) {
      throw MeshError("loading it was cancelled", MeshFault::kCancelled);
    }
    if (Clock::now() >= end) throwTooSlow(limits);
  };
}

void throwTooSlow(const MeshLimits& limits) {
  std::ostringstream reason;
  reason << "loading it takes longer than " << limits.timeout << " s";
  throw MeshError(reason.str(), MeshFault::kTooSlow);
}

}  // namespace link_bounds
