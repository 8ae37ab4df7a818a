// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes for loaders that ask from several threads.
#pragma once

#include <iostream>
#include <mutex>

#include "link_bounds/robot/robot_loader.h"
#include "robot/worker/mesh_import.h"

namespace link_bounds {

/// Assimp serves one thread at a time.
inline TriangleMesh importAlone(const MeshFile& mesh) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return importMesh(mesh);
}

/// Meshes are read in this process.
inline LoadedRobot loadedAlone(const Robot& robot, const PackagePath& package_path,
                               const Selection& selection = {}) {
  LoadedRobot loaded{robot, RobotLoader(importAlone).load(robot, selection, {package_path})};
  for (const std::string& problem : loaded.bounded.problems)
    std::cout << "left out: " << problem << "\n";
  return loaded;
}

/// Of what proofs are made.
inline Selection collisionTriangles() {
  Selection selection;
  selection.visual = false;
  selection.collision = selection.triangles = true;
  return selection;
}

}  // namespace link_bounds
