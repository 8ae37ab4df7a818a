// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long the callbacks of the update thread take.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

namespace link_bounds {

/// Wall time of callbacks [ms].
struct Durations {
  void add(double duration);
  /// 0 if there are none.
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }

  std::uint64_t count = 0;
  double sum = 0;
  double max = 0;
};

class CallbackTimes {
 public:
  /// Runs a callback and records its time, also when it throws. Returns its wall time [ms].
  double measure(const std::function<void()>& body);

  /// The same for a callback that handles one tf message, and throws nothing.
  void measureTf(const std::function<void()>& body);

  double longest() const { return longest_; }         ///< ms of wall time, since the start
  double longestCpu() const { return longest_cpu_; }  ///< ms of CPU time, since the start
  const Durations& tf() const { return tf_; }         ///< since the start

  /// Those since the last call.
  Durations takeRecentTf() { return std::exchange(recent_tf_, Durations()); }

 private:
  double longest_ = 0;
  double longest_cpu_ = 0;
  Durations tf_;
  Durations recent_tf_;
};

}  // namespace link_bounds
