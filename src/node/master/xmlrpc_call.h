// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Calls of ROS's XML-RPC interfaces that end: those of roscpp wait for an answer without limit.
#pragma once

#include <ros/duration.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <optional>
#include <string>

namespace link_bounds {

struct XmlRpcServer {
  std::string host;
  int port;
};

/// What the master and the nodes answer to every call.
struct XmlRpcAnswer {
  int status;  ///< 1: success
  XmlRpc::XmlRpcValue value;
};

/// Nothing if there is no answer within `patience`, or one that is not of this form, or if
/// `gives_up` says so, which is asked ten times a second.
std::optional<XmlRpcAnswer> callXmlRpc(const XmlRpcServer& server, const std::string& method,
                                       const XmlRpc::XmlRpcValue& arguments,
                                       const std::function<bool()>& gives_up,
                                       ros::WallDuration patience = ros::WallDuration(2.0));

}  // namespace link_bounds
