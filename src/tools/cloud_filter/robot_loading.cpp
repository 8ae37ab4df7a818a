// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/robot_loading.h"

#include <ros/console.h>
#include <ros/init.h>

#include <chrono>

#include "link_bounds/robot/urdf/robot.h"
#include "node/interface/parameter_text.h"
#include "node/threads/queued_function.h"
#include "world/log/log_text.h"

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kPollPeriod(200);  // of the description, until there is one

Worker::Options options(std::function<bool()> on_tick) {
  Worker::Options options;
  options.name = "loader";
  options.on_tick = std::move(on_tick);
  options.tick_period = kPollPeriod;
  return options;
}

void report(const FilteredRobot& robot) {
  for (const std::string& problem : robot.problems)
    ROS_ERROR("%s", logText(problem).c_str());
  for (const std::string& warning : robot.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  std::size_t bytes = 0;
  for (const auto& grid : robot.grids)
    bytes += grid->bytes() + grid->surface().bytes();
  ROS_INFO("filtering the points of %zu links; their grids and triangles take %zu kB",
           robot.links.size(), bytes / 1000);
}

}  // namespace

RobotLoading::RobotLoading(ros::CallbackQueueInterface& queue, Adopt adopt)
    : queue_(queue),
      adopt_(std::move(adopt)),
      server_([this] { return worker_.isStopping(); }),
      description_(server_),
      worker_(options([this] { return onTick(); })) {}

bool RobotLoading::onTick() {
  if (has_loaded_ || has_failed_) return false;
  try {
    load();
  } catch (const NoDescription& reason) {
    description_.warnOfWaiting(reason.what());
  } catch (const std::exception& error) {
    if (worker_.isStopping()) return false;
    ROS_FATAL("%s", logText(error.what()).c_str());
    has_failed_ = true;
    ros::requestShutdown();
  }
  return !has_loaded_ && !has_failed_;
}

void RobotLoading::load() {
  if (!parameters_) {
    const ReadFilterParameters read = readFilterParameters(server_);
    for (const std::string& warning : read.warnings)
      ROS_WARN("%s", logText(warning).c_str());
    parameters_ = read.parameters;
  }
  XmlRpc::XmlRpcValue description = description_.read();
  if (description.getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw RobotError("parameter " + description_.name() + " is " + valueText(description) +
                     ", not a string; load the text of the URDF there");
  }
  const auto is_stopping = [this] { return worker_.isStopping(); };
  auto robot = std::make_shared<const FilteredRobot>(
      filteredRobot(static_cast<std::string&>(description), *parameters_, is_stopping));
  if (worker_.isStopping()) return;
  report(*robot);
  has_loaded_ = true;
  enqueue(queue_, [this, robot] { adopt_(robot); });
}

}  // namespace link_bounds
