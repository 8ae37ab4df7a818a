// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes that markers name, by the same rules and through the same store as those of links.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

/// One result per URI, in order; an error names the file and the remedy. Whatever goes wrong
/// becomes such an error.
std::vector<LoadedMesh> loadObjectMeshes(const std::vector<std::string>& uris,
                                         const PackagePath& package_path, MeshStore& store);

}  // namespace link_bounds
