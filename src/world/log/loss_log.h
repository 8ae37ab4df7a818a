// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which losses that last are to be reported: enough to notice, never a flood.
#pragma once

#include <ros/time.h>

#include <map>
#include <string>
#include <vector>

namespace link_bounds {

/// A loss is something by name that is not right, such as a link without a transform. It is
/// reported once, when it has lasted for five seconds of wall time, and again only after it was
/// right in between.
class LossLog {
 public:
  /// To be called a few times per second with the names of all that is lost at `now`. Returns the
  /// indices of those to report. It returns any at most once in five seconds; others wait.
  std::vector<std::size_t> due(const std::vector<std::string>& lost, ros::SteadyTime now);

  /// Instead of due(), while a loss of something else explains these: five seconds begin again.
  void postpone(const std::vector<std::string>& lost, ros::SteadyTime now);

 private:
  struct Loss {
    ros::SteadyTime since;
    bool is_reported = false;
    bool is_current = false;
  };

  void observe(const std::vector<std::string>& lost, ros::SteadyTime now);

  std::map<std::string, Loss> losses_;
  ros::SteadyTime last_report_;
};

}  // namespace link_bounds
