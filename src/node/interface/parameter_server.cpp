// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses getParam and searchParam of the Parameter Server API of ROS.
#include "node/interface/parameter_server.h"

#include <ros/names.h>
#include <ros/this_node.h>
#include <ros/time.h>

#include "node/interface/xmlrpc_call.h"

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

const ros::WallDuration kTimeout(10.0);
const ros::WallDuration kRetryPause(0.1);

std::string remapped(const std::string& name) {
  const auto& remappings = ros::names::getUnresolvedRemappings();
  const auto found = remappings.find(name);
  return found == remappings.end() ? name : found->second;
}

}  // namespace

std::optional<XmlRpcValue> ParameterServer::get(const std::string& name) const {
  return call("getParam", ros::this_node::getName(), ros::names::resolve(name));
}

std::string ParameterServer::resolved(const std::string& ns, const std::string& name) {
  return ros::names::resolve(ns, remapped(name), false);
}

/// searchParam takes the name of the caller as the first namespace and searches upward, so `ns` is
/// passed as the caller.
std::optional<std::string> ParameterServer::search(const std::string& ns,
                                                   const std::string& name) const {
  auto found = call("searchParam", ns, remapped(name));
  if (!found || found->getType() != XmlRpcValue::TypeString) return std::nullopt;
  return static_cast<std::string>(*found);
}

std::optional<XmlRpcValue> ParameterServer::call(const std::string& method,
                                                 const std::string& caller,
                                                 const std::string& name) const {
  XmlRpcValue arguments;
  arguments[0] = caller;
  arguments[1] = name;
  const ros::SteadyTime end = ros::SteadyTime::now() + kTimeout;
  for (ros::WallDuration left = kTimeout; left > ros::WallDuration(0);
       left = end - ros::SteadyTime::now()) {
    const auto answer = callXmlRpc(rosMaster(), method, arguments, is_cancelled_, left);
    if (answer) return answer->isSuccess() ? std::optional(answer->value) : std::nullopt;
    if (is_cancelled_()) break;
    kRetryPause.sleep();
  }
  throw NoMaster("the ROS master does not answer " + method + " of " + name);
}

}  // namespace link_bounds
