// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Overlaps, parts and markers: only for subscribers, on a thread of their own.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "node/outputs/markers/box_markers.h"
#include "node/outputs/messages/overlap_message.h"
#include "node/outputs/messages/part_boxes.h"
#include "node/outputs/topic/output.h"
#include "node/threads/worker.h"
#include "world/log/guarded.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// If computing takes longer than the time between two moments, it skips those in between.
class OptionalOutputs {
 public:
  /// Called when somebody has subscribed. Each returns null if there is no moment.
  struct Newest {
    std::function<MomentPtr()> published;  ///< the moment of the last ~boxes
    std::function<MomentPtr()> current;    ///< the moment of the scene as it is now, for markers
  };

  /// Each new subscriber alone gets a message of its own. `guard` runs the callbacks of roscpp.
  /// `pairs` must outlive this.
  OptionalOutputs(ros::NodeHandle& private_node, Guard guard, MomentPairs& pairs, Newest newest);
  OptionalOutputs(const OptionalOutputs&) = delete;
  OptionalOutputs& operator=(const OptionalOutputs&) = delete;

  /// True while somebody listens to overlaps or parts.
  bool areWanted() const { return areOverlapsWanted() || parts_.hasSubscribers(); }
  bool areOverlapsWanted() const { return overlaps_.hasSubscribers(); }
  bool areMarkersWanted() const { return markers_.hasSubscribers(); }

  // The functions below return at once.
  void give(const MomentPtr& moment);
  void giveMarkers(const MomentPtr& moment);

  /// Frees the state of the former model.
  void adopt();

  /// Frees the memory that the search for overlaps keeps between moments.
  void freeSpareMemory();

 private:
  using SubscriberPtr = OutputTopic::SubscriberPtr;  ///< null: all subscribers
  using Publish = void (OptionalOutputs::*)(const MomentPtr&, const SubscriberPtr&);

  OutputTopic::OnSubscriber greetWith(Publish publish, const std::function<MomentPtr()>& newest);
  void post(const std::string& key, Publish publish, MomentPtr moment, SubscriberPtr to = {});
  void publishOverlaps(const MomentPtr& moment, const SubscriberPtr& to);
  void publishParts(const MomentPtr& moment, const SubscriberPtr& to);
  void publishEndOfParts(const std_msgs::Header& header);
  void publishMarkers(const MomentPtr& moment, const SubscriberPtr& to);

  const Guard guard_;
  MomentPairs& pairs_;
  const Newest newest_;
  OverlapFiller overlap_filler_;  ///< this and the next five: used by the thread alone
  BoxOverlapArray overlaps_message_;
  PartBoxes part_boxes_;
  AxisAlignedBoxArray parts_message_;
  bool has_shown_parts_ = false;  ///< there are parts to end for listeners
  ShownMarkers shown_;
  Output<BoxOverlapArray> overlaps_;
  Output<AxisAlignedBoxArray> parts_;
  Output<visualization_msgs::MarkerArray> markers_;
  Worker worker_;  ///< last: its thread ends before the members above
};

}  // namespace link_bounds
