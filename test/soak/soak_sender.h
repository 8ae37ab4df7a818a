// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated time and tf at 1 kHz, with jumps back in time.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <optional>

#include "link_bounds/robot/urdf/robot.h"
#include "testing/repeated.h"

namespace link_bounds {

/// The constructor publishes the clock and the fixed joints. Publishes the moving ones from start()
/// to stop(), on a thread of its own.
class SoakSender {
 public:
  SoakSender(ros::NodeHandle& node, const Robot& robot);

  bool hasSubscriber() const;
  void start();
  void stop() { steps_.reset(); }
  std::uint64_t sent() const { return sent_; }    ///< messages to /tf
  std::uint64_t jumps() const { return jumps_; }  ///< of the clock

 private:
  void step();
  void publishClock();

  const Robot& robot_;
  ros::Publisher clock_publisher_;
  ros::Publisher tf_publisher_;
  ros::Publisher tf_static_publisher_;
  ros::Time now_{1000};
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<std::uint64_t> jumps_{0};
  std::optional<Repeated> steps_;  ///< ends before what it uses
};

}  // namespace link_bounds
