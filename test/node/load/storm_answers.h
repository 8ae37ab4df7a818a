// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What one node says of one moment: boxes, overlaps and distances.
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "link_bounds/DistanceArray.h"

namespace link_bounds {

/// Subscribes to the three topics of a node, and keeps the newest message of each. All functions
/// are for the thread that calls ros::spinOnce().
class StormAnswers {
 public:
  StormAnswers(ros::NodeHandle& node, const std::string& publisher);

  /// Whether all three are of this moment, and nothing is incomplete.
  bool areOf(ros::Time stamp) const;

  /// The first difference in words, empty if there is none. Boxes and overlaps must be equal; the
  /// bounds of a distance must have a common value.
  std::string differenceTo(const StormAnswers& other) const;

  /// Once there is a message.
  std::size_t countBoxes() const { return boxes_->boxes.size(); }

  std::string counts() const;

 private:
  std::string publisher_;
  ros::Subscriber boxes_subscriber_;
  ros::Subscriber overlaps_subscriber_;
  ros::Subscriber distances_subscriber_;
  AxisAlignedBoxArrayConstPtr boxes_;
  BoxOverlapArrayConstPtr overlaps_;
  DistanceArrayConstPtr distances_;
};

}  // namespace link_bounds
