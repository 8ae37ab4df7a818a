// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "soak_program.h"

#include <ros/ros.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "testing/patience.h"

namespace link_bounds {
namespace {

constexpr std::chrono::seconds kTimeout(60);

}  // namespace

void waitFor(const std::function<bool()>& condition, const char* what) {
  if (!becomesTrue(condition, kTimeout, [] { return !ros::ok(); }))
    throw std::runtime_error(std::string("waited in vain until ") + what);
}

Robot describedRobot(const ros::NodeHandle& node) {
  std::string description;
  node.getParam("robot_description", description);
  return parseRobot(description);
}

int runSoak(int argc, char** argv, const std::string& name,
            const std::function<bool(const SoakArguments&)>& soak) {
  ros::init(argc, argv, name);
  SoakArguments arguments{};
  if (argc == 4) arguments = {std::atoi(argv[1]), std::atoi(argv[2]), std::atof(argv[3]) * 1e6};
  if (arguments.minutes < 1 || arguments.pid < 1 || !(arguments.max_growth > 0)) {
    std::cerr << "usage: " << name << " MINUTES PID_OF_THE_NODE MAX_GROWTH_IN_MB\n";
    return 2;
  }
  ros::AsyncSpinner spinner(1);
  spinner.start();
  try {
    return soak(arguments) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 1;
  }
}

}  // namespace link_bounds
