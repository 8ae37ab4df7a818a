// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint values between bounds, and their halves.
#pragma once

#include <array>

#include "robot/pairs/joint_path.h"

namespace link_bounds {

/// Joint values: those of the variables of a path that differ from the centre by at most the half
/// widths.
struct JointBox {
  PathValues center;
  PathValues half_widths;
};

inline double width(const Limits& range) {
  return range.upper - range.lower;
}

/// All values of the path.
JointBox wholeBox(const JointPath& path);

/// The half with smaller values of the variable, and the other one.
std::array<JointBox, 2> halves(const JointBox& box, std::size_t variable);

/// Of the whole box.
double shareOf(const JointBox& box, const JointPath& path);

}  // namespace link_bounds
