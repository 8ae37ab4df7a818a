// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The results as one table, as ratios against what was promised, and as JSON.
#pragma once

#include <iosfwd>
#include <vector>

#include "core_suite.h"

namespace link_bounds::bench {

double median(std::vector<double> values);

void printTable(const std::vector<Case>& rows, std::ostream& out);
void printTargets(const std::vector<Case>& rows, std::ostream& out);
void writeJson(const std::vector<Case>& rows, std::ostream& out);

}  // namespace link_bounds::bench
