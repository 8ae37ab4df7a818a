// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes for each body the box of all that it can reach until the robot has stopped, and which
// of these boxes overlap; a thread of its own computes both.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "link_bounds/BoxOverlapArray.h"
#include "node/outputs/copies/way_scenes.h"
#include "node/outputs/messages/overlap_message.h"
#include "node/outputs/topic/output.h"
#include "node/outputs/topic/paced_output.h"
#include "world/model/parameters.h"

namespace link_bounds {

/// Computes only while somebody listens. If computing takes longer than the time between two
/// ~boxes, it skips those in between.
class StoppingOutput {
 public:
  /// `periodic` and `scenes` must outlive this. `guard` runs the callbacks of roscpp.
  StoppingOutput(Periodic& periodic, ros::NodeHandle& private_node, const Guard& guard,
                 const SceneCopier& scenes);
  StoppingOutput(const StoppingOutput&) = delete;
  StoppingOutput& operator=(const StoppingOutput&) = delete;

  /// Takes the parameters of a new model.
  void adopt(const Parameters& parameters) { markers_output_.setRate(parameters.marker_rate); }

  /// To be called with each ~boxes.
  void request();

  /// To be called every tick, because no further ~boxes may come after the last listener has gone.
  void restIfUnheard();

  /// The max time from a ~boxes to the end of its computation since the last call.
  std::chrono::nanoseconds takeLongest() { return worker_.takeLongest(); }

  /// Why the first incomplete body of the last message is incomplete, and how many more are; "" if
  /// all are complete or nobody listens. May be called on any thread.
  std::string problem() const { return scenes_.problem(); }

 private:
  bool areBoxesWanted() const { return boxes_.hasSubscribers() || overlaps_.hasSubscribers(); }
  void requestMarkers();
  void post();
  void publish();

  std::atomic<bool> are_markers_due_{false};  ///< at the next publish()
  std::atomic<bool> is_resting_{true};
  WayScenes scenes_;  ///< this and the next four: used by the thread alone
  AxisAlignedBoxArray message_;
  BoxOverlapArray overlaps_message_;
  MomentPairs pairs_;
  OverlapFiller overlap_filler_;
  Output<AxisAlignedBoxArray> boxes_;
  Output<BoxOverlapArray> overlaps_;
  Output<visualization_msgs::MarkerArray> markers_;
  PacedOutput markers_output_;
  Worker worker_;  ///< last: its thread ends before the members above
};

}  // namespace link_bounds
