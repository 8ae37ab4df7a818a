// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is said about what is refused: enough to find the publisher, never a flood.
#pragma once

#include <ros/time.h>

#include <optional>
#include <set>
#include <string>
#include <utility>

namespace link_bounds {

class RefusalLog {
 public:
  /// `what` is refused, "a transform of" something; `others` names many, "transforms of further
  /// frames".
  RefusalLog(std::string what, std::string others)
      : what_(std::move(what)), others_(std::move(others)) {}

  /// The line to write, if any: each name is told of once in ten seconds, and at most ten names.
  std::optional<std::string> line(const std::string& name, const std::string& reason,
                                  const std::string& publisher, ros::SteadyTime now);

  /// What was told is told again.
  void forget() { told_.clear(); }

 private:
  std::string what_;
  std::string others_;
  std::set<std::string> told_;  ///< names of the current ten seconds
  ros::SteadyTime begin_;
};

}  // namespace link_bounds
