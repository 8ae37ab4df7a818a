// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated time and tf at 100 Hz, with jumps back in time.
#pragma once

#include <ros/node_handle.h>

#include <cstdint>

#include "node/load/ages.h"

namespace link_bounds {

constexpr double kStormPeriod = 0.01;  // s, of tf

/// Not thread-safe.
class StormSender {
 public:
  StormSender(ros::NodeHandle& node, std::size_t links, Ages& ages);

  bool hasSubscriber() const;

  /// Time goes on by one period; the stamp of what was sent.
  ros::Time step();
  void jumpBack();
  std::uint64_t jumps() const { return jumps_; }

 private:
  void publishClock();

  std::size_t links_;
  Ages& ages_;
  ros::Publisher clock_publisher_;
  ros::Publisher tf_publisher_;
  ros::Time now_{1000};
  std::uint64_t steps_ = 0;
  std::uint64_t jumps_ = 0;
};

}  // namespace link_bounds
