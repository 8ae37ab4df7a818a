// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What other threads request from the loader thread.
#pragma once

#include <ros/callback_queue_interface.h>

#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "node/threads/queued_function.h"

namespace link_bounds {

/// The first call on the loader thread takes all requests that have gathered, because files are
/// then read side by side; the others find none.
template <class Request, class Result>
class LoadRequests {
 public:
  /// One result per request, in order.
  using Load = std::function<std::vector<Result>(const std::vector<Request>& requests)>;
  using Handler = std::function<void(const Request& request, const Result& result)>;

  /// Both functions run on the thread that serves `queue`, which must not be served any more when
  /// this is destroyed.
  LoadRequests(ros::CallbackQueueInterface& queue, Load load, Handler on_result)
      : queue_(queue), load_(std::move(load)), on_result_(std::move(on_result)) {}
  LoadRequests(const LoadRequests&) = delete;
  LoadRequests& operator=(const LoadRequests&) = delete;

  /// Returns at once. May be called on any thread.
  void add(Request request) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      requests_.push_back(std::move(request));
    }
    enqueue(queue_, [this] { handleAll(); });
  }

 private:
  void handleAll() {
    const std::vector<Request> requests = takeAll();
    if (requests.empty()) return;
    const std::vector<Result> results = load_(requests);
    for (std::size_t i = 0; i < requests.size(); ++i)
      on_result_(requests[i], results[i]);
  }

  std::vector<Request> takeAll() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(requests_, {});
  }

  ros::CallbackQueueInterface& queue_;
  Load load_;
  Handler on_result_;
  std::mutex mutex_;
  std::vector<Request> requests_;  ///< guarded by mutex_
};

}  // namespace link_bounds
