// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "soak_program.h"

#include <ros/ros.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace link_bounds {
namespace {

const ros::WallDuration kPoll(0.01);
const ros::WallDuration kTimeout(60);

}  // namespace

double residentBytes(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("VmRSS:", 0) == 0) return std::atof(line.c_str() + 6) * 1024;
  }
  throw std::runtime_error("the node is gone");
}

void waitFor(const std::function<bool()>& condition, const char* what) {
  const ros::SteadyTime end = ros::SteadyTime::now() + kTimeout;
  while (!condition()) {
    if (!ros::ok() || ros::SteadyTime::now() > end)
      throw std::runtime_error(std::string("waited in vain until ") + what);
    kPoll.sleep();
  }
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
