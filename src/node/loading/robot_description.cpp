// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// To a caller, a master that does not answer is a reason to wait, too.
#include "node/loading/robot_description.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include "node/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kWarningPeriod(10.0);

}  // namespace

XmlRpc::XmlRpcValue RobotDescription::read() const {
  try {
    const auto name = server_.search(ros::this_node::getNamespace(), "robot_description");
    if (name) {
      if (const auto description = server_.get(*name)) return *description;
    }
  } catch (const NoMaster& error) {
    throw NoDescription(error.what());
  }
  throw NoDescription("parameter robot_description is not set");
}

void RobotDescription::warnOfWaiting(const std::string& reason) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!last_warning_.isZero() && now - last_warning_ < kWarningPeriod) return;
  last_warning_ = now;
  ROS_WARN("waiting for parameter robot_description: %s", logText(reason).c_str());
}

}  // namespace link_bounds
