// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes the boxes swept by the last motion; a thread of its own computes them.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/outputs/copies/scene_copier.h"
#include "node/outputs/topic/output.h"
#include "node/outputs/topic/paced_output.h"
#include "world/model/parameters.h"

namespace link_bounds {

/// Computes only while somebody listens and swept_span is not 0. If computing takes longer than the
/// time between two ~boxes, it skips those in between.
class SweptOutput {
 public:
  /// `periodic` and `scenes` must outlive this. `guard` runs the callbacks of roscpp.
  SweptOutput(Periodic& periodic, ros::NodeHandle& private_node, const Guard& guard,
              const SceneCopier& scenes);
  SweptOutput(const SweptOutput&) = delete;
  SweptOutput& operator=(const SweptOutput&) = delete;

  /// Takes the parameters of a new model.
  void adopt(const Parameters& parameters);

  /// To be called with each ~boxes.
  void request();

  /// The max time from a ~boxes to the end of its computation since the last call.
  std::chrono::nanoseconds takeLongest() { return worker_.takeLongest(); }

 private:
  void requestMarkers();
  void postBoxes();
  void publish();

  const SceneCopier& scenes_;
  std::atomic<std::int64_t> span_{0};         ///< [ns]
  std::atomic<bool> are_markers_due_{false};  ///< at the next publish()
  AxisAlignedBoxArray message_;               ///< used by the thread alone
  Output<AxisAlignedBoxArray> boxes_;
  Output<visualization_msgs::MarkerArray> markers_;
  PacedOutput markers_output_;
  Worker worker_;  ///< last: its thread ends before the members above
};

}  // namespace link_bounds
