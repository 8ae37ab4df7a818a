// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Every few of the meshes with a table.
#include "bench/pipeline/shared_meshes.h"

#include <algorithm>

#include "bench/common/mesh_choice.h"
#include "geometry/support/table/direction_table.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kSharedMeshes = 16;

}  // namespace

MeasuredMeshes sharedMeshes(bool quick) {
  MeasuredMeshes meshes = chooseMeshes(quick);
  const auto end = std::remove_if(meshes.begin(), meshes.end(), [](const MeasuredMesh& mesh) {
    return mesh.kind != "robot" || mesh.points->size() <= kScannedPoints;
  });
  meshes.erase(end, meshes.end());
  const std::size_t wanted = std::min(meshes.size(), kSharedMeshes);
  MeasuredMeshes chosen;
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(std::move(meshes[i * meshes.size() / wanted]));
  return chosen;
}

}  // namespace link_bounds::bench
