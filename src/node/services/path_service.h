// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~check_path. Requests take turns on a thread of this service.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <memory>

#include "link_bounds/CheckPath.h"
#include "node/outputs/copies/scene_copier.h"
#include "node/services/turn_service.h"
#include "world/path/path_trees.h"

namespace link_bounds {

class PathService {
 public:
  /// `scenes` and `answering` must outlive this. `answering` sends the answers; its thread has
  /// normal priority. `load` is called on the thread of this service.
  PathService(ros::NodeHandle& private_node, const SceneCopier& scenes, Worker& answering,
              PathTrees::Load load);
  ~PathService() { stop(); }
  PathService(const PathService&) = delete;
  PathService& operator=(const PathService&) = delete;

  /// Ends the thread. Later requests are not answered.
  void stop() { paths_.stop(); }

 private:
  struct Job;
  using Call = TurnQueue::Call;
  using Params = TurnService<CheckPath>::Params;
  using Time = std::chrono::steady_clock::time_point;

  void answer(Call& call, const Params& params, CheckPath::Response& response);
  std::shared_ptr<Job> begin(const Call& call, const Params& params);
  Received<CheckPath::Request> read(const Params& params);
  bool forgetIfUnused();

  const SceneCopier& scenes_;
  PathTrees trees_;  ///< trees_ and last_used_ are accessed only by the thread
  Time last_used_;
  std::atomic<std::size_t> begun_{0};  ///< number of jobs in progress
  Worker paths_;
  TurnQueue queue_;
  TurnService<CheckPath> service_;
};

}  // namespace link_bounds
