// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes the boxes of the last motion, which the history thread computes.
#pragma once

#include <ros/node_handle.h>

#include <atomic>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/history/history_thread.h"
#include "node/outputs/paced_output.h"
#include "node/parameters/parameters.h"

namespace link_bounds {

/// Computes only while somebody listens and swept_span is not 0. Where computing takes longer than
/// the time between two ~boxes, it skips those in between.
class SweptOutput {
 public:
  /// `history` must outlive this, which stops it. `guard` runs the callbacks of roscpp.
  SweptOutput(ros::NodeHandle& node, ros::NodeHandle& private_node, const Guard& guard,
              HistoryThread& history);
  ~SweptOutput() { history_.stop(); }
  SweptOutput(const SweptOutput&) = delete;
  SweptOutput& operator=(const SweptOutput&) = delete;

  /// Takes the parameters of a new model.
  void adopt(const Parameters& parameters);

  /// To be called with each ~boxes.
  void request();

 private:
  void requestMarkers();
  void enqueueUnlessWaiting();
  void publish();

  HistoryThread& history_;
  std::atomic<std::int64_t> span_{0};         ///< [ns]
  std::atomic<bool> is_waiting_{false};       ///< publish() is in the queue of the thread
  std::atomic<bool> are_markers_due_{false};  ///< at the next publish()
  AxisAlignedBoxArray message_;               ///< of the thread
  ros::Publisher publisher_;
  ros::Publisher markers_publisher_;
  PacedOutput markers_output_;
};

}  // namespace link_bounds
