// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the tables of topics.h and parameter_table.h.
#include "node/interface/usage.h"

#include <sstream>

#include "node/interface/parameter_table.h"
#include "node/interface/parameter_text.h"
#include "node/interface/topics.h"

namespace link_bounds {

std::string usage() {
  std::ostringstream text;
  text
      << "usage: rosrun link_bounds link_bounds_publisher [_PARAMETER:=VALUE ...] [--help] "
         "[--version]\n\n"
         "_PARAMETER:=VALUE sets strings, numbers, true and false. Set lists and maps by rosparam\n"
         "or in a launch file.\n\n"
         "Publishes the exact axis-aligned bounding box of every link of the robot, in one fixed\n"
         "frame, at each tf update.\n\nTopics (name | type | when):\n";
  for (const TopicName& topic : kTopics) {
    text << "  " << topic.name << " | " << topic.type << " | " << topic.when << "\n";
  }
  text << "\nServices (name | type | what):\n";
  for (const TopicName& service : kServices) {
    text << "  " << service.name << " | " << service.type << " | " << service.when << "\n";
  }
  text << "\nParameters, private unless said (name | type | default | meaning):\n"
          "  robot_description | string | (public, found upwards) | the URDF; waited for while "
          "absent\n";
  const Parameters defaults;
  visitParameters(defaults, ParameterRows(text));
  return text.str();
}

}  // namespace link_bounds
