// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameters of the node.
#pragma once

#include <string>
#include <vector>

#include "node/interface/parameter_server.h"
#include "world/model/parameter_error.h"
#include "world/model/parameters.h"

namespace link_bounds {

struct ReadParameters {
  Parameters parameters;
  std::vector<std::string> warnings;  ///< one per unknown private name
};

/// Reads the private parameters of this node; tf_prefix also from the namespaces above.
/// Throws ParameterError, NoMaster.
ReadParameters readParameters(const ParameterServer& server);

/// In the private namespace of that node or the nearest one above it, as robot_state_publisher
/// finds it; "" if it is not set. Throws the same.
std::string foundTfPrefix(const ParameterServer& server, const std::string& node);

}  // namespace link_bounds
