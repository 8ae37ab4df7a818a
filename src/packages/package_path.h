// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where ROS keeps its packages.
#pragma once

#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

/// Looks packages up along ROS_PACKAGE_PATH, as rospack does; a manifest that cannot be read harms
/// no other package. The path is searched once, at the first question, so take a new one for each
/// load. Not thread-safe.
PackagePath rosPackages();

}  // namespace link_bounds
