// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes a scene.
#pragma once

#include <geometry_msgs/Polygon.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "node/outputs/box_markers.h"
#include "node/outputs/distance_output.h"
#include "node/outputs/on_demand.h"
#include "node/outputs/overlap_message.h"
#include "node/outputs/paced_output.h"
#include "node/outputs/part_boxes.h"
#include "node/scene/scene.h"

namespace link_bounds {

/// Overlaps, parts and footprint always agree with the last ~boxes. The scene may be newer than
/// that when a new subscriber connects, because max_rate delays ~boxes.
class SceneOutput {
 public:
  /// `scene` must outlive this. `guard` runs the callbacks of roscpp.
  /// `requests` must work until distances().stop().
  SceneOutput(ros::NodeHandle& node, ros::NodeHandle& private_node, const Scene& scene,
              const Guard& guard, TreeRequests requests);
  SceneOutput(const SceneOutput&) = delete;
  SceneOutput& operator=(const SceneOutput&) = delete;

  /// `on_boxes` is called after each ~boxes.
  void onBoxes(std::function<void()> on_boxes) { on_boxes_ = std::move(on_boxes); }

  /// Publishes everything and sets the rates of the new model of the scene.
  void adopt();

  /// Publishes a change of the scene as soon as the rates allow. There must be a model.
  void request();

  /// Frees the memory that the search for overlaps keeps between updates.
  void freeSpareMemory();

  /// Number of messages on ~boxes.
  std::uint64_t publications() const { return publications_; }

  /// Whether ~footprint is published, and if not, why.
  std::string footprintState() const;

  /// By how much the stamp of a ~boxes lay behind ROS time when it was published [ms], the maximum
  /// since the last call. Nothing if no ~boxes had a stamp.
  std::optional<double> takeMaxLag() { return std::exchange(lag_ms_, std::nullopt); }

  DistanceOutput& distances() { return distances_; }

 private:
  void publishBoxes();
  void rememberLinks();
  void recordLag(ros::Time stamp);
  void giveDistances();
  bool fillMarkers(visualization_msgs::MarkerArray& message, Audience audience);
  bool fillParts(AxisAlignedBoxArray& message);
  bool fillFootprint(geometry_msgs::Polygon& message) const;
  bool fillOverlaps(BoxOverlapArray& message);

  const Scene& scene_;
  std::function<void()> on_boxes_ = [] {};
  std::uint64_t publications_ = 0;
  std::optional<double> lag_ms_;
  ShownMarkers shown_;
  PartBoxes part_boxes_;
  SceneOverlaps scene_overlaps_;
  AxisAlignedBoxArray boxes_message_;     ///< the last one published
  std::vector<std::size_t> boxed_links_;  ///< indices of the links that it begins with
  AxisAlignedBoxArray groups_message_;    ///< the last one published
  ros::Publisher boxes_publisher_;
  ros::Publisher groups_publisher_;
  OnDemand<visualization_msgs::MarkerArray> markers_;
  OnDemand<AxisAlignedBoxArray> parts_;
  OnDemand<geometry_msgs::Polygon> footprint_;
  OnDemand<BoxOverlapArray> overlaps_;
  PacedOutput boxes_output_;
  PacedOutput markers_output_;
  DistanceOutput distances_;
};

}  // namespace link_bounds
