// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes for loaders that ask from several threads.
#pragma once

#include <mutex>

#include "robot/worker/mesh_import.h"

namespace link_bounds {

/// Assimp serves one thread at a time.
inline TriangleMesh importAlone(const MeshFile& mesh) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return importMesh(mesh);
}

}  // namespace link_bounds
