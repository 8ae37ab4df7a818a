// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// From the mesh URI of a URDF to a file that is safe to open.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// Returns the folder of a ROS package, or "" if there is none. May throw MeshError with a more
/// exact reason and its remedy.
using PackagePath = std::function<std::string(const std::string& package)>;

/// An existing regular file.
struct MeshFile {
  std::string path;  ///< absolute, without symbolic links
  std::string root;  ///< the mesh may name further files below this folder; absolute, real
};

/// Whether the path is the folder or lies in it; both absolute, without symbolic links.
bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& path);

/// Accepts package://PACKAGE/PATH, whose real path must lie below the package, and file:///PATH;
/// with a base folder also plain paths, relative to it. Percent-escapes are decoded ("%20" is a
/// space), and a space may also stand for itself. Throws MeshError with reason and remedy for
/// everything else, and if the path is not a regular file.
MeshFile resolveMeshUri(const std::string& uri, const PackagePath& package_path,
                        const std::string& base_folder = "");

}  // namespace link_bounds
