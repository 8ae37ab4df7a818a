// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A report as JSON; doc/tools.md has the keys.
#pragma once

#include <ostream>
#include <string>

#include "tools/bag_bounds/run/bag_report.h"

namespace link_bounds {

void writeJson(const BagReport& report, std::ostream& out);

/// The members of an object, on one line: the least covered link, the nearest pair, entries of
/// zones, what is incomplete.
std::string summaryJson(const BagReport& report);

}  // namespace link_bounds
