// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Hands a model from the loader thread to the update thread.
#pragma once

#include <functional>
#include <memory>

#include "node/threads/worker.h"
#include "world/model/model.h"

namespace link_bounds {

class ModelHandOver {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// `adopt` runs on the thread that serves the queue. If it throws, it is called again with the
  /// model in use.
  ModelHandOver(Worker& loader, ros::CallbackQueueInterface& queue,
                std::function<void(ModelPtr)> adopt)
      : loader_(loader), queue_(queue), adopt_(std::move(adopt)) {}
  ModelHandOver(const ModelHandOver&) = delete;
  ModelHandOver& operator=(const ModelHandOver&) = delete;

  /// On the loader thread, which alone frees the model: that takes long. Returns true when the
  /// update thread uses the model, false if the loader is stopping. Throws what `adopt` throws; the
  /// old model then stays in use.
  bool give(ModelPtr model);

 private:
  void adopt(const ModelPtr& model);

  Worker& loader_;
  ros::CallbackQueueInterface& queue_;
  std::function<void(ModelPtr)> adopt_;
  ModelPtr in_use_;  ///< of the update thread
};

}  // namespace link_bounds
