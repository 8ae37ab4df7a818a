// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that a thread calls now and then, between the callbacks of its queue.
//
// Timers of roscpp wake up a thread of their own, and that one the thread of the callbacks: with
// them an idle node of 50 links took 1.1 ms of processor time more per second, in each of four
// pairs of runs (`scripts/bench end-to-end` prints what an idle node takes).
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace link_bounds {

class Periodic {
 public:
  /// The first call is one period from now.
  void add(ros::WallDuration period, std::function<void()> function) {
    due_.push_back({ros::SteadyTime::now() + period, period, std::move(function)});
  }

  /// Calls what is due. What is late is called once.
  void callDue() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (Entry& entry : due_) {
      if (entry.next > now) continue;
      entry.next = now + entry.period;
      entry.function();
    }
  }

  /// How long nothing is due, but at most `limit`.
  ros::WallDuration rest(ros::WallDuration limit) const {
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (const Entry& entry : due_)
      limit = std::min(limit, std::max(entry.next - now, ros::WallDuration(0)));
    return limit;
  }

 private:
  struct Entry {
    ros::SteadyTime next;
    ros::WallDuration period;
    std::function<void()> function;
  };

  std::vector<Entry> due_;
};

}  // namespace link_bounds
