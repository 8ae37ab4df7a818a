// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the bodies that are compared with any other body.
#pragma once

#include <vector>

#include "link_bounds/geometry/pairs/sweep_and_prune.h"
#include "world/moment/moment.h"

namespace link_bounds {

/// For each body of the moment: whether isPair() holds for it and any other body. `pairs` are some
/// pairs that are known to be compared.
std::vector<bool> areCompared(const Moment& moment, const std::vector<BoxPair>& pairs);

}  // namespace link_bounds
