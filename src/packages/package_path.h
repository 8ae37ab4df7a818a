// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The folders of ROS packages.
#pragma once

#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

/// Finds packages along ROS_PACKAGE_PATH, as rospack does. An unreadable manifest affects no other
/// package. The first call of the returned function searches the path and keeps the result, so call
/// rosPackages() again to find new packages. Any number of threads may call the returned function.
PackagePath rosPackages();

}  // namespace link_bounds
