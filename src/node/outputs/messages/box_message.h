// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes boxes into messages.
#pragma once

#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "world/bodies/scene.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// Overwrites a message entry by entry and reuses its memory.
class BoxFiller {
 public:
  BoxFiller(AxisAlignedBoxArray& message, const std::string& frame);

  void add(const std::string& name, const BoxState& state);
  void addIncomplete(const std::string& name);

  /// Call after the last add() or addIncomplete().
  void finish();

 private:
  ros::Time timeOf(std::int64_t stamp);

  AxisAlignedBoxArray& message_;
  std::size_t boxes_ = 0;
  std::size_t incomplete_ = 0;
  std::int64_t newest_ = 0;
  std::int64_t stamp_ = 0;
  ros::Time time_;  ///< stamp_ as ROS time
};

/// Overwrites `message` with the boxes of links and objects. There must be a model.
void fillBoxes(const Scene& scene, AxisAlignedBoxArray& message);

/// The same for the boxes of a moment, with its header.
void fillBoxes(const Moment& moment, AxisAlignedBoxArray& message);

/// The same for the boxes of groups.
void fillGroups(const Scene& scene, AxisAlignedBoxArray& message);

}  // namespace link_bounds
