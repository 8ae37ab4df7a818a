// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The history thread: serves a callback queue of its own, whose callbacks may take long.
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "node/history/scene_copy.h"
#include "node/log/guarded.h"

namespace link_bounds {

class HistoryThread {
 public:
  /// `scene` belongs to the thread that spins the global callback queue, the update thread. `guard`
  /// runs what copies from it there. Throws std::runtime_error if the thread cannot be started.
  HistoryThread(const Scene& scene, Guard guard);
  ~HistoryThread() { stop(); }
  HistoryThread(const HistoryThread&) = delete;
  HistoryThread& operator=(const HistoryThread&) = delete;

  /// What runs on the thread.
  ros::CallbackQueue& queue() { return queue_; }

  /// To be called on the update thread when the scene has a new model.
  void adopt(std::shared_ptr<const Model> model);

  /// The newest model; null before the first one.
  std::shared_ptr<const Model> model() const;

  /// To be called on the thread: waits until the update thread has copied what the request needs.
  /// There must be a model. Null if the node is stopping. Throws what copying throws.
  std::unique_ptr<PastScene> copy(const BoxRequest& request);

  /// Whoever works on the thread must ask this often.
  bool isStopping() const;

  /// Ends the thread, after what it is working on.
  void stop();

 private:
  struct Job;

  void run();
  void enqueuePiece(std::shared_ptr<Job> job);
  void copyPiece(const std::shared_ptr<Job>& job);

  const Scene& scene_;
  Guard guard_;
  ros::CallbackQueue queue_;
  std::atomic<bool> stops_{false};
  mutable std::mutex mutex_;
  std::shared_ptr<const Model> model_;  ///< guarded by mutex_
  std::thread thread_;
};

}  // namespace link_bounds
