// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lets urdfdom parse each element alone, in a robot with one link.
#include "robot/urdf/urdf_losses.h"

#include <urdf_parser/urdf_parser.h>

#include "robot/urdf/urdf_log.h"

namespace link_bounds {
namespace {

/// Why urdfdom cannot parse the element alone; "" if it can.
std::string faultOf(const std::string& element, Purpose purpose) {
  const UrdfLog log(element);
  const auto model =
      urdf::parseURDF("<robot name='r'><link name='l'>" + element + "</link></robot>");
  const auto link = model ? model->getLink("l") : nullptr;
  const bool parsed = link && (purpose == Purpose::kVisual ? link->visual_array.size()
                                                           : link->collision_array.size()) == 1;
  if (parsed) return "";
  return "it cannot be parsed (" + log.messages() + "); correct its numbers and attributes";
}

}  // namespace

std::vector<LostElement> lostElements(const LinkOutline& link, Purpose purpose, std::size_t kept,
                                      const std::string& link_messages) {
  std::vector<LostElement> lost;
  const std::vector<std::string>& elements = link.elements(purpose);
  for (std::size_t i = kept; i < elements.size(); ++i) {
    std::string reason = faultOf(elements[i], purpose);
    if (reason.empty()) {
      reason = "urdfdom drops it because of another fault in this link (" + link_messages +
               "); correct that fault";
    }
    lost.push_back({purpose, i + 1, reason});
  }
  return lost;
}

}  // namespace link_bounds
