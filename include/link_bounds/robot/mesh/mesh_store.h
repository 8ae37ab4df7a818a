// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The points of mesh files; each file is read once and shared.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body.h"
#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "link_bounds/geometry/support/point_set.h"
#include "link_bounds/robot/mesh/imported_mesh.h"
#include "link_bounds/robot/mesh/mesh_limits.h"
#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

/// Reads a mesh file, in metres as rviz draws it. Throws MeshError. Called from several threads.
/// The vertices of the mesh are finite, its indices are in range, and it has triangles. It may
/// return a TriangleMesh if it opens no other file.
using MeshImporter = std::function<ImportedMesh(const MeshFile& file)>;

/// The same within limits; an exception of `deadline` is passed on.
using TimedMeshImporter = std::function<ImportedMesh(const MeshFile& file, const MeshLimits& limits,
                                                     const CheckInterrupt& deadline)>;

/// Called after each file that was read, by one thread at a time.
using LoadProgress = std::function<void(std::size_t done, std::size_t total)>;

struct LoadedMesh {
  std::shared_ptr<const PointSet> points;  ///< null if the file cannot be used
  std::string error;                       ///< the reason and the remedy; "" if there are points
  std::shared_ptr<const TriangleMesh> triangles = nullptr;  ///< only if they were requested
  std::shared_ptr<const TriangleTree> tree = nullptr;       ///< only if it was requested
  /// Why there are points but not the tree that was requested, and the remedy; else "".
  std::string tree_error = "";
  bool is_cancelled = false;  ///< loading was cancelled, which says nothing about the file
};

/// kAll: points, triangles and tree.
enum class MeshContent { kPoints, kPointsAndTriangles, kPointsAndTree, kAll };

/// A cache by real path, so that all links with the same mesh share its points, at any scale. It
/// does not keep points alive: an entry is valid as long as somebody else uses its points. Failures
/// are remembered until forgetFailures(), but not those of loads that began before it. Dead entries
/// are erased by forgetFailures(), and when there are very many. load() reads a file again if it,
/// or another one that its importer opened or looked for, was replaced since, and refuses one that
/// changes while it is read. Triangles and trees are not cached; if reading them fails, points in
/// use stay in use. Any number of threads may use a store; what it returns is immutable.
class MeshStore {
 public:
  explicit MeshStore(MeshImporter importer, MeshRemedy remedy = plainRemedy)
      : MeshStore(
            [importer = std::move(importer)](const MeshFile& file, const MeshLimits&,
                                             const CheckInterrupt&) { return importer(file); },
            std::move(remedy)) {}
  explicit MeshStore(TimedMeshImporter importer, MeshRemedy remedy = plainRemedy);

  /// One result per file, in order. Files are read in parallel, one thread per core, and each
  /// becomes a tree before its thread reads the next. Reading a file and preparing what `content`
  /// names takes at most `limits.timeout`, and ends early if `is_cancelled`, which may be null and
  /// is called from several threads. A tree takes at most `limits.max_bytes`.
  std::vector<LoadedMesh> load(const std::vector<MeshFile>& files,
                               const LoadProgress& progress = nullptr,
                               MeshContent content = MeshContent::kPoints,
                               const MeshLimits& limits = {},
                               const std::function<bool()>& is_cancelled = nullptr);

  /// The points of the file, if they are in use and the file has not changed since it was read;
  /// else null.
  std::shared_ptr<const PointSet> find(const MeshFile& file) const { return cached(file).points; }

  /// The next load() tries files that failed again.
  void forgetFailures();

 private:
  struct Entry {
    /// Includes the mesh file itself.
    std::shared_ptr<const FileVersions> files;
    std::weak_ptr<const PointSet> points;
    std::string error;
  };
  struct Request {
    MeshContent content;
    MeshLimits limits;
    std::function<bool()> is_cancelled;
    std::uint64_t generation;
  };

  LoadedMesh cached(const MeshFile& file) const;
  LoadedMesh import(const MeshFile& file, const Request& request, FileVersions& files) const;
  void addTree(const TriangleMesh& mesh, const Request& request, const CheckInterrupt& deadline,
               LoadedMesh& result) const;
  LoadedMesh failure(const char* reason, MeshFault fault) const noexcept;
  LoadedMesh importAndRemember(const MeshFile& file, const Request& request);
  void remember(const MeshFile& file, FileVersions files, const Request& request, LoadedMesh& mesh);
  std::uint64_t generation() const;

  TimedMeshImporter importer_;
  MeshRemedy remedy_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;  ///< guarded by mutex_; by path and root
  std::size_t max_entries_;               ///< guarded by mutex_; before dead ones are erased
  std::uint64_t generation_ = 0;          ///< guarded by mutex_; changes with forgetFailures()
};

}  // namespace link_bounds
