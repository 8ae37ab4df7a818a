// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which other files a glTF gets its geometry from.
#pragma once

#include <string>
#include <vector>

namespace link_bounds {

/// The file's own path; and of a glTF, text or binary and under any name, also what assimp may open
/// for its URIs. Data URIs name nothing.
std::vector<std::string> filesOf(const std::string& path);

}  // namespace link_bounds
