// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/robot_loading.h"

#include <ros/console.h>

#include <chrono>
#include <set>

#include "link_bounds/robot/urdf/robot.h"
#include "node/interface/parameter_text.h"
#include "node/interface/topics.h"
#include "node/loading/reloaded_text.h"
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

void report(const FilteredRobot& robot, std::chrono::steady_clock::duration duration) {
  for (const std::string& problem : robot.problems)
    ROS_ERROR("%s", logText(problem).c_str());
  for (const std::string& warning : robot.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  std::size_t bytes = 0;
  for (const auto& grid :
       std::set<std::shared_ptr<const BodyGrid>>(robot.grids.begin(), robot.grids.end()))
    bytes += grid->bytes() + grid->surface().bytes();
  ROS_INFO(
      "filtering the points of %zu links; they were loaded in %.1f s, and their grids and "
      "triangles take %zu kB",
      robot.links.size(), std::chrono::duration<double>(duration).count(), bytes / 1000);
}

ReadFilterParameters readAndWarn(const ParameterServer& server, const std::string& name) {
  ReadFilterParameters read = readFilterParameters(server, name);
  for (const std::string& warning : read.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  return read;
}

}  // namespace

RobotLoading::RobotLoading(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           ros::CallbackQueueInterface& queue, Handlers handlers)
    : name_(private_node.getNamespace()),
      queue_(queue),
      handlers_(std::move(handlers)),
      server_([this] { return worker_.isStopping(); }),
      description_(server_, node),
      worker_(options([this] { return onTick(); })) {
  ros::NodeHandle loader_node(private_node);
  loader_node.setCallbackQueue(&worker_);
  reload_service_ =
      loader_node.advertiseService(privateName(kFilterReload), &RobotLoading::onReload, this);
}

bool RobotLoading::onTick() {
  if (has_loaded_ || has_failed_) return false;
  try {
    if (!parameters_) parameters_ = readAndWarn(server_, name_).parameters;
    load(*parameters_);
  } catch (const NoDescription& reason) {
    description_.warnOfWaiting(reason.what());
  } catch (const std::exception& error) {
    if (worker_.isStopping()) return false;
    ROS_FATAL("%s", logText(error.what()).c_str());
    has_failed_ = true;
    handlers_.on_failure();
  }
  return !has_loaded_ && !has_failed_;
}

/// Returns what was logged of the robot.
std::vector<std::string> RobotLoading::load(const FilterParameters& parameters) {
  XmlRpc::XmlRpcValue description = description_.read();
  if (description.getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw RobotError("parameter " + description_.name() + " is " + valueText(description) +
                     ", not a string; load the text of the URDF there");
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto is_stopping = [this] { return worker_.isStopping(); };
  const auto robot = std::make_shared<const FilteredRobot>(
      filteredRobot(static_cast<std::string&>(description), parameters, is_stopping));
  if (worker_.isStopping()) return {};
  report(*robot, std::chrono::steady_clock::now() - begin);
  const auto adopt = [this, robot] {
    handlers_.adopt(robot);
    return true;
  };
  if (worker_.await(queue_, adopt)) has_loaded_ = true;
  std::vector<std::string> lines = robot->problems;
  lines.insert(lines.end(), robot->warnings.begin(), robot->warnings.end());
  return lines;
}

bool RobotLoading::onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  try {
    const ReadFilterParameters read = readAndWarn(server_, name_);
    std::vector<std::string> warnings = read.warnings;
    const std::vector<std::string> lines = load(read.parameters);
    warnings.insert(warnings.end(), lines.begin(), lines.end());
    response.message = reloadedText(warnings);
    response.success = true;
  } catch (const std::exception& error) {
    const std::string reason = logText(error.what());
    ROS_ERROR("reload failed, everything stays as it was: %s", reason.c_str());
    response.success = false;
    response.message = reason;
  }
  return true;
}

}  // namespace link_bounds
