// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The work of RobotLoader::load, on its store.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"

namespace link_bounds {

/// Selects links and loads their meshes through the store. Bad geometry makes its link incomplete.
BoundedRobot boundRobot(const Robot& robot, const Selection& selection, const MeshSource& source,
                        MeshStore& store, const MeshRemedy& remedy);

/// BoundedRobot::problems, then body_problems.
std::vector<std::string> allProblems(const BoundedRobot& robot);

/// A note for the user that names the selected links that have geometry of the other kind only; ""
/// if there are none.
std::string leftOutNote(const Robot& robot, const Selection& selection);

/// The message for the user that distances take the convex hull of a mesh, and why; `error` is
/// LoadedMesh::tree_error.
std::string treeProblem(const std::string& path, const std::string& error);

}  // namespace link_bounds
