// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~get_boxes on two threads: one for requests at one time, one for spans.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <mutex>

#include "link_bounds/GetBoxes.h"
#include "node/inputs/incomplete_messages.h"
#include "node/outputs/scene_copier.h"
#include "node/threads/turn_queue.h"

namespace link_bounds {

class BoxService {
 public:
  /// `scenes` must outlive this.
  BoxService(ros::NodeHandle& private_node, const SceneCopier& scenes);
  ~BoxService();
  BoxService(const BoxService&) = delete;
  BoxService& operator=(const BoxService&) = delete;

  /// Its thread is not nice, and always ready soon.
  Worker& answering() { return moments_; }

 private:
  class Handler;
  struct Job;
  using Call = TurnQueue::Call;

  void onTurn(Call& call, ros::ServiceCallbackHelperCallParams& params);
  void answer(Call& call, const ros::ServiceCallbackHelperCallParams& params,
              GetBoxes::Response& response);
  std::shared_ptr<Job> begin(Worker& worker, const Call& call,
                             const ros::ServiceCallbackHelperCallParams& params);
  void checkComplete(const Received<GetBoxes::Request>& request,
                     const ros::ServiceCallbackHelperCallParams& params);

  const SceneCopier& scenes_;
  std::mutex log_mutex_;
  IncompleteMessages incomplete_messages_;    ///< guarded by log_mutex_
  std::atomic<std::size_t> copied_bytes_{0};  ///< of the spans that were begun
  Worker moments_;
  Worker spans_;
  TurnQueue queue_;
  ros::ServiceServer server_;
};

}  // namespace link_bounds
