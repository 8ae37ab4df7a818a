// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/mesh/mesh_files.h"

#include <set>

namespace link_bounds {

std::vector<std::string> meshFiles(const Robot& robot, const PackagePath& package_path,
                                   const std::string& base_folder) {
  std::set<std::string> uris;
  for (const Link& link : robot.links) {
    for (const Element& element : link.elements)
      uris.insert(element.mesh_uri);
  }
  std::vector<std::string> files;
  for (const std::string& uri : uris) {
    try {
      files.push_back(resolveMeshUri(uri, package_path, base_folder).path);
    } catch (const MeshError&) {
      // There is no such file.
    }
  }
  return files;
}

}  // namespace link_bounds
