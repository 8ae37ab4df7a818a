// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that prove that two bodies touch. A solid is no surface: its core is a body whose points
// are each the centre of a ball that lies in the solid.
#pragma once

#include <optional>

#include "link_bounds/geometry/distance/body_distance.h"
#include "robot/pairs/pair_body.h"

namespace link_bounds {

/// A point of the core of one body that is within `reach` [m] and the skin of that core of a point
/// of the other body. In the frame of the first one; nothing if there are no two such points.
std::optional<BodyDistance> coreContact(const PairBody& first, const PairBody& second,
                                        const Eigen::Affine3d& first_from_second, double reach);

}  // namespace link_bounds
