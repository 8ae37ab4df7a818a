// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Hands a model from the loader thread to the update thread.
#pragma once

#include <ros/callback_queue_interface.h>

#include <functional>
#include <memory>

#include "node/loading/model.h"

namespace link_bounds {

/// Freeing a model takes long, so the update thread must never hold the last reference. This class
/// holds one for the loader thread until the update thread uses another model.
class ModelHandOver {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// `adopt` runs on the thread that serves the queue. If it throws, it is called again with the
  /// model in use.
  ModelHandOver(ros::CallbackQueueInterface& queue, std::function<void(ModelPtr)> adopt);
  ModelHandOver(const ModelHandOver&) = delete;
  ModelHandOver& operator=(const ModelHandOver&) = delete;

  /// Returns true when the update thread uses the model. Returns false if `is_cancelled`, which is
  /// called often, returns true before; then no further model can be given. Throws what `adopt`
  /// throws; the old model then stays in use.
  bool give(ModelPtr model, const std::function<bool()>& is_cancelled);

 private:
  void adoptNext();

  ros::CallbackQueueInterface& queue_;
  std::function<void(ModelPtr)> adopt_;
  ModelPtr in_use_;
  ModelPtr next_;  ///< while the update thread may adopt it
};

}  // namespace link_bounds
