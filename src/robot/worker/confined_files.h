// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// File access for assimp, confined to the folder or package of the mesh.
#pragma once

#include <sys/stat.h>

#include <assimp/IOSystem.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "robot/mesh/file_versions.h"
#include "robot/worker/mesh_import.h"

namespace link_bounds {

/// Opens for reading only, and only regular files whose real path lies below the mesh's root,
/// because a mesh may name any file of the machine as its material or buffer. Refuses files that
/// have more than `max_bytes` when they are opened. Remembers which files were opened or looked
/// for.
class ConfinedFiles : public Assimp::IOSystem {
 public:
  /// `on_bytes` may be null. It is called before each file is read, with the sum of the sizes of
  /// all files opened so far and this one.
  ConfinedFiles(const MeshFile& mesh, std::uint64_t max_bytes, BytesHandler on_bytes);

  /// Why a file was not opened: it is too large, or this user may not read it; else nothing.
  const std::optional<MeshError>& refusal() const { return refusal_; }

  /// By absolute path, each as it was when it was first opened or looked for.
  const FileVersions& files() const { return files_; }

  bool Exists(const char* path) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* file) override;

 private:
  int openForReading(const std::string& path) const;
  int openAndNote(const std::string& path) const;
  bool mayBeRead(const char* path, const struct stat& status);

  std::string root_;
  std::string folder_;  ///< of the mesh, with a slash at its end; assimp's names begin with it
  std::uint64_t max_bytes_;
  BytesHandler on_bytes_;
  // Mutable, as assimp wants Exists() to be const.
  mutable std::optional<MeshError> refusal_;
  mutable FileVersions files_;
  mutable int ticks_left_ = kMaxFileTicks;  ///< for all files together
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t>
      bytes_;  ///< sizes by device and inode
};

}  // namespace link_bounds
