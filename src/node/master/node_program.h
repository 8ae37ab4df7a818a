// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The main program of a node.
#pragma once

#include <functional>
#include <string>

#include "node/interface/command_line.h"

namespace link_bounds {

struct NodeProgram {
  std::string name;                    ///< name of the program and default name of the node
  std::string version;                 ///< for --version
  std::function<std::string()> usage;  ///< for --help
  NodeTables tables;
  std::function<int()> spin;  ///< makes the node, spins it, and gives the exit code
};

/// Call from main(). An exception is printed as one line, and the exit code is 1. SIGINT and
/// SIGTERM shut the node down cleanly. If that takes longer than 10 s, for example because roscpp
/// waits for a master that does not answer, SIGALRM ends the process.
int runNode(int argc, char** argv, const NodeProgram& program);

}  // namespace link_bounds
