// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the node.
#include <ros/network.h>
#include <ros/ros.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "node/interface/command_line.h"
#include "node/interface/usage.h"
#include "node/publisher_node.h"
#include "node/upkeep/heap.h"
#include "world/log/log_text.h"

namespace {

/// roscpp stops the process at a breakpoint where it cannot read the URI: that of the last argument
/// __master, or of the environment.
void checkMasterUri(int argc, char** argv) {
  std::string name = "ROS_MASTER_URI";
  const char* const set = std::getenv(name.c_str());
  std::string uri = set ? set : "";
  const std::string begin = "__master:=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.compare(0, begin.size(), begin) != 0) continue;
    name = "__master";
    uri = argument.substr(begin.size());
  }
  if (uri.empty() && name != "__master") return;
  std::string host;
  std::uint32_t port = 0;
  if (ros::network::splitURI(uri, host, port) && port > 0 && port <= 65535) return;
  throw std::runtime_error(name + " is \"" + uri + "\"; it must be http://HOST:PORT");
}

int run(int argc, char** argv) {
  const link_bounds::CommandLine line = link_bounds::readCommandLine(argc, argv);
  if (line.help || line.version) {
    std::cout << (line.help ? link_bounds::usage()
                            : "link_bounds_publisher " LINK_BOUNDS_VERSION "\n");
    return 0;
  }
  checkMasterUri(argc, argv);
  ros::init(argc, argv, "link_bounds_publisher");
  // roscpp handles SIGINT only; roslaunch and service managers also send SIGTERM.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  for (const std::string& warning : line.warnings)
    ROS_WARN("%s", link_bounds::logText(warning).c_str());
  link_bounds::PublisherNode node;
  node.spin();
  return node.exitCode();
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // into a pipe, too, lines of the log come at once
  link_bounds::returnLargeBlocks();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    // ROS's log may have ended already.
    std::cerr << "[FATAL] " << link_bounds::logText(error.what()) << std::endl;
    return 1;
  }
}
