// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From a mesh file to triangles, by assimp.
#pragma once

#include <cstdint>
#include <functional>

#include "link_bounds/robot/worker/mesh_process.h"

namespace link_bounds {

/// Gets the sum of the sizes of all files of a mesh that have been opened.
using BytesHandler = std::function<void(std::uint64_t bytes)>;

/// Reads any format assimp knows, in metres, exactly as rviz 1.14 draws it: node transforms and
/// Collada's <unit> count, the rotation of the root node (Collada's <up_axis>) does not. Vertices
/// are composed in double and rounded once to float32; only those of triangles count. Opens no file
/// outside `file.root`, and none of more than `max_bytes`; calls `on_bytes`, which may be null,
/// before it reads a further one. Returns which files it opened or looked for, by absolute path,
/// and refuses a mesh one of whose files changes meanwhile. Throws MeshError, and std::bad_alloc if
/// memory runs out. Only one thread at a time may call it: assimp has one log for the process.
ImportedMesh importMesh(const MeshFile& file, std::uint64_t max_bytes = MeshLimits().max_bytes,
                        const BytesHandler& on_bytes = nullptr);

}  // namespace link_bounds
