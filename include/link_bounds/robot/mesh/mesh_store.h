// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Mesh files become points here, each file once.
#pragma once

#include <time.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/geometry/parts/triangle_mesh.h"
#include "link_bounds/geometry/support/point_set.h"
#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

/// Reads a mesh file, in metres as rviz draws it. Throws MeshError. Called from several threads.
using MeshImporter = std::function<TriangleMesh(const MeshFile& file)>;

/// Told after each file: how many of how many are done. Calls do not overlap.
using LoadProgress = std::function<void(std::size_t done, std::size_t total)>;

/// What became of a file: points, or the reason why there are none, and the remedy.
struct LoadedMesh {
  std::shared_ptr<const PointSet> points;
  std::string error;
  std::shared_ptr<const TriangleMesh> triangles = nullptr;  ///< only if they were asked for
};

/// What is wanted of a mesh file.
enum class MeshContent { kPoints, kPointsAndTriangles };

/// Keeps what has been imported for as long as somebody uses it, keyed by real path, so that any
/// number of links and scales share one geometry. Failures are remembered until forgetFailures().
/// A file that loaded and was then replaced on disk is read anew by the next load(); one that
/// changes while it is read is refused. Triangles are not kept: who wants them causes an import.
/// Not thread-safe itself; what it hands out is immutable.
class MeshStore {
 public:
  explicit MeshStore(MeshImporter importer, MeshRemedy remedy = plainRemedy)
      : importer_(std::move(importer)), remedy_(std::move(remedy)) {}

  /// One result per file, in order. New files are imported side by side on the cores there are.
  std::vector<LoadedMesh> load(const std::vector<MeshFile>& files,
                               const LoadProgress& progress = nullptr,
                               MeshContent content = MeshContent::kPoints);

  void forgetFailures();

 private:
  /// Changes whenever the file is written or replaced. `changed` is the kernel's own time, which
  /// no program sets; `written` is the one that cp -p and tar restore.
  struct Version {
    std::uintmax_t device = 0;
    std::uintmax_t inode = 0;
    std::uintmax_t size = 0;
    timespec written{};
    timespec changed{};
    bool operator==(const Version& other) const;
  };
  struct Entry {
    Version version;
    std::weak_ptr<const PointSet> points;
    std::string error;
  };
  struct Imported {
    Version version;
    LoadedMesh mesh;
  };

  static Version versionOf(const std::string& path);
  static Version settledVersionOf(const std::string& path);
  LoadedMesh known(const MeshFile& file) const;
  LoadedMesh import(const MeshFile& file, const Version& version, MeshContent content) const;
  LoadedMesh failure(const char* reason, MeshFault fault) const noexcept;
  std::map<std::string, Imported> importAll(const std::map<std::string, MeshFile>& files,
                                            const LoadProgress& progress,
                                            MeshContent content) const;

  MeshImporter importer_;
  MeshRemedy remedy_;
  std::map<std::string, Entry> entries_;
};

}  // namespace link_bounds
