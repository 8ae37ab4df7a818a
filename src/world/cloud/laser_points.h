// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The points that a laser scan stands for.
#pragma once

#include <sensor_msgs/LaserScan.h>

#include <string>
#include <vector>

#include "world/cloud/cloud_layout.h"

namespace link_bounds {

/// A point per range: where it was measured, and when. Ranges outside range_min to range_max give
/// points that are not finite.
class LaserPoints {
 public:
  explicit LaserPoints(const sensor_msgs::LaserScan& scan);
  LaserPoints(const LaserPoints&) = delete;
  LaserPoints& operator=(const LaserPoints&) = delete;

  const CloudPoints& points() const { return points_; }

  /// Why the scan cannot be read, and the remedy; "" if it can.
  const std::string& problem() const { return problem_; }

 private:
  struct Point {
    double x, y, z;
    double seconds;  ///< after the stamp
  };

  std::vector<Point> memory_;
  CloudPoints points_;
  std::string problem_;
};

}  // namespace link_bounds
