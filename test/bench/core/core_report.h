// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The results for people.
#pragma once

#include <string>

#include "bench/common/result.h"

namespace link_bounds::bench {

/// One row per mesh and one column per method, in ns per box; then medians over the robot meshes,
/// and the cost per link. `ours` is the method that the others are compared with.
void printCoreTables(const Results& results, const std::string& ours);

/// What was promised, and whether it holds. `ours` counts where a target names no method.
void printCoreTargets(const Results& results, const std::string& ours);

}  // namespace link_bounds::bench
