// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes around all that links and objects can reach until the robot stands.
#pragma once

#include <memory>
#include <string>

#include "world/history/past_scene.h"
#include "world/moment/moment.h"
#include "world/stopping/stop_rules.h"

namespace link_bounds {

/// What a copy of the scene must have.
BoxRequest stoppingRequest(const Parameters& parameters);

struct StoppingBoxes {
  std::shared_ptr<const Moment> moment;  ///< in the order of ~boxes
  std::string problem;  ///< why the first incomplete body is that, and how many more are
};

/// Of a copy that stoppingRequest() asked for. The rules are those of its model. Stamps are those
/// of ~boxes. An object moves with the link that it follows or is attached to; others stay where
/// they are.
StoppingBoxes stoppingBoxes(PastScene& scene, const StopRules& rules);

}  // namespace link_bounds
