// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// From the mesh URI of a URDF to a file that is safe to open.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "link_bounds/geometry/parts/triangle_mesh.h"
#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// The folder of a ROS package, or "" if there is no such package. May throw MeshError with a
/// better reason and remedy.
using PackagePath = std::function<std::string(const std::string& package)>;

/// An existing regular file.
struct MeshFile {
  std::string path;  ///< absolute, without symbolic links
  std::string root;  ///< folder below which the mesh may name further files; absolute, real
};

/// Whether a path is that of the folder or leads into it; both absolute, without symbolic links.
bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& path);

/// Accepts package://PACKAGE/PATH, whose real path must lie below the package, and
/// file:///PATH. With a base folder also plain paths, relative to it. Percent-escapes in URIs
/// stand for the byte they name ("%20" is a space); spaces may also be written as they are.
/// Throws MeshError with reason and remedy for everything else, and for what is no regular file.
MeshFile resolveMeshUri(const std::string& uri, const PackagePath& package_path,
                        const std::string& base_folder = "");

}  // namespace link_bounds
