// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/master/node_program.h"

#include <ros/network.h>
#include <ros/ros.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

/// Throws std::runtime_error if the master's address cannot be read: roscpp would stop the process
/// at a breakpoint. The address is that of the last argument __master, or of the environment.
void checkMasterUri(int argc, char** argv) {
  std::string name = "ROS_MASTER_URI";
  const char* const set = std::getenv(name.c_str());
  bool is_set = set != nullptr;
  std::string uri = is_set ? set : "";
  const std::string begin = "__master:=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.compare(0, begin.size(), begin) != 0) continue;
    name = "__master";
    is_set = true;
    uri = argument.substr(begin.size());
  }
  if (!is_set) return;
  std::string host;
  std::uint32_t port = 0;
  // splitURI() is roscpp's own parser.
  if (ros::network::splitURI(uri, host, port) && port > 0 && port <= 65535) return;
  throw std::runtime_error(name + " is \"" + uri + "\"; it must be http://HOST:PORT");
}

void endOnSignals() {
  for (const int number : {SIGINT, SIGTERM}) {
    std::signal(number, [](int) {
      ros::requestShutdown();
      static std::atomic<bool> is_set = false;  // two threads may handle a signal at the same time
      if (!is_set.exchange(true)) alarm(10);
    });
  }
}

int run(int argc, char** argv, const NodeProgram& program) {
  const CommandLine line = readCommandLine(argc, argv, program.tables);
  if (line.help || line.version) {
    std::cout << (line.help ? program.usage() : program.name + " " + program.version + "\n");
    if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
    return 0;
  }
  checkMasterUri(argc, argv);
  ros::init(argc, argv, program.name, ros::init_options::NoSigintHandler);
  endOnSignals();
  for (const std::string& warning : line.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  return program.spin();
}

}  // namespace

int runNode(int argc, char** argv, const NodeProgram& program) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // by lines: a pipe also gets log lines at once
  std::signal(SIGXFSZ, SIG_IGN);             // a write beyond `ulimit -f` then only fails
  try {
    return run(argc, argv, program);
  } catch (const std::bad_alloc&) {
    std::cerr << "[FATAL] out of memory; raise the limit of memory (ulimit -v)" << std::endl;
    return 1;
  } catch (const std::exception& error) {
    // The log of ROS may have been shut down already.
    std::cerr << "[FATAL] " << logText(error.what()) << std::endl;
    return 1;
  }
}

}  // namespace link_bounds
