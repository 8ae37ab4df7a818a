// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~get_boxes on two threads: one for requests at one time, one for spans.
#pragma once

#include <ros/node_handle.h>

#include <atomic>

#include "link_bounds/GetBoxes.h"
#include "node/outputs/copies/scene_copier.h"
#include "node/services/turn_service.h"

namespace link_bounds {

class BoxService {
 public:
  /// `scenes` must outlive this.
  BoxService(ros::NodeHandle& private_node, const SceneCopier& scenes);
  ~BoxService();
  BoxService(const BoxService&) = delete;
  BoxService& operator=(const BoxService&) = delete;

  /// The worker for requests at one time. Its thread has normal priority and is never busy for
  /// long.
  Worker& answering() { return moments_; }

 private:
  struct Job;
  using Call = TurnQueue::Call;
  using Params = TurnService<GetBoxes>::Params;

  void answer(Call& call, const Params& params, GetBoxes::Response& response);
  std::shared_ptr<Job> begin(Worker& worker, const Call& call, const Params& params);

  const SceneCopier& scenes_;
  std::atomic<std::size_t> copied_bytes_{0};  ///< bytes of the scene copies of all started requests
  Worker moments_;
  Worker spans_;
  TurnQueue queue_;
  TurnService<GetBoxes> service_;
};

}  // namespace link_bounds
