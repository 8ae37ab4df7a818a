// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Throttled log lines about refused input: enough to find the publisher.
#pragma once

#include <ros/time.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace link_bounds {

class RefusalLog {
 public:
  /// `what` and `others` begin a line, such as "a transform of" and "transforms of further frames".
  /// `state` is what is wrong with them.
  RefusalLog(std::string what, std::string others, std::string state = "refused")
      : what_(std::move(what)), others_(std::move(others)), state_(std::move(state)) {}

  /// The line to log, if any. In any ten seconds each name is reported at most once, at most ten
  /// names are, and one line says that others are refused, too.
  std::optional<std::string> line(const std::string& name, const std::string& reason,
                                  const std::string& publisher, ros::SteadyTime now);

  /// True if line() would say nothing of this name: then its arguments need not be made.
  bool isQuiet(std::string_view name, ros::SteadyTime now);

  /// Names that were reported may be reported again.
  void forget();

 private:
  std::string what_;
  std::string others_;
  std::string state_;
  /// When, of names in the last ten seconds.
  std::map<std::string, ros::SteadyTime, std::less<>> reported_;
  ros::SteadyTime others_time_;  ///< of the line about others; zero: never
};

}  // namespace link_bounds
