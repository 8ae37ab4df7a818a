// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the node.
#include <ros/ros.h>

#include <cstdio>
#include <iostream>

#include "node/interface/command_line.h"
#include "node/interface/end_signals.h"
#include "node/interface/usage.h"
#include "node/master/master_uri.h"
#include "node/publisher_node.h"
#include "node/upkeep/heap.h"
#include "world/log/log_text.h"

namespace {

int run(int argc, char** argv) {
  const link_bounds::CommandLine line =
      link_bounds::readCommandLine(argc, argv, link_bounds::publisherTables());
  if (line.help || line.version) {
    std::cout << (line.help ? link_bounds::usage()
                            : "link_bounds_publisher " LINK_BOUNDS_VERSION "\n");
    return 0;
  }
  link_bounds::checkMasterUri(argc, argv);
  ros::init(argc, argv, "link_bounds_publisher", ros::init_options::NoSigintHandler);
  link_bounds::endOnSignals();
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
