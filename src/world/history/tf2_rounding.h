// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What rounding can add to rotations that tf2 interpolates.
#pragma once

namespace link_bounds {

/// tf2 computes an angle from its cosine, which is wrong by a few 1e-16: the angle is then wrong by
/// less than this [rad].
constexpr double kAngleError = 1e-7;

/// Quaternions between the samples are longer than they should be by less than this.
constexpr double kLengthError = 1e-14;

}  // namespace link_bounds
