// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// If the ROS master does not answer, read() throws the same error as for a missing parameter: both
// are reasons to wait.
#include "node/loading/robot_description.h"

#include <ros/console.h>
#include <ros/names.h>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kWarningPeriod(10.0);
const std::string kName = "robot_description";

/// The namespace of the node. roscpp returns "" for a nodelet in the root namespace.
std::string namespaceOf(const ros::NodeHandle& node) {
  return node.getNamespace().empty() ? "/" : node.getNamespace();
}

/// `kName`; or the remapped name, if the node has a remapping that its process does not have.
std::string nameFor(const ros::NodeHandle& node) {
  const std::string remapped = node.resolveName(kName);
  return remapped == ros::names::resolve(namespaceOf(node), kName) ? kName : remapped;
}

}  // namespace

RobotDescription::RobotDescription(const ParameterServer& server, const ros::NodeHandle& node)
    : server_(server), ns_(namespaceOf(node)), name_(nameFor(node)) {}

std::string RobotDescription::fullName() const {
  return ParameterServer::resolved(ns_, name_);
}

bool RobotDescription::isRemapped() const {
  return fullName() != ros::names::append(ns_, kName);
}

std::string RobotDescription::name() const {
  return kName + (isRemapped() ? " (remapped to " + fullName() + ")" : "");
}

XmlRpc::XmlRpcValue RobotDescription::read() const {
  try {
    const auto found = server_.search(ns_, name_);
    if (found) {
      if (const auto description = server_.get(*found)) return *description;
    }
  } catch (const NoMaster& error) {
    throw NoDescription(error.what());
  }
  throw NoDescription(
      "parameter " + fullName() + " is not set" +
      (isRemapped() || ns_ == "/" ? "" : ", nor one of that name in a namespace above") +
      "; load the URDF there");
}

void RobotDescription::warnOfWaiting(const std::string& reason) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!last_warning_.isZero() && now - last_warning_ < kWarningPeriod) return;
  last_warning_ = now;
  ROS_WARN("waiting for parameter %s: %s", logText(name()).c_str(), logText(reason).c_str());
}

}  // namespace link_bounds
