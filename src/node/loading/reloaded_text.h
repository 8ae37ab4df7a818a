// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The answer of a ~reload that succeeded.
#pragma once

#include <string>
#include <vector>

namespace link_bounds {

/// With the first of its warnings, in one line.
std::string reloadedText(const std::vector<std::string>& warnings);

}  // namespace link_bounds
