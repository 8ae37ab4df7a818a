// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Who sends transforms behind the newest stamp of a frame, which do not move it.
#pragma once

#include <ros/time.h>

#include <map>
#include <string>
#include <string_view>

namespace link_bounds {

class LatePublishers {
 public:
  /// A message of `publisher` had a transform of `frame` so far behind [s].
  void add(const std::string& publisher, std::string_view frame, double behind,
           ros::SteadyTime now);

  /// By name of the publisher: by how much, and with which frame last, in words that are not
  /// sanitised.
  using Texts = std::map<std::string, std::string>;

  /// Those of the last five seconds. Forgets the others.
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
