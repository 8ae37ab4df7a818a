// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each call has its own client, because the clients in roscpp's cache belong to its threads.
#include "node/interface/xmlrpc_call.h"

#include <ros/master.h>
#include <ros/time.h>
#include <xmlrpcpp/XmlRpcClient.h>

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kCheckPeriod = 0.1;  // s

bool isAnswer(XmlRpcValue& response) {
  return response.getType() == XmlRpcValue::TypeArray && response.size() == 3 &&
         response[0].getType() == XmlRpcValue::TypeInt;
}

}  // namespace

XmlRpcServer rosMaster() {
  return {ros::master::getHost(), static_cast<int>(ros::master::getPort())};
}

std::optional<XmlRpcAnswer> callXmlRpc(const XmlRpcServer& server, const std::string& method,
                                       const XmlRpcValue& arguments,
                                       const std::function<bool()>& is_cancelled,
                                       ros::WallDuration timeout) {
  XmlRpc::XmlRpcClient client(server.host.c_str(), server.port, "/");
  if (!client.executeNonBlock(method.c_str(), arguments)) return std::nullopt;
  const ros::SteadyTime start = ros::SteadyTime::now();
  XmlRpcValue response;
  while (!client.executeCheckDone(response)) {
    const bool is_broken = client._disp._sources.empty();
    if (is_broken || is_cancelled() || ros::SteadyTime::now() - start > timeout)
      return std::nullopt;
    client._disp.work(kCheckPeriod);
  }
  if (client.isFault() || !isAnswer(response)) return std::nullopt;
  return XmlRpcAnswer{static_cast<int>(response[0]), response[2]};
}

}  // namespace link_bounds
