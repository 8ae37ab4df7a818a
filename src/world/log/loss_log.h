// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Decides which lasting losses are logged: enough to notice, never a flood.
#pragma once

#include <ros/time.h>

#include <map>
#include <string>
#include <vector>

namespace link_bounds {

/// A loss is a name for something that is wrong, such as a link without a transform. It is reported
/// once, when it has lasted for five seconds of steady time, and again only after it ended in
/// between.
class LossLog {
 public:
  /// To be called a few times per second with the names of all that is lost at `now`. Returns the
  /// indices of those to report. Between two results that are not empty, there are at least five
  /// seconds; losses that become due meanwhile wait.
  std::vector<std::size_t> due(const std::vector<std::string>& lost, ros::SteadyTime now);

  /// To be called instead of due() while another loss explains these. Their five seconds start
  /// again.
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
