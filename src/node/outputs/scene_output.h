// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes the boxes of a scene, and all that is computed from them.
#pragma once

#include <geometry_msgs/Polygon.h>

#include <optional>
#include <string>
#include <utility>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/outputs/distance_output.h"
#include "node/outputs/optional_outputs.h"
#include "node/outputs/topic/output.h"
#include "node/outputs/topic/paced_output.h"
#include "world/bodies/scene.h"

namespace link_bounds {

/// Boxes, groups and footprint are published at once. Overlaps, parts, distances and markers are
/// computed for listeners only, on other threads, from a moment of the scene: markers from the
/// newest one, the others from that of a ~boxes.
class SceneOutput {
 public:
  /// `periodic` and `scene` must outlive this. `guard` runs the callbacks of roscpp.
  /// `requests` must work until distances().stop().
  SceneOutput(Periodic& periodic, ros::NodeHandle& private_node, const Scene& scene,
              const Guard& guard, TreeRequests requests);
  SceneOutput(const SceneOutput&) = delete;
  SceneOutput& operator=(const SceneOutput&) = delete;

  /// `on_boxes` is called after each ~boxes.
  void onBoxes(std::function<void()> on_boxes) { on_boxes_ = std::move(on_boxes); }

  /// Publishes everything and sets the rates of the new model of the scene.
  void adopt();

  /// Publishes a change of the scene as soon as the rates allow. There must be a model.
  void request();

  /// Frees the memory that overlaps keep between two moments.
  void freeSpareMemory() { optional_.freeSpareMemory(); }

  /// Number of messages on ~boxes.
  std::uint64_t publications() const { return publications_; }

  /// Whether ~footprint is published, and if not, why.
  std::string footprintState() const;

  /// The max age of a new stamp of a ~boxes, by ROS time when it was published, since the last
  /// call [ms]. Nothing if no ~boxes had a new stamp.
  std::optional<double> takeMaxLag() { return std::exchange(lag_ms_, std::nullopt); }

  DistanceOutput& distances() { return distances_; }

 private:
  void publishBoxes();
  void publishFootprint();
  void greetWithFootprint(OutputTopic::Subscriber& subscriber);
  MomentPtr published();
  void expectPairs();
  void giveBoxes();
  void giveDistances();
  void giveMarkers();
  MomentPtr current();
  void recordLag(ros::Time stamp);

  const Scene& scene_;
  std::function<void()> on_boxes_ = [] {};
  std::uint64_t publications_ = 0;
  std::optional<double> lag_ms_;
  ros::Time last_stamp_;                ///< of ~boxes
  AxisAlignedBoxArray boxes_message_;   ///< the last one published
  AxisAlignedBoxArray groups_message_;  ///< the last one published
  MomentPtr published_;  ///< the moment of the last ~boxes; null if nobody has asked for it
  MomentPtr moment_;     ///< the moment of the scene as it is; null if nobody has asked for it
  Output<AxisAlignedBoxArray> boxes_;
  Output<AxisAlignedBoxArray> groups_;
  Output<geometry_msgs::Polygon> footprint_;
  PacedOutput boxes_output_;
  PacedOutput markers_output_;
  MomentPairs pairs_;
  OptionalOutputs optional_;
  DistanceOutput distances_;
};

}  // namespace link_bounds
