// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which other files a glTF text gets its geometry from.
#pragma once

#include <string>
#include <vector>

namespace link_bounds {

/// Of a `.gltf`, its own path and then what its URIs may name, with and without %20 and the like
/// decoded; data URIs name nothing. Of any other file its own path.
std::vector<std::string> filesOf(const std::string& path);

}  // namespace link_bounds
