// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The links and geometry elements that a URDF text has, seen without urdfdom.
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

/// In the order of the text. Empty if the XML is broken in a way that only urdfdom's more lenient
/// parser overlooks. Throws RobotError if elements are nested so deeply that urdfdom's recursive
/// parser would not survive it.
std::vector<LinkOutline> outlineOf(const std::string& urdf);

/// The text from the first element on, without comments and the XML declaration before it.
std::string fromFirstElement(const std::string& urdf);

}  // namespace link_bounds
