// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// --each: a line per bag, several bags at once.
#pragma once

#include "tools/bag_bounds/run/bag_question.h"

namespace link_bounds {

/// Writes the lines to standard output as the bags are done. Returns the worst exit code, that of
/// lines of --resume included. Each bag is read by a process of its own, which begins with the same
/// memory: no bag has influence on another one, not even by a crash. Throws std::exception.
int runEach(const BagBoundsOptions& options, BagQuestion& question);

}  // namespace link_bounds
