// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One object: what was said of it, and its box.
#pragma once

#include <optional>
#include <string>

#include "followed_frame.h"
#include "link_bounds/box_groups.h"
#include "link_bounds/link_boxes.h"

namespace link_bounds {

/// What a publisher says of an object.
struct ObjectContent {
  BoundedLink bounded;     ///< what it draws, in the header frame; the name is that of the box
  std::string frame;       ///< header frame, tf name
  std::int64_t stamp = 0;  ///< nanoseconds; placed once, by the transform of then. 0: follows tf
  ros::Duration lifetime;  ///< ROS time from receipt; 0 or less: for ever
  std::string mesh_uri;    ///< of a mesh, whose shape has no points until they are loaded
  std::string publisher;   ///< name of the node that sent it

  bool follows() const { return stamp == 0; }
  bool isLoading() const {
    return !mesh_uri.empty() && bounded.isWhole() && !bounded.shapes.front().points;
  }
};

/// True if the same box follows from both: the publisher and the lifetime do not count.
bool isSame(const ObjectContent& a, const ObjectContent& b);

/// One object and its box.
struct LiveObject {
  enum class Trouble { kNone, kNoTransform, kStale, kPoseNotFinite, kWaiting, kGivenUp };

  ObjectContent content;
  LinkReach reach{content.bounded};
  FollowedFrame::Frame frame = 0;                      ///< content.frame
  std::optional<Eigen::Isometry3d> fixed_from_header;  ///< of an object that was placed once
  ros::Time received;
  Trouble trouble = Trouble::kNone;
  BoxState state;

  /// Why the object is incomplete, in words; "" if it is not.
  std::string reason() const;
};

}  // namespace link_bounds
