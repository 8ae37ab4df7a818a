// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Max rounding errors, for the pads of bounds.
#pragma once

namespace link_bounds {

/// Relative to the lengths of a chain and the coordinates of a body: covers products of poses, each
/// exact to some 1e-15, and the 1e-14 that a PointSet may leave out.
constexpr double kPoseRounding = 1e-12;

/// Relative to the result of a formula, or to the terms of a sum: each operation rounds by 1e-16.
constexpr double kFormulaRounding = 1e-14;

/// Unit roundoffs per joint, relative to the lengths that it moves: more than the 20 or so
/// operations on each of them; derived in reach_bound.h.
constexpr double kRoundoffsPerJoint = 256;

}  // namespace link_bounds
