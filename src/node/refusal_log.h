// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is said about refused transforms: enough to find the publisher, never a flood.
#pragma once

#include <ros/time.h>

#include <optional>
#include <set>
#include <string>

namespace link_bounds {

class RefusalLog {
 public:
  /// The line to write, if any: each frame is told of once in ten seconds, and at most ten frames.
  std::optional<std::string> line(const std::string& child_frame, const std::string& reason,
                                  const std::string& publisher, ros::SteadyTime now);

 private:
  std::set<std::string> told_;  ///< frames of the current ten seconds
  ros::SteadyTime begin_;
};

}  // namespace link_bounds
