// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings about joint values and limits that look like mistakes. Robots must have simple joints,
// see withSimpleJoints().
#pragma once

#include <string>

#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// True if the value is beyond the limits by more than the rounding of a computed value.
bool isBeyond(const Limits& limits, double value);

/// The ranges and values beyond the limits of their joints, in words; "" if none is.
std::string beyondLimits(const Robot& robot, const GivenRanges& given);

/// The joints without a given range whose limits are equal, in words; "" if there is none. A
/// <limit> without lower and upper means 0 and 0, which its author may not have meant.
std::string equalLimits(const Robot& robot, const GivenRanges& given);

}  // namespace link_bounds
