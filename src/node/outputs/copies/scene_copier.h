// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Gives other threads copies of what they need of the scene.
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

  /// `scene` belongs to the thread that serves the queue, the update thread. `measure` calls what
  /// copies from it there, and lets exceptions out.
  SceneCopier(const Scene& scene, Guard measure, ros::CallbackQueueInterface& update_queue)
      : scene_(scene), measure_(std::move(measure)), update_queue_(update_queue) {}
  SceneCopier(const SceneCopier&) = delete;
  SceneCopier& operator=(const SceneCopier&) = delete;

  /// To be called on the update thread when the scene has a new model.
  void adopt(std::shared_ptr<const Model> model);

  /// The newest model; null before the first one.
  std::shared_ptr<const Model> model() const;

  /// To be called on the thread of the worker: waits until the update thread has copied what the
  /// request needs. There must be a model. Null if the worker is stopping, or if the copy is not
  /// complete at the deadline. Throws what copying throws.
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
