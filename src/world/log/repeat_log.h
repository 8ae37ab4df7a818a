// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One log line for something that happens again and again.
#pragma once

#include <ros/time.h>

#include <cstddef>
#include <string>

namespace link_bounds {

class RepeatLog {
 public:
  /// To be called at each occurrence. Returns the line to log, max one in ten seconds: the text and
  /// the number of occurrences since the last line; otherwise "".
  std::string line(const std::string& text, ros::SteadyTime now) {
    ++count_;
    if (!last_.isZero() && now - last_ < ros::WallDuration(10.0)) return "";
    const std::string times = count_ > 1 ? " (" + std::to_string(count_) + " times)" : "";
    last_ = now;
    count_ = 0;
    return text + times;
  }

 private:
  std::size_t count_ = 0;  ///< since the last line
  ros::SteadyTime last_;   ///< zero before the first line
};

}  // namespace link_bounds
