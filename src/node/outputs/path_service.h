// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~check_path: requests take turns on a thread of their own.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <memory>

#include "link_bounds/CheckPath.h"
#include "node/inputs/incomplete_messages.h"
#include "node/outputs/path_trees.h"
#include "node/outputs/scene_copier.h"
#include "node/threads/turn_queue.h"

namespace link_bounds {

class PathService {
 public:
  /// `scenes` and `answering` must outlive this. Answers are sent by `answering`, whose thread is
  /// not nice. `load` is called on the thread of this.
  PathService(ros::NodeHandle& private_node, const SceneCopier& scenes, Worker& answering,
              PathTrees::Load load);
  ~PathService() { stop(); }
  PathService(const PathService&) = delete;
  PathService& operator=(const PathService&) = delete;

  /// Ends the thread. Requests that come later are not answered.
  void stop() { paths_.stop(); }

 private:
  class Handler;
  struct Job;
  using Call = TurnQueue::Call;
  using Time = std::chrono::steady_clock::time_point;

  void onTurn(Call& call, ros::ServiceCallbackHelperCallParams& params);
  CheckPath::Response answer(Call& call, const ros::ServiceCallbackHelperCallParams& params);
  std::shared_ptr<Job> begin(const Call& call, const ros::ServiceCallbackHelperCallParams& params);
  void read(const ros::ServiceCallbackHelperCallParams& params,
            Received<CheckPath::Request>& request);
  bool forgetIfUnused();

  const SceneCopier& scenes_;
  IncompleteMessages incomplete_messages_;  ///< this and the next two: of the thread alone
  PathTrees trees_;
  Time last_used_;
  std::atomic<std::size_t> begun_{0};  ///< jobs
  Worker paths_;
  TurnQueue queue_;
  ros::ServiceServer server_;
};

}  // namespace link_bounds
