// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the node.
#include <ros/network.h>
#include <ros/ros.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "node/interface/usage.h"
#include "node/log/log_text.h"
#include "node/memory/heap.h"
#include "node/publisher_node.h"

namespace {

/// roscpp stops the process at a breakpoint where it cannot read the URI.
void checkMasterUri() {
  const char* uri = std::getenv("ROS_MASTER_URI");
  if (!uri || *uri == '\0') return;
  std::string host;
  std::uint32_t port = 0;
  if (ros::network::splitURI(uri, host, port) && port > 0 && port <= 65535) return;
  throw std::runtime_error("ROS_MASTER_URI is \"" + std::string(uri) +
                           "\"; it must be http://HOST:PORT");
}

int run(int argc, char** argv) {
  checkMasterUri();
  ros::init(argc, argv, "link_bounds_publisher");
  // roscpp handles SIGINT only; roslaunch and service managers also send SIGTERM.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  link_bounds::PublisherNode node;
  ros::spin();
  return node.exitCode();
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--help") == 0 || std::strcmp(argv[i], "-h") == 0) {
      std::cout << link_bounds::usage();
      return 0;
    }
  }
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
