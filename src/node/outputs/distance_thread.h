// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance thread: computes, however long that takes, while boxes go on.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "node/threads/worker.h"
#include "world/moment/scene_distances.h"

namespace link_bounds {

/// What one computation took.
struct DistanceTimes {
  std::size_t count = 0;  ///< computations since the last call
  double max_ms = 0;      ///< the longest of them
  double sum_ms = 0;
};

class DistanceThread {
 public:
  /// Called on the thread.
  struct Callbacks {
    std::function<void(ComputedDistances)> publish;
    std::function<void()> tick;       ///< every 50 ms while there is a moment
    std::function<bool()> is_wanted;  ///< else everything is forgotten after `keep`
  };

  /// `keep` is long enough for the next rostopic echo -n1 to find the trees. Throws
  /// std::runtime_error if the thread cannot be started.
  /// `pairs` must outlive this.
  DistanceThread(TreeRequests requests, MomentPairs& pairs, Callbacks callbacks,
                 std::chrono::milliseconds keep = std::chrono::seconds(10));

  /// The functions below may be called from any thread, where they do not say otherwise, and return
  /// at once, but for stop().

  /// Replaces a moment whose computation has not begun. For one thread only.
  void give(MomentPtr moment);

  /// A tree that was requested. Distances are computed again with it.
  void give(MadeTree tree);

  /// Ends the thread. What is given later is ignored.
  void stop() { worker_.stop(); }

  DistanceTimes takeTimes();

  /// For how long a moment has been waiting to be computed and published [s]; 0 if none is.
  double behind() const;

  /// Why there are meshes and lists without triangles, one entry each.
  std::vector<std::string> errors() const;

 private:
  using Time = std::chrono::steady_clock::time_point;

  bool onTick();
  void compute();
  void forgetIfUnwanted();
  void forget();
  void drop();

  MomentPairs& pairs_;
  Callbacks callbacks_;
  std::chrono::milliseconds keep_;
  SceneDistances distances_;          ///< this and the next five: of the thread alone
  bool is_whole_ = true;              ///< else distances_ may be of half a moment
  MomentPtr current_;                 ///< the newest one
  std::uint64_t current_number_ = 0;  ///< among those that were given
  bool has_news_ = false;             ///< since the last computation
  Time not_before_;                   ///< of the next computation
  Time last_wanted_;
  TreeRequests requests_;
  std::atomic<std::uint64_t> trees_{0};          ///< number of trees that were given: each counts
  std::atomic<std::uint64_t> given_{0};          ///< number of moments
  std::atomic<std::uint64_t> published_{0};      ///< number of the newest one that was
  std::atomic<Time> published_begin_{Time()};    ///< when its computation began
  std::atomic<Time> unpublished_since_{Time()};  ///< since when given_ > published_, or earlier
  mutable std::mutex mutex_;
  DistanceTimes times_;              ///< guarded by mutex_
  std::vector<std::string> errors_;  ///< guarded by mutex_
  Worker worker_;                    ///< last: it ends before the rest goes
};

}  // namespace link_bounds
