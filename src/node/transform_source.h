// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// tf as the node sees it: tf2 keeps the transforms and gives poses, a FrameTree beside it knows
// what arrived when.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "frame_tree.h"

namespace link_bounds {

struct StampedPose {
  Eigen::Isometry3d world_from_link;
  std::int64_t stamp = 0;  ///< nanoseconds; latest common time of the path, 0 if it is all static
};

class TransformSource {
 public:
  /// Adds the transforms of one message, received at `now`. Those that tf2 refuses change nothing.
  void add(const std::vector<geometry_msgs::TransformStamped>& transforms, bool is_static,
           ros::Time now);

  /// The pose at the latest common time, interpolated; as lookupTransform(target, source, 0).
  /// The quaternion is normalised; the result may still not be finite. Nothing if tf2 cannot say.
  std::optional<StampedPose> latest(const std::string& target, const std::string& source) const;

  /// Forgets everything that is not static, after a clock jump.
  void clear();

  FrameTree& tree() { return tree_; }
  const FrameTree& tree() const { return tree_; }

 private:
  tf2::BufferCore buffer_;
  FrameTree tree_;
};

}  // namespace link_bounds
