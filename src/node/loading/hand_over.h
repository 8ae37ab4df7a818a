// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes the loaded object from the loader thread to the thread that uses it.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "node/threads/worker.h"
#include "world/log/guarded.h"

namespace link_bounds {

template <class Made>
class HandOver {
 public:
  using MadePtr = std::shared_ptr<const Made>;

  /// `adopt` runs on the thread that serves the queue. If it throws, it is called again with the
  /// object that was in use before, if there is one.
  HandOver(Worker& loader, ros::CallbackQueueInterface& queue, std::function<void(MadePtr)> adopt)
      : loader_(loader), queue_(queue), adopt_(std::move(adopt)) {}
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

  /// Call on the loader thread. Only that thread frees `made`, because freeing takes long. Returns
  /// true when the other thread uses `made`, false if the loader is stopping. Throws what `adopt`
  /// throws; the old object then stays in use.
  bool give(MadePtr made) {
    return loader_.await(queue_, [this, owned = loader_.owned(std::move(made))] {
      adopt(owned);
      return true;
    });
  }

 private:
  void adopt(const MadePtr& made) {
    try {
      adopt_(made);
      in_use_ = made;
    } catch (...) {
      if (in_use_) guarded([this] { adopt_(in_use_); });
      throw;
    }
  }

  Worker& loader_;
  ros::CallbackQueueInterface& queue_;
  std::function<void(MadePtr)> adopt_;
  MadePtr in_use_;  ///< accessed only by the thread that serves queue_
};

}  // namespace link_bounds
