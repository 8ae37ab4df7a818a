// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is measured: meshes of robots, scanned models, and made-up extremes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "link_bounds/point_set.h"
#include "link_bounds/triangle_mesh.h"

namespace link_bounds::bench {

struct Mesh {
  std::string name;
  std::string kind;   ///< robot, model or synthetic
  TriangleMesh mesh;  ///< welded
  std::shared_ptr<const PointSet> points;
};

/// Those below the folder of test data; without it (""), the demo robot's and synthetic ones. A few
/// of each kind if `quick`.
std::vector<Mesh> loadMeshes(const std::string& data_folder, const std::string& demo_folder,
                             bool quick);

}  // namespace link_bounds::bench
