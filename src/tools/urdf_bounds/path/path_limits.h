// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints that leave their limits on a path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/posed/joint_motion.h"

namespace link_bounds {

/// What the user calls the row of that index.
using RowName = std::function<std::string(std::size_t row)>;

/// Of each joint that leaves its limits between two rows that keep them, the first time, in words.
/// Motion i leads from row i to the next one; `simple` has simple joints.
std::vector<std::string> overshoots(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name);

/// Of each joint that is beyond its limits in a row, the first one, in words.
std::vector<std::string> rowsBeyond(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name);

}  // namespace link_bounds
