// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that a thread calls periodically, or at a set time, between the callbacks of its queue.
//
// A timer of roscpp wakes up roscpp's timer thread, which then wakes up the thread of the
// callbacks. With timers an idle node of 50 links took 1.1 ms more processor time per second, in
// each of four pairs of runs (`scripts/bench end-to-end` prints the time of an idle node).
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace link_bounds {

class Periodic {
 public:
  /// The first call is one period from now.
  void add(ros::WallDuration period, std::function<void()> function) {
    due_.push_back({ros::SteadyTime::now() + period, period, std::move(function)});
  }

  /// A function that is called once each time a time is set.
  using Alarm = std::size_t;
  Alarm addAlarm(std::function<void()> function) {
    due_.push_back({std::nullopt, std::nullopt, std::move(function)});
    return due_.size() - 1;
  }

  /// Replaces the time of the alarm; nullopt switches the alarm off.
  void setAlarm(Alarm alarm, std::optional<ros::SteadyTime> time) { due_[alarm].next = time; }

  /// Calls each function that is due, once even if several periods have passed. The functions may
  /// set alarms.
  void callDue() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (Entry& entry : due_) {
      if (!entry.next || *entry.next > now) continue;
      entry.next.reset();
      entry.function();
      // Counts from now, because otherwise a function that takes longer than its period would
      // always be due.
      if (entry.period) entry.next = ros::SteadyTime::now() + *entry.period;
    }
  }

  /// The time until the next function is due; at most a day.
  std::chrono::nanoseconds rest() const {
    std::chrono::nanoseconds rest = std::chrono::hours(24);
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (const Entry& entry : due_)
      if (entry.next) rest = std::min(rest, std::chrono::nanoseconds((*entry.next - now).toNSec()));
    return std::max(rest, std::chrono::nanoseconds(0));
  }

 private:
  struct Entry {
    std::optional<ros::SteadyTime> next;
    std::optional<ros::WallDuration> period;  ///< nullopt for an alarm
    std::function<void()> function;
  };

  std::vector<Entry> due_;
};

}  // namespace link_bounds
