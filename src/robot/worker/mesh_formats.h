// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The formats of meshes that are read. Assimp knows many more; of those nobody has looked up what
// its readers leave out without a message.
#pragma once

#include <assimp/Importer.hpp>
#include <string>

#include "robot/worker/confined_files.h"

namespace link_bounds {

/// Takes all readers but those of the file's format out of the importer. Throws MeshError where the
/// format is none of those above, and for what assimp would leave out of the file or misread: words
/// that are numbers only in part, vertices and faces of OBJ that it skips, wrong indices, triangle
/// strips of PLY, faces of many corners of OFF, extensions of glTF that move vertices, units and
/// accessors of Collada; and for texts, and PLY, that hold less or more than their header says.
void checkFormat(Assimp::Importer& importer, ConfinedFiles& files, const std::string& path);

}  // namespace link_bounds
