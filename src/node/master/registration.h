// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How this node stands at the ROS master, and how it gets back there after the master was
// restarted.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <optional>
#include <string>

#include "node/master/xmlrpc_call.h"

namespace link_bounds {

enum class Standing { kUnreachable, kUnknown, kKnown, kNameTaken };

/// Calls a method of one server; nothing if it cannot be reached.
using XmlRpcCall = std::function<std::optional<XmlRpcAnswer>(const std::string& method,
                                                             const XmlRpc::XmlRpcValue& arguments)>;

/// kNameTaken: another node is registered under our name.
Standing askStanding(const XmlRpcCall& master);

/// Registers everything that this node publishes, subscribes and serves, as it is: no connection
/// is lost. `node` reaches the node itself, which knows best what that is. False if the master
/// went away meanwhile.
bool registerAgain(const XmlRpcCall& master, const XmlRpcCall& node);

}  // namespace link_bounds
