// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/request/left_out.h"

namespace link_bounds {

std::string leftOutNote(const Robot& robot, const Selection& selection) {
  if (selection.visual && selection.collision) return "";
  const Purpose chosen = selection.visual ? Purpose::kVisual : Purpose::kCollision;
  const Purpose other = selection.visual ? Purpose::kCollision : Purpose::kVisual;
  std::string names;
  for (const Link& link : robot.links) {
    if (!hasGeometry(link, chosen) && hasGeometry(link, other))
      names += (names.empty() ? "\"" : ", \"") + link.name + "\"";
  }
  if (names.empty()) return "";
  return "left out are links with " + std::string(toText(other)) + " geometry only: " + names;
}

}  // namespace link_bounds
