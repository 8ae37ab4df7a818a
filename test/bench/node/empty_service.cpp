// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A node with a service that does nothing: the least that a service of roscpp takes.
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include "bench/common/processes.h"

namespace link_bounds::bench {
namespace {

bool doNothing(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  return true;
}

}  // namespace

void runEmptyService(const Words&) {
  ros::NodeHandle private_node("~");
  const ros::ServiceServer service = private_node.advertiseService("service", doNothing);
  ros::spin();
}

}  // namespace link_bounds::bench
