// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A program that is one node.
#pragma once

#include <functional>
#include <string>

#include "node/interface/command_line.h"

namespace link_bounds {

struct NodeProgram {
  std::string name;                    ///< of the program, and of the node unless it is remapped
  std::string version;                 ///< for --version
  std::function<std::string()> usage;  ///< for --help
  NodeTables tables;
  std::function<int()> spin;  ///< makes the node, spins it, and gives the exit code
};

/// To be called by main(). What it throws is logged, as one line, and 1 is returned. SIGINT and
/// SIGTERM end the node in order. Where that takes longer than 10 s, as roscpp waits for a master
/// that does not answer, SIGALRM ends the process.
int runNode(int argc, char** argv, const NodeProgram& program);

}  // namespace link_bounds
