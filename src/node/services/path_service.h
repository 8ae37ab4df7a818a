// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~check_path: requests take turns on a thread of their own.
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
  struct Job;
  using Call = TurnQueue::Call;
  using Params = TurnService<CheckPath>::Params;
  using Time = std::chrono::steady_clock::time_point;

  void answer(Call& call, const Params& params, CheckPath::Response& response);
  std::shared_ptr<Job> begin(const Call& call, const Params& params);
  Received<CheckPath::Request> read(const Params& params);
  bool forgetIfUnused();

  const SceneCopier& scenes_;
  PathTrees trees_;  ///< this and the next one: of the thread alone
  Time last_used_;
  std::atomic<std::size_t> begun_{0};  ///< jobs
  Worker paths_;
  TurnQueue queue_;
  TurnService<CheckPath> service_;
};

}  // namespace link_bounds
