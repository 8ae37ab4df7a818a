// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the ROS master knows this node, and how the node registers with a restarted master.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "node/interface/xmlrpc_call.h"

namespace link_bounds {

enum class Registration { kUnreachable, kUnknown, kKnown, kNameTaken };

/// Calls a method of one server. nullopt if there is no answer.
using XmlRpcCall = std::function<std::optional<XmlRpcAnswer>(const std::string& method,
                                                             const XmlRpc::XmlRpcValue& arguments)>;

/// kNameTaken: another node has registered under the name of this one.
Registration queryRegistration(const XmlRpcCall& master);

/// The nodes that publish the topic; nullopt if the master does not answer.
std::optional<std::set<std::string>> publishersOf(const XmlRpcCall& master,
                                                  const std::string& topic);

/// The XML-RPC address of a node. "" if the master does not know the node; nullopt if the master
/// does not answer.
std::optional<std::string> addressOf(const XmlRpcCall& master, const std::string& node);

/// Registers all publishers, subscribers and services of this node again; no connection is lost.
/// `node` calls this node itself, which lists its topics. False if a call fails.
bool registerAgain(const XmlRpcCall& master, const XmlRpcCall& node);

}  // namespace link_bounds
