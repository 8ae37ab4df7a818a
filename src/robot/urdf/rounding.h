// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What rounding may add to a bound.
#pragma once

namespace link_bounds {

/// Of the lengths of a chain and the coordinates of a body: products of poses, each exact to some
/// 1e-15, and the 1e-14 that a PointSet may leave out.
constexpr double kPoseRounding = 1e-12;

/// Of the result of a formula, or of the terms of a sum: each operation rounds by 1e-16.
constexpr double kFormulaRounding = 1e-14;

/// Unit roundoffs per joint, of the lengths that it moves: more than the some 20 operations on
/// each; derived in reach_bound.h.
constexpr double kRoundoffsPerJoint = 256;

}  // namespace link_bounds
