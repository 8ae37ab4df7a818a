// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes around all that links and objects can reach until the robot stands.
#pragma once

#include "world/stopping/body_ways.h"

namespace link_bounds {

/// Of a copy that wayRequest() asked for. The rules are those of its model; `states` may be null.
/// An object moves with the link that it follows or is attached to; others stay where they are.
WayBoxes stoppingBoxes(PastScene& scene, const StopRules& rules,
                       const JointStates* states = nullptr);

}  // namespace link_bounds
