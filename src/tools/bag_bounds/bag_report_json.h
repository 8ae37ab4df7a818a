// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A report as JSON; doc/tools.md has the keys.
#pragma once

#include <ostream>

#include "tools/bag_bounds/bag_report.h"

namespace link_bounds {

void writeJson(const BagReport& report, std::ostream& out);

}  // namespace link_bounds
