// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of a node.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "node/interface/parameter_reader.h"

namespace link_bounds {

/// An argument cannot be used; what() names it and the remedy.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The parameters, topics and services of a node.
struct NodeTables {
  /// Reads all parameters of the node.
  std::function<void(ParameterReader& reader)> read_parameters;
  std::vector<std::string> topics;  ///< topics and services; private names begin with ~
};

/// The tables of link_bounds_publisher.
NodeTables publisherTables();

/// The text of --help of link_bounds_publisher.
std::string usage();

struct CommandLine {
  bool help = false;     ///< print the usage and end
  bool version = false;  ///< print the version and end
  std::vector<std::string> warnings;
};

/// Checks all arguments, and the values of parameters among them. Does not contact the ROS master,
/// because a node that registers ends a running node of the same name. Throws ArgumentError and
/// ParameterError.
CommandLine readCommandLine(int argc, const char* const* argv, const NodeTables& tables);

}  // namespace link_bounds
