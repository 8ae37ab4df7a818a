// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The command line of the node.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace link_bounds {

/// An argument cannot be used; what() names it and the remedy.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandLine {
  bool help = false;     ///< print the usage and end
  bool version = false;  ///< print the version and end
  std::vector<std::string> warnings;
};

/// Checks all arguments and the values of parameters among them, without a word to the ROS master:
/// a node that registers ends the running one of its name. Throws ArgumentError and ParameterError.
CommandLine readCommandLine(int argc, const char* const* argv);

}  // namespace link_bounds
