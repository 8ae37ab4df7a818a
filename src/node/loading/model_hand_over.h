// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How a model gets from the loader thread to the update thread, and is freed by the former.
#pragma once

#include <ros/callback_queue_interface.h>

#include <functional>
#include <memory>

#include "node/loading/model.h"

namespace link_bounds {

/// To free a model takes long, so the update thread must never hold its last reference: this class
/// keeps one on the loader thread until the update thread uses another model.
class ModelHandOver {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// `adopt` runs on the thread that serves the queue. When it throws, it is called again with the
  /// model that was in use.
  ModelHandOver(ros::CallbackQueueInterface& queue, std::function<void(ModelPtr)> adopt);
  ModelHandOver(const ModelHandOver&) = delete;
  ModelHandOver& operator=(const ModelHandOver&) = delete;

  /// Returns once the update thread uses the model; false if `gives_up`, which is asked often, says
  /// so before: then nothing more can be given. Throws what `adopt` throws; the old model is then
  /// in use as before.
  bool give(ModelPtr model, const std::function<bool()>& gives_up);

 private:
  void adoptNext();

  ros::CallbackQueueInterface& queue_;
  std::function<void(ModelPtr)> adopt_;
  ModelPtr in_use_;
  ModelPtr next_;  ///< while the update thread may take it
};

}  // namespace link_bounds
