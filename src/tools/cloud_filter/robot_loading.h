// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread: reads the parameters, waits for the robot description, loads the robot.
#pragma once

#include <ros/callback_queue_interface.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "node/interface/parameter_server.h"
#include "node/loading/robot_description.h"
#include "node/threads/worker.h"
#include "tools/cloud_filter/filtered_robot.h"

namespace link_bounds {

class RobotLoading {
 public:
  using Adopt = std::function<void(std::shared_ptr<const FilteredRobot>)>;

  /// `adopt` is called once, on the thread that serves the queue.
  RobotLoading(ros::CallbackQueueInterface& queue, Adopt adopt);

  /// True if the parameters or the description cannot be used; the program is then shutting down.
  bool hasFailed() const { return has_failed_; }

 private:
  bool onTick();
  void load();

  ros::CallbackQueueInterface& queue_;
  Adopt adopt_;
  ParameterServer server_;
  RobotDescription description_;
  std::optional<FilterParameters> parameters_;
  bool has_loaded_ = false;
  std::atomic<bool> has_failed_{false};
  Worker worker_;  ///< after all that its thread uses
};

}  // namespace link_bounds
