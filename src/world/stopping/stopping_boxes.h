// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes around all that links and objects can reach until the robot stands.
#pragma once

#include "world/stopping/body_ways.h"

namespace link_bounds {

/// `scene` is a copy for wayRequest(); `rules` are those of its model; `states` may be null. An
/// object moves with the link that it follows or is attached to; other objects stay in place.
WayBoxes stoppingBoxes(PastScene& scene, const StopRules& rules,
                       const JointStates* states = nullptr);

}  // namespace link_bounds
