// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// XML-RPC calls with a timeout, because roscpp's calls have none.
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

XmlRpcServer rosMaster();

/// An answer of the master or of a node: all have this form.
struct XmlRpcAnswer {
  int status;
  XmlRpc::XmlRpcValue value;

  bool isSuccess() const { return status == 1; }
};

/// nullopt if there is no valid answer within `timeout`, or if `is_cancelled`, which is called
/// about ten times a second, returns true.
std::optional<XmlRpcAnswer> callXmlRpc(const XmlRpcServer& server, const std::string& method,
                                       const XmlRpc::XmlRpcValue& arguments,
                                       const std::function<bool()>& is_cancelled,
                                       ros::WallDuration timeout = ros::WallDuration(2.0));

}  // namespace link_bounds
