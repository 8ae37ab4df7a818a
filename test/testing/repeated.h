// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A function that a thread calls again and again.
#pragma once

#include <ros/init.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

namespace link_bounds {

/// Calls a function periodically, on a thread of its own, until it is destroyed. After a delay it
/// calls without pause until it has caught up, so the mean rate holds.
class Repeated {
 public:
  Repeated(std::chrono::duration<double> period, std::function<void()> function)
      : thread_([this, period, function = std::move(function)] {
          auto due = Clock::now();
          while (!ends_ && ros::ok()) {
            function();
            due += std::chrono::duration_cast<Clock::duration>(period);
            while (!ends_ && Clock::now() < due)
              std::this_thread::sleep_until(std::min(due, Clock::now() + kMaxSleep));
          }
        }) {}
  ~Repeated() {
    ends_ = true;
    thread_.join();
  }
  Repeated(const Repeated&) = delete;
  Repeated& operator=(const Repeated&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kMaxSleep{100};

  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace link_bounds
