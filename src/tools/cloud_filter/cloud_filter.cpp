// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the program.
#include <ros/ros.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "node/interface/usage.h"
#include "node/master/master_uri.h"
#include "tools/cloud_filter/cloud_filter_node.h"
#include "tools/cloud_filter/filter_parameters.h"
#include "world/log/log_text.h"

namespace {

std::string usage() {
  const link_bounds::FilterParameters defaults;
  return "usage: rosrun link_bounds cloud_filter [_PARAMETER:=VALUE ...] [--help] [--version]\n\n"
         "Removes the points of the robot from point clouds and laser scans: by its exact meshes,\n"
         "at each point's own time.\n\n" +
         link_bounds::interfaceTables(
             link_bounds::kFilterTopics, link_bounds::kFilterServices,
             [&](auto& rows) { link_bounds::visitFilterParameters(defaults, rows); });
}

int run(int argc, char** argv) {
  std::vector<std::string> arguments;
  ros::removeROSArgs(argc, argv, arguments);
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i] == "--help" || arguments[i] == "-h") {
      std::cout << usage();
      return 0;
    }
    if (arguments[i] == "--version") {
      std::cout << "cloud_filter " LINK_BOUNDS_VERSION "\n";
      return 0;
    }
    std::cerr << "argument " << link_bounds::logText(arguments[i]) << " is not known; see --help\n";
    return 1;
  }
  link_bounds::checkMasterUri(argc, argv);
  ros::init(argc, argv, "cloud_filter");
  // roscpp handles SIGINT only; roslaunch and service managers also send SIGTERM.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  link_bounds::CloudFilterNode node(ros::NodeHandle(), ros::NodeHandle("~"), ros::requestShutdown);
  node.spin();
  return node.exitCode();
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // into a pipe, too, lines of the log come at once
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    // ROS's log may have ended already.
    std::cerr << "[FATAL] " << link_bounds::logText(error.what()) << std::endl;
    return 1;
  }
}
