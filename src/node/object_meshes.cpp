// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Resolves all URIs, then loads what could be resolved in one go.
#include "object_meshes.h"

namespace link_bounds {

std::vector<LoadedMesh> loadObjectMeshes(const std::vector<std::string>& uris,
                                         const PackagePath& package_path, MeshStore& store) {
  std::vector<LoadedMesh> results(uris.size());
  std::vector<MeshFile> files;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < uris.size(); ++i) {
    try {
      files.push_back(resolveMeshUri(uris[i], package_path));
      places.push_back(i);
    } catch (const MeshError& error) {
      results[i].error = error.what();
    }
  }
  const std::vector<LoadedMesh> loaded = store.load(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    LoadedMesh& result = results[places[i]];
    result = loaded[i];
    if (!result.points) result.error = "cannot use " + files[i].path + ": " + result.error;
  }
  return results;
}

}  // namespace link_bounds
