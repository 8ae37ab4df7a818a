// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameters of a node from the parameter server.
#pragma once

#include <string>
#include <vector>

#include "node/interface/parameter_reader.h"
#include "node/interface/parameter_server.h"

namespace link_bounds {

/// The value of tf_prefix in the private namespace of `node` or the nearest namespace above it, as
/// robot_state_publisher finds it; "" if it is not set. Throws ParameterError, NoMaster.
inline std::string foundTfPrefix(const ParameterServer& server, const std::string& node) {
  const auto name = server.search(node, "tf_prefix");
  auto value = name ? server.get(*name) : std::nullopt;
  std::string prefix;
  if (value && !fromXml(*value, prefix).empty()) {
    throw ParameterError(wrongValue(*name, *value, "must be a string"));
  }
  return prefix;
}

template <class Parameters>
struct ReadParameters {
  Parameters parameters;
  std::vector<std::string> warnings;  ///< one per unknown private parameter
};

/// The private parameters of the node with full name `node`. `visit` calls a visitor with each
/// parameter, as visitParameters() does. Throws ParameterError, NoMaster.
template <class Parameters, class Visit>
ReadParameters<Parameters> readParameters(const ParameterServer& server, const std::string& node,
                                          const Visit& visit) {
  XmlRpc::XmlRpcValue values = server.get(node).value_or(XmlRpc::XmlRpcValue());
  ReadParameters<Parameters> result;
  ParameterReader reader(values);
  visit(result.parameters, reader);
  result.parameters.tf_prefix = foundTfPrefix(server, node);
  result.warnings = reader.warnings();
  return result;
}

}  // namespace link_bounds
