// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The way from a link up to the root.
#pragma once

#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Indices of the joints from the link up to the root, that of the link first; none for the root.
std::vector<std::size_t> jointsAbove(const Robot& robot, std::size_t link);

}  // namespace link_bounds
