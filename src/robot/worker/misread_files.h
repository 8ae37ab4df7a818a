// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What assimp reads without a word, but wrong.
#pragma once

#include <string>

#include "robot/worker/confined_files.h"

namespace link_bounds {

/// Throws MeshError for what assimp leaves out: triangle strips of PLY, faces of many corners of
/// OFF, extensions of glTF that move vertices; for Collada that reads beyond an array; and for a
/// text in PLY or OFF that has fewer lines than its header says, or fewer corners than a face says.
void refuseMisread(ConfinedFiles& files, const std::string& path);

}  // namespace link_bounds
