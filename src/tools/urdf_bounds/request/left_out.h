// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Links that no verdict is about, although they have geometry.
#pragma once

#include <string>

#include "link_bounds/robot/robot_loader.h"

namespace link_bounds {

/// Names the links that have geometry of the other kind only, or is empty.
std::string leftOutNote(const Robot& robot, const Selection& selection);

}  // namespace link_bounds
