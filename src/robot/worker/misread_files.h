// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Refuses files that assimp misreads without a message.
#pragma once

#include <string>

#include "robot/worker/confined_files.h"

namespace link_bounds {

/// Throws MeshError for what assimp leaves out or misreads: words that are numbers only in part,
/// vertices and faces of OBJ that it skips, wrong indices, triangle strips of PLY, faces of many
/// corners of OFF, extensions of glTF that move vertices, units and accessors of Collada; and for
/// texts, and PLY, that hold less or more than their header says.
void refuseMisread(ConfinedFiles& files, const std::string& path);

}  // namespace link_bounds
