// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// File access for assimp that cannot leave the mesh's folder or package.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <cstdint>
#include <string>

namespace link_bounds {

/// Opens for reading only, and only regular files whose real path lies below `root`: a mesh may
/// name any file of the machine as its material or buffer. Each may have `max_bytes` when it is
/// opened.
class ConfinedFiles : public Assimp::DefaultIOSystem {
 public:
  ConfinedFiles(std::string root, std::uint64_t max_bytes)
      : root_(std::move(root)), max_bytes_(max_bytes) {}

  bool Exists(const char* path) const override;
  Assimp::IOStream* Open(const char* path, const char* mode) override;
  void Close(Assimp::IOStream* file) override;

 private:
  std::string root_;
  std::uint64_t max_bytes_;
};

}  // namespace link_bounds
