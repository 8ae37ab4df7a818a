// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that a thread calls now and then, or at a time, between the callbacks of its queue.
//
// Timers of roscpp wake up a thread of their own, and that one the thread of the callbacks: with
// them an idle node of 50 links took 1.1 ms of processor time more per second, in each of four
// pairs of runs (`scripts/bench end-to-end` prints what an idle node takes).
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

  /// A function that is called once, whenever a time has been set.
  using Alarm = std::size_t;
  Alarm addAlarm(std::function<void()> function) {
    due_.push_back({std::nullopt, std::nullopt, std::move(function)});
    return due_.size() - 1;
  }

  /// Replaces the time that was set; nothing: it is not called.
  void setAlarm(Alarm alarm, std::optional<ros::SteadyTime> time) { due_[alarm].next = time; }

  /// Calls what is due. What is late is called once. The functions may set alarms.
  void callDue() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (Entry& entry : due_) {
      if (!entry.next || *entry.next > now) continue;
      entry.next.reset();
      entry.function();
      // From now on, or a function that takes longer than its period would always be due.
      if (entry.period) entry.next = ros::SteadyTime::now() + *entry.period;
    }
  }

  /// How long nothing is due; a day if nothing ever is.
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
    std::optional<ros::WallDuration> period;  ///< none: an alarm
    std::function<void()> function;
  };

  std::vector<Entry> due_;
};

}  // namespace link_bounds
