// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The links, geometry elements and joints in the XML of a URDF, found without urdfdom.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

struct ElementOutline {
  std::string xml;  ///< without its material
  /// A message, with the remedy, about a part that it has twice, of which urdfdom reads the first;
  /// else "".
  std::string surplus;
};

struct LinkOutline {
  std::string name;
  std::vector<ElementOutline> visuals;
  std::vector<ElementOutline> collisions;

  const std::vector<ElementOutline>& elements(Purpose purpose) const {
    return purpose == Purpose::kVisual ? visuals : collisions;
  }
};

struct RobotOutline {
  std::vector<LinkOutline> links;     ///< in the order of the text
  std::vector<std::string> warnings;  ///< about joints that have an element twice
};

/// Empty if the XML is malformed; urdfdom's parser is more lenient. Throws RobotError if elements
/// are nested so deeply that urdfdom's recursive parser could overflow the stack.
RobotOutline outlineOf(const std::string& urdf);

/// The text from the first element on, without the comments and the XML declaration before it.
std::string fromFirstElement(const std::string& urdf);

}  // namespace link_bounds
