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
  /// `state` ends it, such as "refused" or "late".
  RefusalLog(std::string what, std::string others, std::string state = "refused")
      : what_(std::move(what)), others_(std::move(others)), state_(std::move(state)) {}

  /// The line to log, if any. Within ten seconds, each name is reported at most once, max ten names
  /// are reported, and max one line says that further ones are refused.
  std::optional<std::string> line(const std::string& name, const std::string& reason,
                                  const std::string& publisher, ros::SteadyTime now);

  /// True if line() would return nothing for this name, so that its arguments are not needed.
  bool isQuiet(std::string_view name, ros::SteadyTime now);

  /// Names that were reported may be reported again.
  void forget();

 private:
  std::string what_;
  std::string others_;
  std::string state_;
  /// Time of the line, by name; only of the last ten seconds.
  std::map<std::string, ros::SteadyTime, std::less<>> reported_;
  ros::SteadyTime others_time_;  ///< time of the line about others; zero: never
};

}  // namespace link_bounds
