// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Overlaps, parts and markers: only for subscribers, on a thread of their own.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "node/outputs/box_markers.h"
#include "node/outputs/output.h"
#include "node/outputs/overlap_message.h"
#include "node/outputs/part_boxes.h"
#include "node/threads/worker.h"
#include "world/log/guarded.h"
#include "world/moment/snapshot.h"

namespace link_bounds {

/// Where computing takes longer than the time between two snapshots, those in between are skipped.
class OptionalOutputs {
 public:
  using SnapshotPtr = std::shared_ptr<const Snapshot>;

  /// Called when somebody has subscribed; null if there is none.
  struct Newest {
    std::function<SnapshotPtr()> published;  ///< that of the last give(), or of the last ~boxes
    std::function<SnapshotPtr()> current;    ///< of the scene, for markers
  };

  /// Each new subscriber alone gets a message of its own. `guard` runs the callbacks of roscpp.
  OptionalOutputs(ros::NodeHandle& private_node, Guard guard, Newest newest);
  OptionalOutputs(const OptionalOutputs&) = delete;
  OptionalOutputs& operator=(const OptionalOutputs&) = delete;

  /// True while somebody listens to overlaps or parts.
  bool areWanted() const { return overlaps_.hasSubscribers() || parts_.hasSubscribers(); }
  bool areMarkersWanted() const { return markers_.hasSubscribers(); }

  /// What follows returns at once.
  void give(const SnapshotPtr& snapshot);
  void giveMarkers(const SnapshotPtr& snapshot);

  /// Frees what is kept of the former model.
  void adopt();

  /// Frees the memory that the search for overlaps keeps between snapshots.
  void freeSpareMemory();

 private:
  using SubscriberPtr = OutputTopic::SubscriberPtr;  ///< null: all
  using Publish = void (OptionalOutputs::*)(const Snapshot&, const SubscriberPtr&);

  OutputTopic::OnSubscriber greetWith(const char* topic, Publish publish,
                                      const std::function<SnapshotPtr()>& newest);
  void post(const std::string& key, Publish publish, SnapshotPtr snapshot, SubscriberPtr to = {});
  void publishOverlaps(const Snapshot& snapshot, const SubscriberPtr& to);
  void publishParts(const Snapshot& snapshot, const SubscriberPtr& to);
  void publishMarkers(const Snapshot& snapshot, const SubscriberPtr& to);

  const Guard guard_;
  const Newest newest_;
  std::uint64_t greetings_ = 0;
  SceneOverlaps scene_overlaps_;  ///< this and what follows: of the thread
  BoxOverlapArray overlaps_message_;
  PartBoxes part_boxes_;
  AxisAlignedBoxArray parts_message_;
  ShownMarkers shown_;
  Output<BoxOverlapArray> overlaps_;
  Output<AxisAlignedBoxArray> parts_;
  Output<visualization_msgs::MarkerArray> markers_;
  Worker worker_;  ///< last: its thread ends before the rest goes
};

}  // namespace link_bounds
