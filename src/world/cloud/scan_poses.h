// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of the links relative to the sensor while it scans.
//
// tf2's poses are computed at some moments. Between two of them, a point that is fixed in the
// sensor's frame moves nearly along a straight line in the frame of a link. deviation_bound.h
// proves a bound on its distance from that line, and enough moments are used to keep this below 0.5
// mm. The error counts twice: once for the point, and once because the padding is extended by it.
// So no point farther than 1 mm from the padded link is taken for a point of the link.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "world/cloud/cloud_layout.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// The max error of a point in the frame of a link, due to the motion during a scan [m].
constexpr double kMaxMotionError = 5e-4;

/// A link, and a box in its frame that contains all points of the link.
struct ScannedLink {
  TransformBuffer::Frame frame;
  Aabb box;
};

/// The motion of one link relative to the sensor.
struct LinkMotion {
  std::vector<Eigen::Matrix<double, 3, 4>> link_from_sensor;  ///< by moment
  Aabb box;          ///< in the sensor's frame; contains the link's box at all times
  double error = 0;  ///< max error in that box or within `range`, between moments [m]
};

struct ScanPoses {
  std::vector<std::int64_t> moments;  ///< [ns], ascending
  std::vector<LinkMotion> links;
  Aabb box;               ///< around the boxes of all links
  std::string problem;    ///< why there are no poses, in words; "" if there are
  bool may_come = false;  ///< later transforms may solve the problem
};

/// Links with an empty box are skipped, and their result has an empty box. Errors also hold for
/// points within `range` of the sensor [m]. Between transforms that are farther apart than
/// `timeout` [s; 0: never], the pose of a link counts as unknown.
ScanPoses scanPoses(const TransformBuffer& tf, TransformBuffer::Frame sensor,
                    const std::vector<ScannedLink>& links, TimeSpan span, double range = 0,
                    double timeout = 0);

/// Transforms points from the sensor's frame to the frames of links, at one time after the other.
class ScanCursor {
 public:
  explicit ScanCursor(const ScanPoses& poses) : poses_(poses) {}

  /// Finds the two moments around `time` [ns]; fast if these are the same as in the last call.
  void seek(std::int64_t time);

  Eigen::Vector3d inLink(const LinkMotion& link, const Eigen::Vector3d& point) const {
    const auto& pose = link.link_from_sensor[moment_];
    Eigen::Vector3d place = pose.leftCols<3>() * point + pose.col(3);
    if (part_ > 0) {
      const auto& next = link.link_from_sensor[moment_ + 1];
      place += part_ * (next.leftCols<3>() * point + next.col(3) - place);
    }
    return place;
  }

 private:
  const ScanPoses& poses_;
  std::size_t moment_ = 0;
  double part_ = 0;  ///< fraction of the time to the next moment
};

}  // namespace link_bounds
