// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh files that a robot names.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_uri.h"
#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The files of all elements, used or not. Files that do not exist are left out.
std::vector<std::string> meshFiles(const Robot& robot, const PackagePath& package_path,
                                   const std::string& base_folder);

}  // namespace link_bounds
