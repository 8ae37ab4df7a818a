// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The thread that computes distances, so that ~boxes never waits for them.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "node/threads/callback_times.h"
#include "node/threads/worker.h"
#include "world/moment/scene_distances.h"

namespace link_bounds {

class DistanceThread {
 public:
  /// Called on the thread.
  struct Callbacks {
    std::function<void(ComputedDistances)> publish;
    std::function<void()> tick;       ///< every 50 ms while there is a moment
    std::function<bool()> is_wanted;  ///< if false for `keep`, everything is forgotten
  };

  /// The default of `keep` is so long that the next rostopic echo -n1 finds the trees. Throws
  /// std::runtime_error if the thread cannot be started. `pairs` must outlive this.
  DistanceThread(TreeRequests requests, MomentPairs& pairs, Callbacks callbacks,
                 std::chrono::milliseconds keep = std::chrono::seconds(10));

  // The functions below may be called on any thread unless they say otherwise. All but stop()
  // return at once.

  /// Replaces a moment whose computation has not begun. Only one thread may call it.
  void give(MomentPtr moment);

  /// Takes a tree that was requested. Distances are computed again with it.
  void give(MadeTree tree);

  /// Ends the thread. Moments and trees that are given later are ignored.
  void stop() { worker_.stop(); }

  /// How long the computations since the last call took.
  Durations takeTimes();

  /// How long the oldest unpublished moment has been waiting [s]; 0 if there is none.
  double behind() const;

  /// For each mesh or list without triangles: why it has none.
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
  SceneDistances distances_;          ///< this and the next seven: used by the thread alone
  bool is_whole_ = true;              ///< if false, distances_ may hold half a moment
  MomentPtr current_;                 ///< the newest one
  std::uint64_t current_number_ = 0;  ///< number of current_, counted by given_
  bool has_news_ = false;             ///< a moment or tree came since the last computation
  Time not_before_;                   ///< earliest begin of the next computation
  Time last_wanted_;
  TreeRequests requests_;
  std::atomic<std::uint64_t> given_{0};  ///< number of moments that were given
  std::atomic<std::uint64_t> published_{
      0};  ///< number of the newest moment that was published or dropped
  std::atomic<Time> published_begin_{Time()};    ///< when its computation began
  std::atomic<Time> unpublished_since_{Time()};  ///< since when given_ > published_, or earlier
  mutable std::mutex mutex_;
  Durations times_;                  ///< guarded by mutex_
  std::vector<std::string> errors_;  ///< guarded by mutex_
  Worker worker_;                    ///< last: it ends before the members above
};

}  // namespace link_bounds
