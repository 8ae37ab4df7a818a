// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishes distances; a thread of its own computes them.
#pragma once

#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "node/interface/topics.h"
#include "node/outputs/distance_thread.h"
#include "node/outputs/topic/output.h"
#include "world/log/guarded.h"

namespace link_bounds {

/// The data on distances in /diagnostics.
struct DistanceHealth {
  bool is_wanted = false;  ///< somebody listens, or distance_warning is set; else no pairs
  std::size_t pairs = 0;   ///< in the last ~distances, as the next three
  std::array<std::size_t, 3> levels{};
  std::size_t left_out = 0;         ///< pairs beyond max_pairs
  std::optional<Distance> nearest;  ///< none before the first ~distances
  double behind = 0;                ///< see DistanceThread::behind() [s]
  Durations times;                  ///< since the last call
  std::vector<std::string> errors;  ///< of meshes and lists without triangles
};

class DistanceOutput {
 public:
  /// `send` gives the last ~boxes to give(); it is called when somebody subscribes. `guard` runs
  /// the callbacks of roscpp. `pairs` must outlive this.
  DistanceOutput(ros::NodeHandle& private_node, const Guard& guard, TreeRequests requests,
                 MomentPairs& pairs, std::function<void()> send);
  DistanceOutput(const DistanceOutput&) = delete;
  DistanceOutput& operator=(const DistanceOutput&) = delete;

  /// Takes the parameters of the scene's model.
  void adopt(const Parameters& parameters) { warning_ = parameters.distance_warning; }

  /// True while distances are to be computed.
  bool isWanted() const;

  /// To be called with each ~boxes while isWanted().
  void give(MomentPtr moment) { thread_.give(std::move(moment)); }

  /// May be called on any thread, also after stop().
  void give(MadeTree tree) { thread_.give(std::move(tree)); }

  /// Ends the thread. No tree is requested afterwards.
  void stop() { thread_.stop(); }

  DistanceHealth takeHealth();

 private:
  using Time = std::chrono::steady_clock::time_point;

  void publish(ComputedDistances computed);
  void publishDueMarkers();

  Guard guard_;
  std::function<void()> send_;
  std::atomic<double> warning_{0};
  Output<DistanceArray> distances_;
  Output<Distance> nearest_;
  Output<visualization_msgs::MarkerArray> markers_;
  std::optional<ComputedDistances> unmarked_;  ///< used by the thread alone: not drawn yet
  Time last_markers_{};                        ///< used by the thread alone
  mutable std::mutex mutex_;
  DistanceHealth health_;  ///< guarded by mutex_
  DistanceThread thread_;  ///< last: it ends before the members above
};

}  // namespace link_bounds
