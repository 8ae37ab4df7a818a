// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How old boxes are, and how long the machine itself makes programs wait.
#pragma once

#include <ros/time.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

namespace link_bounds {

/// The age of a tf message is the wall time from sending it until boxes come that are as new as it.
/// So a sender that is late makes no boxes old. Messages are known by their stamps.
class Ages {
 public:
  /// To be called right before the tf message is sent. Stamps are unique, in any order.
  void send(ros::Time stamp);

  /// To be called when boxes of that stamp come.
  void answer(ros::Time stamp);

  bool isAllAnswered() const;

  /// How long the oldest unanswered message has waited [ms]; 0 if there is none.
  double waiting() const;

  /// As entries of a JSON object, without braces. What is unanswered is as old as it is now.
  void print(std::ostream& out) const;

 private:
  using Clock = std::chrono::steady_clock;

  double waitingSince(std::size_t number) const;

  mutable std::mutex mutex_;  ///< guards what follows
  std::vector<Clock::time_point> sent_;
  std::unordered_map<std::uint64_t, std::size_t> numbers_;  ///< by stamp [ns]
  std::vector<double> ages_;                                ///< of the answered messages [ms]
  std::size_t updates_ = 0;                                 ///< boxes newer than those before
};

/// The longest time for which a thread that wants to run was not let [ms].
class StallWatch {
 public:
  StallWatch();
  ~StallWatch();
  StallWatch(const StallWatch&) = delete;
  StallWatch& operator=(const StallWatch&) = delete;

  double longest() const { return longest_; }

 private:
  void run();

  std::atomic<bool> ends_{false};
  std::atomic<double> longest_{0};
  std::thread thread_;
};

}  // namespace link_bounds
