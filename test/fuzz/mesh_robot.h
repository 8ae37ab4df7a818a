// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot with one mesh file per link, loaded as the node loads it, by mesh_worker.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/geometry/shape/bounded_link.h"

namespace link_bounds {

struct MeshRobot {
  std::vector<BoundedLink> links;              ///< one per file, in order, with its name
  std::map<std::string, TriangleMesh> meshes;  ///< what mesh_worker read, by file
};

/// Loads the files as the node does, without XML. They lie in `folder`. The timeout of the first is
/// the default, that of the others `timeout` wall seconds each.
MeshRobot meshRobot(const std::string& folder, const std::vector<std::string>& files,
                    double timeout);

}  // namespace link_bounds
