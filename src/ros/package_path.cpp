// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The only caller of ros::package.
#include "package_path.h"

#include <ros/package.h>

namespace link_bounds {

std::string rosPackagePath(const std::string& package) {
  return ros::package::getPath(package);
}

}  // namespace link_bounds
