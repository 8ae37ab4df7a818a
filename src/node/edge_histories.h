// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// tf2's histories of transforms, one per edge, and poses between any two frames at a time.
//
// tf2's BufferCore has the same inside, but it cannot forget a single edge, prints a line for each
// transform it refuses, and looks up names for each pose.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/time_cache.h>

#include <memory>
#include <optional>
#include <vector>

#include "frame_tree.h"

namespace link_bounds {

/// A rotation, then a translation, in tf2's arithmetic.
struct Tf2Pose {
  tf2::Quaternion rotation{0, 0, 0, 1};
  tf2::Vector3 translation{0, 0, 0};
};

class EdgeHistories {
 public:
  using Frame = FrameTree::Frame;

  /// False if tf2 refuses: the stamp is there already, or too old. The first transform decides
  /// whether an edge is static.
  bool insert(const geometry_msgs::TransformStamped& transform, Frame child, Frame parent,
              bool is_static);

  /// Static edges stay.
  void clear();
  void clear(Frame child);

  /// By the edges as they were at that time, interpolated; at time 0 the newest of each edge.
  /// Nothing if a history does not reach the time.
  std::optional<Tf2Pose> pose(Frame target, Frame source, ros::Time time) const;

 private:
  struct Step {
    Frame frame;
    Tf2Pose frame_from_source;
  };

  /// Reads one edge; false if its history does not reach the time.
  bool read(Frame child, ros::Time time, Tf2Pose& parent_from_child, Frame& parent) const;
  void climb(Frame source, Frame target, ros::Time time) const;

  /// By child. shared_ptr, because tf2's interface has no virtual destructor.
  std::vector<std::shared_ptr<tf2::TimeCacheInterface>> caches_;
  mutable std::vector<Step> steps_;  ///< the last climb, from the source upwards
  mutable WalkMarks marks_;
};

}  // namespace link_bounds
