// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Resolves all URIs, then loads what could be resolved in one go.
#include "node/loading/object_meshes.h"

#include <exception>
#include <new>

#include "node/loading/mesh_remedy.h"

namespace link_bounds {
namespace {

std::string unexpectedReason(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) {
    return "it does not fit into memory; " + nodeRemedy(MeshFault::kComputer);
  }
  return std::string("unexpected: ") + error.what() + "; call ~reload";
}

std::vector<LoadedMesh> load(const std::vector<std::string>& uris, const PackagePath& package_path,
                             MeshStore& store) {
  std::vector<LoadedMesh> results(uris.size());
  std::vector<MeshFile> files;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < uris.size(); ++i) {
    try {
      files.push_back(resolveMeshUri(uris[i], package_path));
      places.push_back(i);
    } catch (const MeshError& error) {
      results[i].error = error.what();
    } catch (const std::exception& error) {
      results[i].error = unexpectedReason(error);
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

}  // namespace

std::vector<LoadedMesh> loadObjectMeshes(const std::vector<std::string>& uris,
                                         const PackagePath& package_path, MeshStore& store) {
  try {
    return load(uris, package_path, store);
  } catch (const std::exception& error) {
    return {uris.size(), LoadedMesh{nullptr, unexpectedReason(error)}};
  }
}

}  // namespace link_bounds
