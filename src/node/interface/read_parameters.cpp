// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the parameters of this node on the server.
#include "node/interface/read_parameters.h"

#include <ros/this_node.h>

#include "node/interface/parameter_reader.h"
#include "node/interface/parameter_table.h"

namespace link_bounds {

std::string foundTfPrefix(const ParameterServer& server, const std::string& node) {
  const auto name = server.search(node, "tf_prefix");
  auto value = name ? server.get(*name) : std::nullopt;
  std::string prefix;
  if (value && !fromXml(*value, prefix).empty()) {
    throw ParameterError(wrongValue(*name, *value, "must be a string"));
  }
  return prefix;
}

ReadParameters readParameters(const ParameterServer& server) {
  const std::string& node = ros::this_node::getName();
  XmlRpc::XmlRpcValue values = server.get(node).value_or(XmlRpc::XmlRpcValue());
  ReadParameters result;
  ParameterReader reader(values);
  visitParameters(result.parameters, reader);
  result.parameters.tf_prefix = foundTfPrefix(server, node);
  result.warnings = reader.warnings();
  return result;
}

}  // namespace link_bounds
