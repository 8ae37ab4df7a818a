// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points around a body, for bounds of its motion: how far it is from an axis, and how far it
// extends along a direction.
#pragma once

#include <vector>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// A line; for translations only its direction counts.
struct Axis {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit
};

/// Balls whose convex hull holds the body, in the frame of the body [m]. For cylinders the hull
/// exceeds that of the body by half a percent of their radius.
class BodyCloud {
 public:
  explicit BodyCloud(const Body& body);

  /// Upper bound of the distance of the body's points from the axis [m].
  double farthestFrom(const Axis& axis) const;

  /// Upper bound of the dot product of the body's points with `direction`.
  double support(const Eigen::Vector3d& direction) const;

  const Eigen::Vector3d& center() const { return center_; }
  double radius() const { return radius_; }        ///< of a sphere around center()
  double magnitude() const { return magnitude_; }  ///< no point is farther from the origin

 private:
  /// Some points near each other.
  struct Cluster {
    std::size_t begin;
    std::size_t end;
    Eigen::Vector3d center;
    double radius;  ///< no point is farther from the centre
    double swell;   ///< radius of the ball around each point
  };

  void addShape(const BodyShape& shape);
  void addClusters(std::size_t begin, std::size_t end, double swell);

  std::vector<Eigen::Vector3d> points_;
  std::vector<Cluster> clusters_;
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
  double magnitude_ = 0;
};

}  // namespace link_bounds
