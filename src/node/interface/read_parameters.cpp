// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the parameters of this node on the server.
#include "node/interface/read_parameters.h"

#include <ros/this_node.h>

#include "node/interface/parameter_reader.h"
#include "node/interface/parameter_table.h"

namespace link_bounds {
namespace {

/// In the private namespace or the nearest one above it, as robot_state_publisher does.
std::string foundTfPrefix(const ParameterServer& server) {
  const auto name = server.search(ros::this_node::getName(), "tf_prefix");
  auto value = name ? server.get(*name) : std::nullopt;
  std::string prefix;
  if (value && !fromXml(*value, prefix).empty()) {
    throw ParameterError(wrongValue(*name, *value, "must be a string"));
  }
  return prefix;
}

}  // namespace

ReadParameters readParameters(const ParameterServer& server) {
  XmlRpc::XmlRpcValue values =
      server.get(ros::this_node::getName()).value_or(XmlRpc::XmlRpcValue());
  ReadParameters result;
  ParameterReader reader(values);
  visitParameters(result.parameters, reader);
  result.parameters.tf_prefix = foundTfPrefix(server);
  result.warnings = reader.warnings();
  return result;
}

}  // namespace link_bounds
