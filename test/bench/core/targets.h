// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What was promised, and whether it holds.
#pragma once

#include <string>

#include "bench/common/result.h"

namespace link_bounds::bench {

/// `ours` is the method that counts where a target names none.
void printCoreTargets(const Results& results, const std::string& ours);

}  // namespace link_bounds::bench
