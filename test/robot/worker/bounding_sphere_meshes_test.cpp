// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounding spheres of mesh files against Welzl's smallest sphere.
#include <filesystem>

#include "robot/worker/mesh_import.h"
#include "testing/smallest_sphere.h"

namespace link_bounds {
namespace {

TEST(BoundingSphere, OfMeshFilesIsTheSmallest) {
  const auto folder = std::filesystem::canonical("../launch/demo/meshes");
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".mtl") continue;
    SCOPED_TRACE(entry.path().string());
    expectSmallest(importMesh({entry.path().string(), folder.string()}).vertices);
    ++count;
  }
  EXPECT_GT(count, 2);
}

}  // namespace
}  // namespace link_bounds
