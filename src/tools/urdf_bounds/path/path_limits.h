// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints that are within their limits in all rows, but not between them.
#pragma once

#include <string>
#include <vector>

#include "robot/posed/joint_motion.h"

namespace link_bounds {

/// Of each joint that leaves its limits between two rows that keep them, the first time, in words
/// that begin with `file`. Motion i leads from row i to the next one; `simple` has simple joints.
std::vector<std::string> overshoots(const std::string& file, const Robot& simple,
                                    const std::vector<JointMotion>& motions);

}  // namespace link_bounds
