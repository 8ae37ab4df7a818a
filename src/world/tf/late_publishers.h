// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishers of late transforms: older than the newest one of the frame, so they do not move it.
#pragma once

#include <ros/time.h>

#include <map>
#include <string>
#include <string_view>

namespace link_bounds {

class LatePublishers {
 public:
  /// A message of `publisher` had a transform of `frame` that was older than the newest one by
  /// `behind` [s].
  void add(const std::string& publisher, std::string_view frame, double behind,
           ros::SteadyTime now);

  /// By name of the publisher: a text with the delay and the frame of its last late transform, not
  /// sanitised.
  using Texts = std::map<std::string, std::string>;

  /// The publishers that were late in the last five seconds. Forgets the others.
  Texts take(ros::SteadyTime now);

  void clear() { publishers_.clear(); }

 private:
  struct Lateness {
    std::string frame;
    double behind = 0;
    ros::SteadyTime time;
  };

  std::map<std::string, Lateness> publishers_;  ///< by name
};

}  // namespace link_bounds
