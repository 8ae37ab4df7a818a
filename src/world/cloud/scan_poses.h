// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the links are from the sensor's frame while it scans.
//
// tf2's poses are computed at some moments. Between two of them a point of the sensor's frame goes,
// in the frame of a link, nearly the straight way. deviation_bound.h proves how far it leaves it,
// and there are as many moments as keep that below half a millimetre. It counts twice: of a point,
// and of the padding, which grows by it. So no point that is farther than a millimetre from the
// padded link is taken for a point of it.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "world/cloud/cloud_layout.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// The largest error of a point in the frame of a link, from the motion during a scan [m].
constexpr double kMaxMotionError = 5e-4;

/// A link and the box that its points can be in, in its own frame.
struct ScannedLink {
  TransformBuffer::Frame frame;
  Aabb box;
};

/// One link from the sensor.
struct LinkMotion {
  std::vector<Eigen::Matrix<double, 3, 4>> link_from_sensor;  ///< by moment
  Aabb box;  ///< in the sensor's frame: outside it, nothing is in the link's box at any time
  double error = 0;  ///< of a point of that box, or within the range, between two moments [m]
};

struct ScanPoses {
  std::vector<std::int64_t> moments;  ///< [ns], ascending
  std::vector<LinkMotion> links;
  Aabb box;               ///< around all links' boxes
  std::string problem;    ///< why there are no poses, in words; "" if there are
  bool may_come = false;  ///< with tf that has not been received yet
};

/// Links without a finite box are left out: their own box is empty. Errors hold for points up to
/// `range` from the sensor [m], too. Transforms that are farther apart than `timeout` [s; 0: never]
/// do not tell where a link is between them.
ScanPoses scanPoses(const TransformBuffer& tf, TransformBuffer::Frame sensor,
                    const std::vector<ScannedLink>& links, TimeSpan span, double range = 0,
                    double timeout = 0);

/// Where points of the sensor's frame are in the frames of links at one time after the other.
class ScanCursor {
 public:
  explicit ScanCursor(const ScanPoses& poses) : poses_(poses) {}

  /// Finds the two moments around that time [ns]; fast if it is near the last one.
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
  double part_ = 0;  ///< of the way to the next moment
};

}  // namespace link_bounds
