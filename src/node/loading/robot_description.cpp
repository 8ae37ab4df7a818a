// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// To a caller, a master that does not answer is a reason to wait, too.
#include "node/loading/robot_description.h"

#include <ros/console.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kWarningPeriod(10.0);
const std::string kName = "robot_description";

std::string fullName() {
  return ParameterServer::resolved(ros::this_node::getNamespace(), kName);
}

bool isRemapped() {
  return fullName() != ros::names::append(ros::this_node::getNamespace(), kName);
}

}  // namespace

std::string RobotDescription::name() const {
  return kName + (isRemapped() ? " (remapped to " + fullName() + ")" : "");
}

XmlRpc::XmlRpcValue RobotDescription::read() const {
  const std::string& ns = ros::this_node::getNamespace();
  try {
    const auto found = server_.search(ns, kName);
    if (found) {
      if (const auto description = server_.get(*found)) return *description;
    }
  } catch (const NoMaster& error) {
    throw NoDescription(error.what());
  }
  throw NoDescription(
      "parameter " + fullName() + " is not set" +
      (isRemapped() || ns == "/" ? "" : ", nor one of that name in a namespace above") +
      "; load the URDF there");
}

void RobotDescription::warnOfWaiting(const std::string& reason) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!last_warning_.isZero() && now - last_warning_ < kWarningPeriod) return;
  last_warning_ = now;
  ROS_WARN("waiting for parameter %s: %s", logText(name()).c_str(), logText(reason).c_str());
}

}  // namespace link_bounds
