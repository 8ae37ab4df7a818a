// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where ROS keeps its packages.
#pragma once

#include <string>

namespace link_bounds {

/// The folder of a package, or "" if ROS knows none of that name. A PackagePath.
std::string rosPackagePath(const std::string& package);

}  // namespace link_bounds
