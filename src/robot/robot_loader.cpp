// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The store with mesh_worker as its importer.
#include "link_bounds/robot/robot_loader.h"

#include <new>

#include "robot/bounded_robot.h"
#include "robot/mesh/weld.h"

namespace link_bounds {

RobotLoader::RobotLoader(MeshRemedy remedy)
    : remedy_(std::move(remedy)),
      store_(
          [worker = meshWorker()](const MeshFile& file, const MeshLimits& limits,
                                  const CheckInterrupt& deadline) {
            return importInTime(worker, file, limits, deadline);
          },
          remedy_) {}

RobotLoader::RobotLoader(MeshImporter importer, MeshRemedy remedy)
    : remedy_(std::move(remedy)),
      store_(
          [importer = std::move(importer)](const MeshFile& file) {
            ImportedMesh mesh = importer(file);
            checkTriangles(mesh);
            return mesh;
          },
          remedy_) {}

BoundedRobot RobotLoader::load(const Robot& robot, const Selection& selection,
                               const MeshSource& source) {
  return boundRobot(robot, selection, source, store_, remedy_);
}

std::vector<LoadedMesh> RobotLoader::loadMeshes(const std::vector<std::string>& uris,
                                                const MeshSource& source) {
  return loadAll(uris, source, MeshContent::kPoints);
}

std::vector<LoadedTree> RobotLoader::loadTrees(const std::vector<std::string>& uris,
                                               const MeshSource& source) {
  std::vector<LoadedTree> trees;
  for (LoadedMesh& mesh : loadAll(uris, source, MeshContent::kPointsAndTree))
    trees.push_back(
        {std::move(mesh.points), std::move(mesh.tree), std::move(mesh.error), mesh.is_cancelled});
  return trees;
}

std::shared_ptr<const PointSet> RobotLoader::find(const std::string& uri,
                                                  const MeshSource& source) const {
  try {
    return store_.find(resolveMeshUri(uri, source.package_path, source.base_folder));
  } catch (const std::exception&) {  // package_path may throw any
    return nullptr;
  }
}

std::vector<LoadedMesh> RobotLoader::loadAll(const std::vector<std::string>& uris,
                                             const MeshSource& source, MeshContent content) {
  try {
    return loadResolved(uris, source, content);
  } catch (const std::exception& error) {
    return {uris.size(), LoadedMesh{nullptr, wording(error)}};
  }
}

/// Resolves all URIs first, so that the files load side by side.
std::vector<LoadedMesh> RobotLoader::loadResolved(const std::vector<std::string>& uris,
                                                  const MeshSource& source, MeshContent content) {
  std::vector<LoadedMesh> results(uris.size());
  std::vector<MeshFile> files;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < uris.size(); ++i) {
    try {
      files.push_back(resolveMeshUri(uris[i], source.package_path, source.base_folder));
      places.push_back(i);
    } catch (const std::exception& error) {
      results[i].error = wording(error);
    }
  }
  const std::vector<LoadedMesh> loaded =
      store_.load(files, source.progress, content, source.limits, source.is_cancelled);
  for (std::size_t i = 0; i < files.size(); ++i) {
    LoadedMesh& result = results[places[i]];
    result = loaded[i];
    if (!result.points) result.error = "cannot use " + files[i].path + ": " + result.error;
    if (!result.tree_error.empty()) result.error = treeProblem(files[i].path, result.tree_error);
  }
  return results;
}

/// The error in words for the user. Reasons of resolveMeshUri contain their remedy.
std::string RobotLoader::wording(const std::exception& error) const {
  if (dynamic_cast<const MeshError*>(&error)) return error.what();
  if (dynamic_cast<const std::bad_alloc*>(&error)) {
    return "it does not fit into memory; " + remedy_(MeshFault::kComputer);
  }
  return std::string("unexpected: ") + error.what() + "; " + remedy_(MeshFault::kCancelled);
}

LoadedRobot loadRobot(const std::string& urdf, const MeshSource& source,
                      const Selection& selection) {
  LoadedRobot result{parseRobot(urdf), {}};
  result.bounded = RobotLoader().load(result.robot, selection, source);
  return result;
}

}  // namespace link_bounds
