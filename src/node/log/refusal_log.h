// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Throttled log lines about refused input: enough to find the publisher.
#pragma once

#include <ros/time.h>

#include <optional>
#include <set>
#include <string>
#include <utility>

namespace link_bounds {

class RefusalLog {
 public:
  /// `what` and `others` begin a line, such as "a transform of" and "transforms of further frames".
  RefusalLog(std::string what, std::string others)
      : what_(std::move(what)), others_(std::move(others)) {}

  /// The line to log, if any. In ten seconds each name is reported once, and at most ten names are;
  /// then one line says that others are refused, too.
  std::optional<std::string> line(const std::string& name, const std::string& reason,
                                  const std::string& publisher, ros::SteadyTime now);

  /// Names that were reported may be reported again.
  void forget() { reported_.clear(); }

 private:
  std::string what_;
  std::string others_;
  std::set<std::string> reported_;  ///< names, since begin_
  ros::SteadyTime begin_;
};

}  // namespace link_bounds
