// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies the parts of the scene that other threads need.
#pragma once

#include <ros/callback_queue_interface.h>

#include <chrono>
#include <memory>
#include <mutex>

#include "node/threads/worker.h"
#include "world/history/scene_copy.h"
#include "world/log/guarded.h"

namespace link_bounds {

class SceneCopier {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `scene` belongs to the update thread, which serves the queue. `measure` is called on that
  /// thread, runs each piece of a copy, and lets exceptions out.
  SceneCopier(const Scene& scene, Guard measure, ros::CallbackQueueInterface& update_queue)
      : scene_(scene), measure_(std::move(measure)), update_queue_(update_queue) {}
  SceneCopier(const SceneCopier&) = delete;
  SceneCopier& operator=(const SceneCopier&) = delete;

  /// Call on the update thread when the scene has a new model.
  void adopt(std::shared_ptr<const Model> model);

  /// The newest model; null before the first one.
  std::shared_ptr<const Model> model() const;

  /// Call on the thread of the worker. Waits until the update thread has copied the data for the
  /// request. There must be a model. Null if the worker is stopping, or if the copy is not complete
  /// at the deadline. Throws what copying throws.
  std::unique_ptr<PastScene> copy(Worker& worker, const BoxRequest& request,
                                  Time deadline = Time::max()) const;

 private:
  const Scene& scene_;
  Guard measure_;
  ros::CallbackQueueInterface& update_queue_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Model> model_;  ///< guarded by mutex_
};

}  // namespace link_bounds
