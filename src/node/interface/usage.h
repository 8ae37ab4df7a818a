// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of --help.
#pragma once

#include <string>

namespace link_bounds {

/// Topics, services and parameters, one per line, with the cells of README's tables.
std::string usage();

}  // namespace link_bounds
