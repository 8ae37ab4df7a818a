// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables in the text of --help.
#pragma once

#include <sstream>
#include <string>

#include "node/interface/parameter_text.h"
#include "node/interface/topics.h"

namespace link_bounds {

/// Topics, services and parameters, one per line, with the same cells as the tables in the
/// documentation. `visit_parameters` gets a visitor and calls it with each parameter, as
/// visitParameters() does.
template <class Topics, class Services, class VisitParameters>
std::string interfaceTables(const Topics& topics, const Services& services,
                            const VisitParameters& visit_parameters) {
  std::ostringstream text;
  const auto add = [&text](const TopicName& row) {
    text << "  " << row.name << " | " << row.type << " | " << row.when << "\n";
  };
  text << "Topics (name | type | when):\n";
  for (const TopicName& topic : topics)
    add(topic);
  text << "\nServices (name | type | what):\n";
  for (const TopicName& service : services)
    add(service);
  text << "\nParameters, private unless said (name | type | default | meaning):\n"
          "  robot_description | string | (public, found upwards) | the URDF; waited for while "
          "absent\n";
  ParameterRows rows(text);
  visit_parameters(rows);
  return text.str();
}

}  // namespace link_bounds
