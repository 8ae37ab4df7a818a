// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The triangles of a mesh file, and the files that they came from.
#pragma once

#include <time.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "link_bounds/geometry/mesh/triangle_mesh.h"

namespace link_bounds {

/// Changes whenever a file is written or replaced. All 0: there is no regular file. cp -p and tar
/// can restore an old `written`, but only the kernel sets `changed`.
struct FileVersion {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;  ///< bytes
  timespec written{};      ///< st_mtim
  timespec changed{};      ///< st_ctim

  bool operator==(const FileVersion& other) const;
};

/// Follows symbolic links.
FileVersion fileVersion(const std::string& path);

/// Versions of files, by path.
using FileVersions = std::map<std::string, FileVersion>;

struct ImportedMesh : TriangleMesh {
  /// Without files: for a reader that opens only the mesh file itself.
  ImportedMesh(TriangleMesh mesh, FileVersions its_files = {})  // NOLINT: readers may return a mesh
      : TriangleMesh(std::move(mesh)), files(std::move(its_files)) {}

  /// The files that the reader opened, or looked for in vain, with their versions: buffers of a
  /// glTF, materials of an OBJ, objects of a scene. The mesh itself need not be among them.
  FileVersions files;
};

}  // namespace link_bounds
