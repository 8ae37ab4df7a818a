// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Puts functions into a callback queue. Exceptions that they throw are logged.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>

#include <boost/make_shared.hpp>
#include <functional>
#include <utility>

#include "world/log/guarded.h"

namespace link_bounds {

class QueuedFunction : public ros::CallbackInterface {
 public:
  explicit QueuedFunction(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    guarded(function_);
    return Success;
  }

 private:
  std::function<void()> function_;
};

inline void enqueue(ros::CallbackQueueInterface& queue, std::function<void()> function) {
  queue.addCallback(boost::make_shared<QueuedFunction>(std::move(function)));
}

inline ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueueInterface& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace link_bounds
