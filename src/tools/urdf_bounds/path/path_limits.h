// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints that leave their limits on a path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/posed/joint_motion.h"

namespace link_bounds {

/// The name of a row for the user; `row` is its index from 0.
using RowName = std::function<std::string(std::size_t row)>;

/// One message per joint that leaves its limits between two rows within them, about the first time.
/// Motion i leads from row i to row i + 1. `simple` has simple joints.
std::vector<std::string> overshoots(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name);

/// One message per joint that is beyond its limits in a row, about the first such row.
std::vector<std::string> rowsBeyond(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name);

}  // namespace link_bounds
