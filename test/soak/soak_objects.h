// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects that appear, deform and disappear.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "testing/repeated.h"

namespace link_bounds {

/// Publishes from start() to stop(), on a thread of its own; stop() deletes all objects.
class SoakObjects {
 public:
  /// Objects follow `frames` in turn.
  SoakObjects(ros::NodeHandle& node, const std::string& publisher, std::vector<std::string> frames);
  ~SoakObjects() { stop(); }

  bool hasSubscriber() const { return publisher_.getNumSubscribers() > 0; }
  void start();
  void stop();
  std::uint64_t sent() const { return sent_; }  ///< objects

 private:
  void step();

  std::vector<std::string> frames_;
  ros::Publisher publisher_;
  std::atomic<std::uint64_t> sent_{0};
  std::uint64_t steps_ = 0;
  std::optional<Repeated> rounds_;  ///< ends before what it uses
};

}  // namespace link_bounds
