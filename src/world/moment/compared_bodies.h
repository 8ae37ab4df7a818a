// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which bodies are compared at all.
#pragma once

#include <vector>

#include "link_bounds/geometry/pairs/sweep_and_prune.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// Of each body of the moment, whether the rule of pairs compares it with any other one. `pairs`
/// are some that it compares.
std::vector<bool> areCompared(const Moment& moment, const std::vector<BoxPair>& pairs);

}  // namespace link_bounds
