// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One pass over all joints is enough, because parents come before children.
#include "robot/urdf/joints_above.h"

namespace link_bounds {

std::vector<std::size_t> jointsAbove(const Robot& robot, std::size_t link) {
  std::vector<std::size_t> result;
  for (std::size_t i = robot.joints.size(); i-- > 0;) {
    if (robot.joints[i].child != link) continue;
    result.push_back(i);
    link = robot.joints[i].parent;
  }
  return result;
}

}  // namespace link_bounds
