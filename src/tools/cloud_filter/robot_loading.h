// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread: reads the parameters, waits for the robot description, loads the robot,
// answers ~reload.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "node/interface/parameter_server.h"
#include "node/loading/robot_description.h"
#include "node/threads/worker.h"
#include "tools/cloud_filter/filtered_robot.h"

namespace link_bounds {

class RobotLoading {
 public:
  struct Handlers {
    /// On the thread that serves the queue.
    std::function<void(std::shared_ptr<const FilteredRobot>)> adopt;
    /// On the loader thread: the first load failed for good, which was logged.
    std::function<void()> on_failure;
  };

  RobotLoading(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               ros::CallbackQueueInterface& queue, Handlers handlers);
  ~RobotLoading() { worker_.stop(); }
  RobotLoading(const RobotLoading&) = delete;
  RobotLoading& operator=(const RobotLoading&) = delete;

  /// True if the parameters or the description cannot be used.
  bool hasFailed() const { return has_failed_; }

  /// For other work that takes long.
  Worker& worker() { return worker_; }

 private:
  bool onTick();
  std::vector<std::string> load(const FilterParameters& parameters);
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);

  std::string name_;  ///< full one of the node
  ros::CallbackQueueInterface& queue_;
  Handlers handlers_;
  ParameterServer server_;
  RobotDescription description_;
  std::optional<FilterParameters> parameters_;  ///< for the first load
  bool has_loaded_ = false;
  std::atomic<bool> has_failed_{false};
  Worker worker_;  ///< after all that its thread uses
  ros::ServiceServer reload_service_;
};

}  // namespace link_bounds
