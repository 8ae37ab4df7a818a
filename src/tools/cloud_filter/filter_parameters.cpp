// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filter_parameters.h"

#include <ros/this_node.h>

#include <sstream>

#include "node/interface/parameter_reader.h"
#include "node/interface/parameter_text.h"

namespace link_bounds {

ReadFilterParameters readFilterParameters(const ParameterServer& server) {
  XmlRpc::XmlRpcValue values =
      server.get(ros::this_node::getName()).value_or(XmlRpc::XmlRpcValue());
  ReadFilterParameters result;
  ParameterReader reader(values);
  visitFilterParameters(result.parameters, reader);
  result.warnings = reader.warnings();
  return result;
}

std::string filterUsage() {
  std::ostringstream text;
  text
      << "usage: rosrun link_bounds cloud_filter [_PARAMETER:=VALUE ...] [--help] [--version]\n\n"
         "Removes the points of the robot from point clouds and laser scans: by its exact meshes,\n"
         "at each point's own time.\n\nTopics (name | type | when):\n";
  for (const TopicName& topic : kFilterTopics)
    text << "  " << topic.name << " | " << topic.type << " | " << topic.when << "\n";
  text << "\nParameters, private unless said (name | type | default | meaning):\n"
          "  robot_description | string | (public, found upwards) | the URDF; waited for while "
          "absent\n";
  const FilterParameters defaults;
  visitFilterParameters(defaults, ParameterRows(text));
  return text.str();
}

}  // namespace link_bounds
