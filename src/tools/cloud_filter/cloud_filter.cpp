// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the program.
#include <ros/ros.h>

#include <string>

#include "node/interface/command_line.h"
#include "node/interface/usage.h"
#include "node/master/master_watch.h"
#include "node/master/node_program.h"
#include "tools/cloud_filter/cloud_filter_node.h"
#include "tools/cloud_filter/filter_parameters.h"

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

link_bounds::NodeTables filterTables() {
  link_bounds::NodeTables tables;
  tables.read_parameters = [](link_bounds::ParameterReader& reader) {
    link_bounds::FilterParameters ignored;
    link_bounds::visitFilterParameters(ignored, reader);
  };
  for (const link_bounds::TopicName& topic : link_bounds::kFilterTopics)
    tables.topics.emplace_back(topic.name);
  for (const link_bounds::TopicName& service : link_bounds::kFilterServices)
    tables.topics.emplace_back(service.name);
  return tables;
}

int spin() {
  link_bounds::CloudFilterNode node(ros::NodeHandle(), ros::NodeHandle("~"), ros::requestShutdown);
  const link_bounds::MasterWatch master_watch;
  node.spin();
  return node.exitCode();
}

}  // namespace

int main(int argc, char** argv) {
  return link_bounds::runNode(argc, argv,
                              {"cloud_filter", LINK_BOUNDS_VERSION, usage, filterTables(), spin});
}
