// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the node says to --help.
#pragma once

#include <string>

namespace link_bounds {

/// Topics, service and parameters with types, defaults and meanings, one per line as in the
/// README's tables.
std::string usage();

}  // namespace link_bounds
