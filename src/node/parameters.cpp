// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which parameters of the server are those of this node.
#include "parameters.h"

#include <ros/node_handle.h>
#include <ros/param.h>

#include "parameter_reader.h"
#include "parameter_table.h"

namespace link_bounds {
namespace {

/// As robot_state_publisher finds it: in the private namespace, else in those above.
std::string foundTfPrefix(const ros::NodeHandle& private_node) {
  std::string key;
  std::string prefix;
  if (!private_node.searchParam("tf_prefix", key)) return "";
  if (!ros::param::get(key, prefix)) throw ParameterError("parameter " + key + " must be a string");
  return prefix;
}

}  // namespace

ReadParameters readParameters() {
  const ros::NodeHandle private_node("~");
  XmlRpc::XmlRpcValue values;
  ros::param::get(private_node.getNamespace(), values);
  ReadParameters result;
  ParameterReader reader(values);
  visitParameters(result.parameters, reader);
  result.parameters.tf_prefix = foundTfPrefix(private_node);
  for (const std::string& name : reader.unknownNames()) {
    if (name == "diagnostic_period") continue;  // diagnostic_updater's
    result.warnings.push_back("parameter ~" + name + " is unknown and ignored; see --help");
  }
  return result;
}

}  // namespace link_bounds
