// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long the callbacks of the update thread take.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <utility>

namespace link_bounds {

/// Wall time of callbacks or computations [ms].
struct Durations {
  void add(double duration);
  /// 0 if there were none.
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }

  std::uint64_t count = 0;
  double sum = 0;
  double max = 0;
};

class CallbackTimes {
 public:
  /// Runs a callback and records its time, also when it throws. Returns its wall time [ms].
  template <class Body>
  double measure(Body&& body) {
    const Start start = begin();
    try {
      body();
    } catch (...) {
      end(start);
      throw;
    }
    return end(start);
  }

  /// The same for a callback that handles one tf message. The callback must not throw.
  template <class Body>
  void measureTf(Body&& body) {
    const double wall = measure(body);
    tf_.add(wall);
    recent_tf_.add(wall);
  }

  double longest() const { return longest_; }         ///< ms of wall time, since the start
  double longestCpu() const { return longest_cpu_; }  ///< ms of CPU time, since the start
  const Durations& tf() const { return tf_; }         ///< since the start

  /// The times of tf messages since the last call.
  Durations takeRecentTf() { return std::exchange(recent_tf_, Durations()); }

 private:
  struct Start {
    ros::SteadyTime wall;
    double cpu_ms;
  };

  static Start begin();
  /// Returns the wall time since `start` [ms].
  double end(const Start& start);

  double longest_ = 0;
  double longest_cpu_ = 0;
  Durations tf_;
  Durations recent_tf_;
};

}  // namespace link_bounds
