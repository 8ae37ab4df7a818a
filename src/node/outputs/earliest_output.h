// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes the earliest time at which two bodies can touch; a thread of its own computes it.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <string>

#include "link_bounds/EarliestContactArray.h"
#include "node/outputs/copies/way_scenes.h"
#include "node/outputs/topic/output.h"
#include "world/log/guarded.h"
#include "world/stopping/contact_times.h"

namespace link_bounds {

/// Computes only while somebody listens. If computing takes longer than the time between two
/// ~boxes, it skips those in between.
class EarliestOutput {
 public:
  /// `scenes` must outlive this. `guard` runs the callbacks of roscpp.
  EarliestOutput(ros::NodeHandle& private_node, const Guard& guard, const SceneCopier& scenes,
                 TreeRequests requests);
  EarliestOutput(const EarliestOutput&) = delete;
  EarliestOutput& operator=(const EarliestOutput&) = delete;

  /// To be called with each ~boxes.
  void request();

  /// To be called every tick, because no further ~boxes may come after the last listener has gone.
  void restIfUnheard();

  /// Takes a tree that was requested. May be called on any thread, also after stop().
  void give(MadeTree tree);

  /// Ends the thread. No tree is requested afterwards.
  void stop() { worker_.stop(); }

  /// The max time from a ~boxes to the end of its computation since the last call.
  std::chrono::nanoseconds takeLongest() { return worker_.takeLongest(); }

  /// Why the first incomplete body of the last message is incomplete, and how many more are; "" if
  /// all are complete or nobody listens. May be called on any thread.
  std::string problem() const { return scenes_.problem(); }

 private:
  void publish();
  void forget();

  std::atomic<bool> is_forgotten_{true};
  WayScenes scenes_;  ///< this and the next one: used by the thread alone
  ContactTimes contacts_;
  Output<EarliestContactArray> output_;
  Worker worker_;  ///< last: its thread ends before the members above
};

}  // namespace link_bounds
