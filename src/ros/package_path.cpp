// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks rospack itself: ros::package::getPath takes a name for command line options and prints to
// standard error what it does not find.
#include "package_path.h"

#include <rospack/rospack.h>

#include <memory>
#include <vector>

namespace link_bounds {

PackagePath rosPackages() {
  const auto rospack = std::make_shared<std::unique_ptr<rospack::Rospack>>();
  return [rospack](const std::string& package) -> std::string {
    if (!*rospack) {
      *rospack = std::make_unique<rospack::Rospack>();
      (*rospack)->setQuiet(true);
      std::vector<std::string> search_path;
      (*rospack)->getSearchPathFromEnv(search_path);
      (*rospack)->crawl(search_path, false);
    }
    std::string folder;
    return (*rospack)->find(package, folder) ? folder : "";
  };
}

}  // namespace link_bounds
