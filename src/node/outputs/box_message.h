// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes as messages.
#pragma once

#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/scene/scene.h"

namespace link_bounds {

/// Adds entries to a message whose arrays keep their memory from one filling to the next.
class BoxFiller {
 public:
  BoxFiller(AxisAlignedBoxArray& message, const std::string& frame);

  void add(const std::string& name, const BoxState& state);

  /// To be called at the end.
  void finish();

 private:
  void addIncomplete(const std::string& name);
  ros::Time timeOf(std::int64_t stamp);

  AxisAlignedBoxArray& message_;
  std::size_t boxes_ = 0;
  std::size_t incomplete_ = 0;
  std::int64_t newest_ = 0;
  std::int64_t stamp_ = 0;
  ros::Time time_;  ///< of stamp_
};

/// The header that the boxes of this moment have. There must be a model.
std_msgs::Header headerOf(const Scene& scene);

/// Overwrites `message` with the boxes of links and objects; reuses its memory. There must be a
/// model.
void fillBoxes(const Scene& scene, AxisAlignedBoxArray& message);

/// The same for the groups.
void fillGroups(const Scene& scene, AxisAlignedBoxArray& message);

}  // namespace link_bounds
