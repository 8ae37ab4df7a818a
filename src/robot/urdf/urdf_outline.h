// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The links and geometry elements in the XML of a URDF, found without urdfdom.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

struct LinkOutline {
  std::string name;
  std::vector<std::string> visuals;     ///< each element as XML, without its material
  std::vector<std::string> collisions;  ///< likewise

  const std::vector<std::string>& elements(Purpose purpose) const {
    return purpose == Purpose::kVisual ? visuals : collisions;
  }
};

/// In the order of the text. Empty if the XML is malformed; urdfdom's parser is more lenient.
/// Throws RobotError if elements are nested so deeply that urdfdom's recursive parser could
/// overflow the stack.
std::vector<LinkOutline> outlineOf(const std::string& urdf);

/// The text from the first element on, without the comments and the XML declaration before it.
std::string fromFirstElement(const std::string& urdf);

}  // namespace link_bounds
